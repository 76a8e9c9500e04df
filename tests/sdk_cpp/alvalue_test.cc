#include <alerror/alerror.h>
#include <alvalue/alvalue.h>
#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

namespace {

// As in a program's main().
template <class T>
std::string written(const T& it) {
  std::ostringstream text;
  text << it;
  return text.str();
}

struct Own {};
std::ostream& operator<<(std::ostream& out, const std::vector<Own>& list) {
  return out << list.size() << " of its own";
}

}  // namespace

namespace AL {
namespace {

TEST(AlValue, IsWrittenAndSoAreTheListsThatProxiesReturn) {
  EXPECT_EQ(written(ALValue::array(1, "a")), "[1, \"a\"]");
  EXPECT_EQ(written(std::vector<float>{0.5F, 1}), "[0.5, 1]");
  EXPECT_EQ(written(std::vector<std::string>{"HeadYaw"}), "[\"HeadYaw\"]");
  EXPECT_EQ(written(std::vector<Own>(2)), "2 of its own");
}

TEST(AlValue, GrowsIntoNestedArraysByIndex) {
  ALValue command;
  command.arraySetSize(2);
  command[0] = std::string("alias");
  command[1].arraySetSize(2);
  command[1][0] = 0.5F;
  command[1][1] = 7;
  EXPECT_EQ(command.toString(), "[\"alias\", [0.5, 7]]");
}

TEST(AlValue, ArrayTakesMixedTypes) {
  const ALValue value = ALValue::array("x", 1.5F, 2, true, ALValue::array(3));
  ASSERT_EQ(value.getSize(), 5U);
  EXPECT_TRUE(value[0].isString());
  EXPECT_TRUE(value[1].isFloat());
  EXPECT_TRUE(value[2].isInt());
  EXPECT_TRUE(value[3].isBool());
  EXPECT_EQ(static_cast<int>(value[4][0]), 3);
}

TEST(AlValue, NumbersTurnIntoEachOther) {
  const float from_int = ALValue(3);
  const int from_float = ALValue(2.75F);
  const double from_bool = ALValue(true);
  EXPECT_EQ(from_int, 3.0F);
  EXPECT_EQ(from_float, 2);
  EXPECT_EQ(from_bool, 1.0);
}

TEST(AlValue, ATextIsNoNumber) {
  EXPECT_THROW(static_cast<void>(static_cast<float>(ALValue("1"))), ALError);
  EXPECT_THROW(static_cast<void>(static_cast<std::string>(ALValue(1))), ALError);
}

TEST(AlValue, OneValueIsReadAsAListOfOne) {
  const std::vector<std::string> names = ALValue("HeadYaw");
  EXPECT_EQ(names, std::vector<std::string>{"HeadYaw"});
}

TEST(AlValue, AConstIndexBeyondTheEndThrows) {
  const ALValue value = ALValue::array(1, 2);
  EXPECT_THROW(static_cast<void>(value[2]), ALError);
  EXPECT_THROW(static_cast<void>(ALValue(1)[0]), ALError);
}

TEST(AlValue, BytesAreSharedByCopies) {
  ALValue bytes("abc", 3);
  const ALValue copy = bytes;
  bytes.clear();
  ASSERT_EQ(copy.getSize(), 3U);
  EXPECT_EQ(std::string(static_cast<const char*>(copy.GetBinary()), 3), "abc");
}

TEST(AlValue, IsEqualByTypeAndContent) {
  EXPECT_TRUE(ALValue::array(1, "a") == ALValue::array(1, "a"));
  EXPECT_TRUE(ALValue(1) != ALValue(1.0F));
  EXPECT_TRUE(ALValue() == ALValue());
}

TEST(AlValue, IsMadeOfPlainArrays) {
  const char* names[] = {"HeadYaw", "HeadPitch"};
  const float angles[] = {0.5F, -0.25F};
  const int ids[] = {1, 2, 3};
  EXPECT_EQ(ALValue(names, 2).toString(), "[\"HeadYaw\", \"HeadPitch\"]");
  EXPECT_EQ(ALValue(angles, 2).toString(), "[0.5, -0.25]");
  EXPECT_EQ(ALValue(ids, 3).toString(), "[1, 2, 3]");
}

TEST(AlValue, IsMadeOfBytesAndGivesThemBack) {
  const ALValue::TAlValueBinaryData bytes = {1, 0, 255};
  const ALValue value = bytes;
  EXPECT_TRUE(value.isBinary());
  EXPECT_EQ(value.asRaw(), bytes);
  EXPECT_EQ(static_cast<const void*>(value), value.GetBinary());
  EXPECT_THROW(ALValue(1).asRaw(), ALError);
}

TEST(AlValue, ATextIsWrittenToInPlace) {
  ALValue value;
  static_cast<std::string&>(value) += "Yaw";
  EXPECT_EQ(value.toString(AL::VerbosityMini), "\"Yaw\"");
  EXPECT_EQ(value.getSize(), 3U);
  ALValue number(1);
  EXPECT_THROW(static_cast<std::string&>(number).clear(), ALError);
}

TEST(AlValue, ListsLeaveOutOrReplaceWhatDoesNotFit) {
  const ALValue mixed = ALValue::array(1, "a", 0.5F);
  std::vector<float> numbers = {9};
  mixed.ToFloatArray(numbers);
  EXPECT_EQ(numbers, (std::vector<float>{1, 0.5F}));
  std::vector<std::string> texts;
  mixed.ToStringArray(texts, true);
  EXPECT_EQ(texts, (std::vector<std::string>{"", "a", ""}));
  std::vector<int> whole;
  mixed.ToIntArray(whole);
  EXPECT_EQ(whole, std::vector<int>{1});
  EXPECT_THROW(ALValue(1).ToIntArray(whole), ALError);
}

TEST(AlValue, RoomIsReservedInArraysAlone) {
  ALValue array;
  array.arrayReserve(5);
  EXPECT_EQ(array.getSize(), 0U);
  ALValue number(1);
  EXPECT_THROW(number.arrayReserve(5), ALError);
}

TEST(AlValue, GivesItsNumberAndItsItemsThemselves) {
  ALValue number(0.5F);
  *static_cast<float*>(number.getPtrValue()) = 2;
  EXPECT_EQ(static_cast<float>(number), 2);
  *number.getFloatPtr() = 3;
  const long long whole = number;
  EXPECT_EQ(whole, 3);
  EXPECT_THROW(number.getIntPtr(), ALError);
  ALValue array = ALValue::array(1, 2);
  array.getArrayPtr()->push_back(3);
  EXPECT_EQ(array.getSize(), 3U);
  EXPECT_THROW(array.getPtrValue(), ALError);
  EXPECT_THROW(number.getArrayPtr(), ALError);
}

TEST(AlValue, AnObjectIsBytesOfAnotherType) {
  ALValue value;
  EXPECT_TRUE(value.setObject("abc", 3).isObject());
  EXPECT_EQ(value.getSize(), 3U);
  EXPECT_EQ(std::string(static_cast<const char*>(value.getObject()), 3), "abc");
  EXPECT_THROW(value.GetBinary(), ALError);
  EXPECT_TRUE(value != ALValue("abc", 3));
}

TEST(AlValue, TypesHaveNames) {
  EXPECT_EQ(ALValue::TypeToString(ALValue().getType()), "Invalid");
  EXPECT_EQ(ALValue::TypeToString(ALValue::TypeBinary), "Binary");
}

TEST(AlValue, ComesBackFromItsText) {
  const ALValue value =
      ALValue::array(36, -3, "to\"to\\", 3.0F, 0.1F, true, ALValue::array(ALValue::array()));
  ALValue back;
  back.unSerializeFromText(value.serializeToText().c_str());
  EXPECT_TRUE(back == value) << back << value.serializeToText();
  EXPECT_THROW(static_cast<void>(ALValue("abc", 3).serializeToText()), ALError);
}

TEST(AlValue, ATextsTypeIsDeduced) {
  EXPECT_EQ(ALValue::deduceType("5"), ALValue::TypeInt);
  EXPECT_EQ(ALValue::deduceType(" 5e2 "), ALValue::TypeFloat);
  EXPECT_EQ(ALValue::deduceType("'toto'"), ALValue::TypeString);
  EXPECT_EQ(ALValue::deduceType("[3,5]"), ALValue::TypeArray);
  EXPECT_EQ(ALValue::deduceType("12, 3", 2), ALValue::TypeInt);
  EXPECT_EQ(ALValue::deduceType(""), ALValue::TypeInvalid);
}

TEST(AlValue, ATextThatIsNoValueIsRefused) {
  ALValue value(7);
  for (const char* text : {"[1", "[1 2]", "[1,]", "toto", "'a", "1]", "]", ","})
    EXPECT_THROW(value.unSerializeFromText(text), ALError) << text;
  EXPECT_THROW(value.unSerializeFromText(std::string(100000, '[').c_str()), ALError);
  EXPECT_EQ(static_cast<int>(value), 7);
}

// The examples of RFC 4648.
TEST(AlValue, BytesGoThroughBase64) {
  const char* pairs[][2] = {{"", ""},
                            {"f", "Zg=="},
                            {"fo", "Zm8="},
                            {"foo", "Zm9v"},
                            {"foob", "Zm9vYg=="},
                            {"fooba", "Zm9vYmE="},
                            {"foobar", "Zm9vYmFy"}};
  for (const auto& [plain, encoded] : pairs) {
    const ALValue bytes(static_cast<const void*>(plain), static_cast<int>(std::strlen(plain)));
    std::string text;
    bytes.encodeB64(text);
    EXPECT_EQ(text, encoded);
    ALValue back;
    EXPECT_TRUE(back.decodeB64(encoded));
    EXPECT_TRUE(back == bytes);
  }
}

TEST(AlValue, WhatIsNotBase64ChangesNothing) {
  ALValue value(7);
  for (const char* text : {"Z", "Zg=", "Z===", "Zg==Zg==", "Zm9*", "===="})
    EXPECT_FALSE(value.decodeB64(text)) << text;
  EXPECT_TRUE(value.isInt());
  EXPECT_TRUE(value.decodeB64Object("Zg=="));
  EXPECT_TRUE(value.isObject());
}

TEST(AlError, SaysModuleMethodAndWhy) {
  const ALError error = ALERROR("Module", "method()", "because");
  EXPECT_STREQ(error.what(), "\tModule::method()\n\tbecause");
  EXPECT_EQ(error.getDescription(), "because");
  EXPECT_GT(error.getLine(), 0U);
}

}  // namespace
}  // namespace AL

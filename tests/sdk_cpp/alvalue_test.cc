#include <alerror/alerror.h>
#include <alvalue/alvalue.h>
#include <gtest/gtest.h>

#include <sstream>

namespace AL {
namespace {

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

TEST(AlError, SaysModuleMethodAndWhy) {
  const ALError error = ALERROR("Module", "method()", "because");
  EXPECT_STREQ(error.what(), "\tModule::method()\n\tbecause");
  EXPECT_EQ(error.getDescription(), "because");
  EXPECT_GT(error.getLine(), 0U);
}

}  // namespace
}  // namespace AL

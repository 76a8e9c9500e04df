#include "naoqi_api/value.h"

#include <gtest/gtest.h>

namespace nao::rpc {
namespace {

TEST(Value, KeepsTheExactTypeOfANumber) {
  EXPECT_EQ(Value(1).signature(), "i");
  EXPECT_EQ(Value(1U).signature(), "I");
  EXPECT_EQ(Value(std::int64_t{1}).signature(), "l");
  EXPECT_EQ(Value(std::uint8_t{1}).signature(), "C");
  EXPECT_EQ(Value(std::int16_t{1}).signature(), "w");
  EXPECT_EQ(Value(1.5F).signature(), "f");
  EXPECT_EQ(Value(1.5).signature(), "d");
  EXPECT_EQ(Value(true).signature(), "b");
}

TEST(Value, TellsNothingFromInvalid) {
  EXPECT_EQ(Value().signature(), "v");
  EXPECT_EQ(Value::invalid().signature(), "");
  EXPECT_NE(Value(), Value::invalid());
  EXPECT_TRUE(Value::invalid().isVoid());
}

TEST(Value, ContainersSayWhatTheyHold) {
  EXPECT_EQ(Value::list({1, "x"}).signature(), "[m]");
  EXPECT_EQ(Value::listOf("f", {1.0F}).signature(), "[f]");
  EXPECT_EQ(Value::tuple({1, "x", 2.5F}).signature(), "(isf)");
  EXPECT_EQ(Value::tuple("(si)<Pair,a,b>", {"x", 1}).signature(), "(si)<Pair,a,b>");
  EXPECT_EQ((Value(Value::Map{"s", "m", {{"a", 1}}}).signature()), "{sm}");
  EXPECT_EQ(Value::raw({1, 2}).signature(), "r");
  EXPECT_EQ(Value::dynamic(1).signature(), "m");
}

TEST(Value, InspectionLooksIntoDynamics) {
  const Value value = Value::dynamic(Value::dynamic("x"));
  EXPECT_EQ(*value.findText(), "x");
  EXPECT_TRUE(value.isString());
  EXPECT_FALSE(value.findNumber());
}

TEST(Value, BoolIsNoNumberButReadsAsOne) {
  EXPECT_FALSE(Value(true).isNumber());
  EXPECT_EQ(Value(true).findNumber(), 1.0);
}

TEST(Value, BytesAreSharedNotCopied) {
  const auto pixels = std::make_shared<const Bytes>(Bytes(1000));
  const Value image = Value::list({640, pixels});
  const Value copy = image;
  EXPECT_EQ((*copy.findItems())[1].findBytes().get(), pixels.get());
}

TEST(Value, PrintsForPeople) {
  EXPECT_EQ(Value::list({1, "x", 2.5F, true, Value()}).print(), "[1, \"x\", 2.5, true, nothing]");
}

}  // namespace
}  // namespace nao::rpc

#include "naoqi_api/convert.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace nao::rpc {
namespace {

std::optional<Value> declared(const Value& value, const char* signature) {
  return convert(value, Signature::of(signature), Bend::Declared);
}

TEST(Convert, IntegersChangeWidthWhenInRange) {
  EXPECT_EQ(declared(std::int64_t{7}, "i"), Value(7));
  EXPECT_EQ(declared(std::int64_t{1} << 40U, "i"), std::nullopt);
  EXPECT_EQ(declared(std::numeric_limits<std::uint32_t>::max(), "i"), std::nullopt);
  EXPECT_EQ(declared(-1, "I"), std::nullopt);
  EXPECT_EQ(declared(-128, "c"), Value(std::int8_t{-128}));
  EXPECT_EQ(declared(-129, "c"), std::nullopt);
  const auto least = std::numeric_limits<std::int64_t>::min();
  EXPECT_EQ(declared(least, "l"), Value(least));
  EXPECT_EQ(declared(std::numeric_limits<std::uint64_t>::max(), "l"), std::nullopt);
}

TEST(Convert, FloatsBecomeIntegersByTruncation) {
  EXPECT_EQ(declared(1.7, "i"), Value(1));
  EXPECT_EQ(declared(-2.7, "i"), Value(-2));
  EXPECT_EQ(declared(std::nan(""), "i"), Value(0));
  EXPECT_EQ(declared(1e12, "i"), std::nullopt);
  EXPECT_EQ(declared(std::numeric_limits<double>::infinity(), "l"), std::nullopt);
  EXPECT_EQ(declared(0x1p63, "l"), std::nullopt);
  EXPECT_EQ(declared(-0x1p63, "l"), Value(std::numeric_limits<std::int64_t>::min()));
  EXPECT_EQ(declared(-0.5, "I"), Value(0U));
}

TEST(Convert, OnlyExactlyZeroAndOneAreBools) {
  EXPECT_EQ(declared(1, "b"), Value(true));
  EXPECT_EQ(declared(0.0, "b"), Value(false));
  EXPECT_EQ(declared(5, "b"), std::nullopt);
  EXPECT_EQ(declared(0.5, "b"), std::nullopt);
  EXPECT_EQ(declared(true, "i"), Value(1));
}

TEST(Convert, TextIsNeverANumber) {
  for (const Bend bend : {Bend::Declared, Bend::Loose}) {
    EXPECT_EQ(convert("1", Signature::of("i"), bend), std::nullopt);
    EXPECT_EQ(convert("1", Signature::of("[f]"), bend), std::nullopt);
    EXPECT_EQ(convert(1, Signature::of("s"), bend), std::nullopt);
  }
  EXPECT_EQ(declared(Value::raw({'x'}), "s"), std::nullopt);
  EXPECT_EQ(declared(Value(), "s"), std::nullopt);
}

TEST(Convert, ListsConvertItemByItem) {
  EXPECT_EQ(declared(Value::list({"a", "b"}), "[s]"), Value::listOf("s", {"a", "b"}));
  EXPECT_EQ(declared(Value::listOf("_", {}), "[s]"), Value::listOf("s", {}));
  EXPECT_EQ(declared(Value::list({"a", 1}), "[s]"), std::nullopt);
}

TEST(Convert, OnlyLooselyIsATupleOrOneValueAList) {
  const Value tuple = Value::tuple({"a", "b"});
  EXPECT_EQ(declared(tuple, "[s]"), std::nullopt);
  EXPECT_EQ(declared("a", "[s]"), std::nullopt);
  EXPECT_EQ(tuple.to<std::vector<std::string>>(), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(Value("a").to<std::vector<std::string>>(), std::vector<std::string>{"a"});
  EXPECT_THROW(Value().to<std::vector<std::string>>(), CallError);
}

TEST(Convert, DynamicsOfTheRightTypeAreOpened) {
  EXPECT_EQ(declared(Value::dynamic(Value::dynamic(7)), "i"), Value(7));
  EXPECT_EQ(declared(Value::dynamic(7), "m"), Value::dynamic(7));
}

TEST(Convert, StructsOfOneNameMeetByField) {
  const Value old = Value::tuple("(sI)<Info,name,id>", {"x", 7U});
  EXPECT_EQ(declared(old, "(Iss)<Info,id,name,uid>"),
            Value::tuple("(Iss)<Info,id,name,uid>", {7U, "x", ""}));
  EXPECT_EQ(declared(old, "(Iss)<Other,id,name,uid>"), std::nullopt);
  EXPECT_EQ(declared(Value::tuple({"x", 7U}), "(Iss)<Info,id,name,uid>"), std::nullopt);
}

TEST(Convert, MapsAndOptionalsConvertInside) {
  EXPECT_EQ(declared(Value::Map{"m", "m", {{"a", 1.0}}}, "{si}"),
            Value(Value::Map{"s", "i", {{"a", 1}}}));
  EXPECT_EQ(declared(5, "+f"), Value(Value::Optional{"f", {5.0F}}));
  EXPECT_EQ(declared(Value(), "+f"), Value(Value::Optional{"f", {}}));
}

TEST(OneOrManyType, ReadsOneOrMany) {
  using Names = OneOrMany<std::string>;
  EXPECT_EQ(ValueType<Names>::read("HeadYaw"), Names{"HeadYaw"});
  EXPECT_EQ(ValueType<Names>::read(Value::list({"HeadYaw", "HeadPitch"})),
            (Names{"HeadYaw", "HeadPitch"}));
  const auto angles = ValueType<OneOrMany<float>>::read(Value::list({1.5, std::int64_t{1}, true}));
  EXPECT_EQ(angles, (OneOrMany<float>{1.5F, 1.0F, 1.0F}));
  const auto nested = ValueType<OneOrMany<std::vector<float>>>::read(Value::list({1, 2}));
  EXPECT_EQ(nested.size(), 2U);
  EXPECT_THROW(ValueType<OneOrMany<float>>::read(Value::list({1.5, "x"})), CallError);
}

TEST(ToValue, MakesAndReadsBackCppTypes) {
  const std::map<std::string, std::vector<int>> map = {{"a", {1, 2}}, {"b", {}}};
  EXPECT_EQ(toValue(map).signature(), "{s[i]}");
  EXPECT_EQ((toValue(map).to<std::map<std::string, std::vector<int>>>()), map);
  const std::tuple<int, bool, std::string> tuple = {1, true, "x"};
  EXPECT_EQ((toValue(tuple).to<std::tuple<int, bool, std::string>>()), tuple);
  EXPECT_EQ(toValue(std::vector<bool>{true, false}), Value::listOf("b", {true, false}));
}

TEST(ValueTo, SaysWhatItExpected) {
  try {
    Value("x").to<std::vector<float>>();
    FAIL() << "text is no list of floats";
  } catch (const CallError& error) {
    EXPECT_STREQ(error.what(), "expected List<Float>, got \"x\"");
  }
}

}  // namespace
}  // namespace nao::rpc

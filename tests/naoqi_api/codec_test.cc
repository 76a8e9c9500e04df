#include "naoqi_api/wire/codec.h"

#include <gtest/gtest.h>

#include "naoqi_api/wire/bytes.h"

namespace nao::wire {
namespace {

Bytes encoded(const Value& value, const char* signature) {
  Bytes bytes;
  encode(bytes, value, Signature::of(signature));
  return bytes;
}

// A dynamic with that signature and these bytes.
Bytes dynamic(const std::string& signature, const Bytes& content = {}) {
  Bytes bytes;
  appendText(bytes, signature);
  bytes.insert(bytes.end(), content.begin(), content.end());
  return bytes;
}

std::string errorOf(const Bytes& bytes, const char* signature) {
  try {
    Decoder(bytes).read(signature);
    return "no error";
  } catch (const CodecError& error) {
    return error.what();
  }
}

constexpr char kPastEnd[] = "ISerialization error Status Read Past End";
constexpr char kTooMany[] = "ISerialization error: too many values";

TEST(Codec, WritesTheKnownBytes) {
  EXPECT_EQ(encoded(true, "b"), Bytes{1});
  EXPECT_EQ(encoded(-2, "i"), (Bytes{0xFE, 0xFF, 0xFF, 0xFF}));
  EXPECT_EQ(encoded(std::uint16_t{0x1234}, "W"), (Bytes{0x34, 0x12}));
  EXPECT_EQ(encoded(std::int64_t{1}, "l"), (Bytes{1, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(encoded(3.75F, "f"), (Bytes{0, 0, 0x70, 0x40}));
  EXPECT_EQ(encoded("ab", "s"), (Bytes{2, 0, 0, 0, 'a', 'b'}));
  EXPECT_EQ(encoded(Value::raw({1, 2}), "r"), (Bytes{2, 0, 0, 0, 1, 2}));
  EXPECT_EQ(encoded(Value::listOf("C", {std::uint8_t{7}}), "[C]"), (Bytes{1, 0, 0, 0, 7}));
  EXPECT_EQ(encoded(Value(), "v"), Bytes{});
  EXPECT_EQ(encoded(5, "m"), (Bytes{1, 0, 0, 0, 'i', 5, 0, 0, 0}));
  EXPECT_EQ(encoded(Value(), "m"), (Bytes{1, 0, 0, 0, 'v'}));
  EXPECT_EQ(encoded(Value::invalid(), "m"), (Bytes{0, 0, 0, 0}));
  EXPECT_EQ(encoded(Value::Optional{"C", {std::uint8_t{7}}}, "+C"), (Bytes{1, 7}));
}

TEST(Codec, ReadsBackWhatItWrote) {
  const std::vector<Value> values = {Value(true),
                                     std::int8_t{-1},
                                     std::uint8_t{255},
                                     std::int16_t{-300},
                                     std::uint16_t{65535},
                                     -70000,
                                     4000000000U,
                                     std::int64_t{-1099511627776},
                                     ~std::uint64_t{0},
                                     1.5F,
                                     2.5,
                                     std::string("a\0b", 3),
                                     Value(),
                                     Value::invalid(),
                                     Value::list({1, "x", Value::list({})}),
                                     Value::listOf("[f]", {Value::listOf("f", {1.0F})}),
                                     Value::tuple({1, "x"}),
                                     Value::tuple("(mm)", {1, "x"}),
                                     Value::tuple("(si)<Pair,a,b>", {"x", 1}),
                                     Value::Map{"m", "m", {{"k", Value::list({1})}}},
                                     Value::dynamic(Value::dynamic(7)),
                                     Value::Optional{"s", {}},
                                     Value::listOf("_", {})};
  for (const Value& value : values) {
    Bytes bytes;
    encodeDynamic(bytes, value);
    Decoder decoder(bytes);
    EXPECT_EQ(decoder.read("m"), value) << value.signature();
    EXPECT_EQ(decoder.left(), 0U) << value.signature();
  }
}

TEST(Codec, RawBytesKeepTheirContent) {
  Bytes bytes;
  encodeDynamic(bytes, Value::raw({1, 2, 3}));
  EXPECT_EQ(*Decoder(bytes).read("m").findBytes(), (Bytes{1, 2, 3}));
}

TEST(Codec, EveryTruncationIsAnError) {
  Bytes bytes;
  encodeDynamic(bytes, Value::list({1, "text", Value::tuple({1.5, true}),
                                    Value::Map{"s", "i", {{"k", 1}}}, Value::raw({1, 2, 3})}));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_EQ(errorOf(Bytes(bytes.begin(), bytes.begin() + static_cast<long>(size)), "m"), kPastEnd)
        << size;
  }
}

TEST(Codec, CountsAreCheckedAgainstTheBytesLeft) {
  const Bytes huge = {0xFF, 0xFF, 0xFF, 0x7F};
  for (const char* signature : {"s", "r", "[i]", "[s]", "{si}", "[(bb)]"}) {
    EXPECT_EQ(errorOf(huge, signature), kPastEnd) << signature;
  }
}

TEST(Codec, ItemsWithoutBytesAreCounted) {
  Bytes bytes = {0, 0, 1, 0};  // 65536
  EXPECT_EQ(errorOf(bytes, "[v]"), "no error");
  bytes = {1, 0, 1, 0};
  EXPECT_EQ(errorOf(bytes, "[v]"), kTooMany);
  EXPECT_EQ(errorOf(bytes, "[()]"), kTooMany);
  EXPECT_EQ(errorOf(bytes, "{vv}"), kTooMany);
  bytes = {0, 0x80, 0, 0};  // 32768 tuples of three nothings
  EXPECT_EQ(errorOf(bytes, "[(vvv)]"), kTooMany);
}

TEST(Codec, NestingHasAnEnd) {
  const auto nested = [](int depth) {
    Bytes bytes;
    for (int i = 0; i < depth; ++i) appendText(bytes, "m");
    const Bytes inner = dynamic("C", {7});
    bytes.insert(bytes.end(), inner.begin(), inner.end());
    return bytes;
  };
  EXPECT_EQ(errorOf(nested(rpc::kMaxNesting - 1), "m"), "no error");
  EXPECT_EQ(errorOf(nested(rpc::kMaxNesting), "m"), "ISerialization error: nested too deep");
  EXPECT_EQ(errorOf(nested(100000), "m"), "ISerialization error: nested too deep");
}

TEST(Codec, AValueOfTheDeepestTypeCanNotBeWrittenInsideATuple) {
  const std::string element = std::string(63, '[') + "m" + std::string(63, ']');
  const Value deepest = Value::listOf(element, {});  // 64 lists deep
  Bytes bytes;
  encodeDynamic(bytes, deepest);
  EXPECT_EQ(Decoder(bytes).read("m"), deepest);
  EXPECT_THROW(encodeDynamic(bytes, Value::tuple({deepest})), CodecError);
}

TEST(Codec, BadSignaturesAreErrors) {
  EXPECT_EQ(errorOf(dynamic("q"), "m"), "ISerialization error: bad signature q");
  EXPECT_EQ(errorOf(dynamic("(i"), "m"), "ISerialization error: bad signature (i");
  EXPECT_EQ(errorOf(dynamic("X"), "m"), "ISerialization error: X can not be read");
  EXPECT_EQ(errorOf(dynamic("*"), "m"), "ISerialization error: * can not be read");
  EXPECT_EQ(errorOf(dynamic("o"), "m"), "ISerialization error: no object is expected here");
}

TEST(Codec, AFewBytesDoNotUnfoldIntoManyLongTypes) {
  // 40,000 empty lists of a type of 60,000 letters: 160 kB that would keep 2.4 GB of types.
  std::string type(60000, 'i');
  Bytes bytes;
  appendText(bytes, "[[(" + type + ")]]");
  appendNumber(bytes, std::uint32_t{40000});
  bytes.resize(bytes.size() + 4 * 40000);
  EXPECT_EQ(errorOf(bytes, "m"), kTooMany);
}

TEST(Codec, AMessageHoldsABoundedNumberOfValues) {
  Bytes bytes;
  appendNumber(bytes, std::uint32_t{2000000});
  bytes.resize(bytes.size() + 2000000);
  EXPECT_EQ(errorOf(bytes, "[C]"), kTooMany);
}

}  // namespace
}  // namespace nao::wire

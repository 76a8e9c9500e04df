#include "naoqi_api/signature.h"

#include <gtest/gtest.h>

#include "naoqi_api/convert.h"

namespace nao::rpc {
namespace {

TEST(Signature, IsPrintedAsItWasRead) {
  for (const char* text :
       {"i", "m", "[s]", "{s[m]}", "()", "(if[s]b)", "+i", "#m", "~s",
        "(sIsI[s]ss)<ServiceInfo,name,serviceId,machineId,processId,endpoints,sessionId,objectUid>",
        "{I(I(fff)<MinMaxSum,a,b,c>)<MethodStatistics,count,wall>}", "(s)<Name<int>,a>"}) {
    const auto parsed = Signature::parse(text);
    ASSERT_TRUE(parsed) << text;
    EXPECT_EQ(parsed->text(), text);
  }
}

TEST(Signature, RefusesWhatIsNotExactlyOneType) {
  for (const char* text : {"", "ii", "[", "[]", "[i", "[ii]", "{s}", "{sii}", "(i", ")", "q", "i<",
                           "i<a", "i<a<b>", "<a>", "+", "[i]]", " i"}) {
    EXPECT_FALSE(Signature::parse(text)) << text;
  }
}

TEST(Signature, NestsAsDeepAsAllowedAndNoDeeper) {
  const auto nested = [](int depth) {
    return std::string(depth, '[') + "i" + std::string(depth, ']');
  };
  EXPECT_TRUE(Signature::parse(nested(kMaxNesting)));
  EXPECT_FALSE(Signature::parse(nested(kMaxNesting + 1)));
  EXPECT_FALSE(Signature::parse(std::string(100000, '[')));
}

TEST(Signature, HasAnEndToItsLength) {
  EXPECT_TRUE(Signature::parse("(" + std::string(1000, 'i') + ")"));
  EXPECT_FALSE(Signature::parse("(" + std::string(kMaxSignature, 'i') + ")"));
}

TEST(Signature, SaysItsTypeInWords) {
  EXPECT_EQ(Signature::of("([s]b{sm}r)").words(),
            "(List<String>,Bool,Map<String,Value>,RawBuffer)");
}

TEST(Signature, LayoutForgetsNames) {
  EXPECT_TRUE(Signature::of("(si)<A,x,y>").hasLayoutOf(Signature::of("(si)")));
  EXPECT_FALSE(Signature::of("(si)").hasLayoutOf(Signature::of("(is)")));
}

TEST(SignatureOf, FollowsTheCppType) {
  EXPECT_EQ(signatureOf<bool>(), "b");
  EXPECT_EQ(signatureOf<int>(), "i");
  EXPECT_EQ(signatureOf<std::uint64_t>(), "L");
  EXPECT_EQ(signatureOf<const std::string&>(), "s");
  EXPECT_EQ(signatureOf<std::vector<std::vector<float>>>(), "[[f]]");
  EXPECT_EQ((signatureOf<std::map<std::string, Value>>()), "{sm}");
  EXPECT_EQ((signatureOf<std::tuple<int, OneOrMany<std::string>>>()), "(im)");
  EXPECT_EQ(signatureOf<Pending<void>>(), "v");
  EXPECT_EQ(signatureOf<Pending<std::vector<int>>>(), "[i]");
  EXPECT_EQ(signatureOf<std::shared_ptr<Service>>(), "o");
}

}  // namespace
}  // namespace nao::rpc

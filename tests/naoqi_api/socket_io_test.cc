#include "naoqi_api/wire/socket_io.h"

#include <gtest/gtest.h>

namespace nao::wire {
namespace {

const std::string kMark = "\xEF\xBF\xBD";

TEST(SocketIo, OnePacketIsABodyAsItIs) {
  EXPECT_EQ(joinPackets({"1::"}), "1::");
  EXPECT_EQ(splitPackets("1::"), std::vector<std::string_view>{"1::"});
}

TEST(SocketIo, SeveralSayHowManyUtf16UnitsTheyAre) {
  const std::string body =
      kMark + "3" + kMark + "1::" + kMark + "5" + kMark + "5:\xC3\xA9\xF0\x9F\x98\x80";
  EXPECT_EQ(joinPackets({"1::", "5:\xC3\xA9\xF0\x9F\x98\x80"}), body);
  const auto packets = splitPackets(body);
  ASSERT_TRUE(packets);
  EXPECT_EQ(*packets, (std::vector<std::string_view>{"1::", "5:\xC3\xA9\xF0\x9F\x98\x80"}));
}

TEST(SocketIo, ABodyThatPromisesMoreThanItHasIsNone) {
  for (const std::string& body : std::vector<std::string>{
           kMark, kMark + "3", kMark + "x" + kMark + "1::", kMark + "4" + kMark + "1::",
           kMark + "3" + kMark + "1::x", kMark + "99999999999999999999999" + kMark + "1"}) {
    EXPECT_EQ(splitPackets(body), std::nullopt) << body;
  }
}

}  // namespace
}  // namespace nao::wire

#include "daemon/web_rules.h"

#include <gtest/gtest.h>

#include "tests/core/temporary_folder.h"

namespace nao::daemon {
namespace {

TEST(WebRules, OnlyOwnNamesAreAHost) {
  for (const char* host : {"localhost", "localhost:8002", "127.0.0.1:8002", "[::1]:8002",
                           "10.0.0.7", "robot", "robot:80"}) {
    EXPECT_TRUE(isAllowed({host, ""}, "robot", {})) << host;
  }
  for (const char* host : {"", "evil.example", "localhost.evil.example", "127.0.0.1.evil.example",
                           "[::1", "robot.evil:80"}) {
    EXPECT_FALSE(isAllowed({host, ""}, "robot", {})) << host;
  }
}

TEST(WebRules, OnlyOwnPagesAndThoseNamedAreAnOrigin) {
  const std::string host = "localhost:8002";
  EXPECT_TRUE(isAllowed({host, "http://localhost:8002"}, "", {}));
  for (const char* origin : {"null", "http://evil.example", "http://localhost:3000",
                             "https://localhost:8002", "http://localhost:80021"}) {
    EXPECT_FALSE(isAllowed({host, origin}, "", {})) << origin;
  }
  EXPECT_TRUE(isAllowed({host, "http://localhost:3000"}, "", {"http://localhost:3000"}));
}

TEST(WebRules, AuthorizationIsAUserAndToken) {
  const TemporaryFolder folder;
  const auto credentials = rpc::Credentials::load(folder.write("auth", "nao secret\n"));
  EXPECT_TRUE(isAuthorized("Basic bmFvOnNlY3JldA==", credentials));  // nao:secret
  for (const char* header : {"", "Basic", "Basic ", "Basic bmFv", "Basic bmFvOndyb25n",
                             "Bearer bmFvOnNlY3JldA==", "Basic ####"}) {
    EXPECT_FALSE(isAuthorized(header, credentials)) << header;
  }
}

TEST(WebRules, PathsAreThoseOfTheRobot) {
  using Kind = WebRequest::Kind;
  EXPECT_EQ(readTarget("/").kind, Kind::Page);
  EXPECT_EQ(readTarget("/libs/qi/2/qi.js").kind, Kind::Script);
  EXPECT_EQ(readTarget("/libs/qimessaging/2/qimessaging.js?x").kind, Kind::Script);
  EXPECT_EQ(readTarget("/libs/qimessaging/2/socket.io/1/?t=17").kind, Kind::Handshake);
  const auto socket = readTarget("/libs/qimessaging/2/socket.io/1/websocket/abc?t=1");
  EXPECT_EQ(socket.kind, Kind::Socket);
  EXPECT_EQ(socket.session, "abc");
  const auto poll = readTarget("/libs/qimessaging/2/socket.io/1/xhr-polling/abc?t=1");
  EXPECT_EQ(poll.kind, Kind::Poll);
  EXPECT_EQ(poll.session, "abc");
  EXPECT_EQ(readTarget("/../etc/passwd").kind, Kind::Unknown);
}

}  // namespace
}  // namespace nao::daemon

// The robot's end of LoLA, from bytes to bytes: a daemon in lockstep with its client, so that every
// cycle is known.
#include "daemon/lola_server.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <memory>
#include <thread>

#include "core/check.h"
#include "daemon/daemon.h"
#include "tests/daemon/lola_daemon.h"
#include "tests/daemon/tcp_client.h"

namespace nao::daemon {
namespace {

using rpc::Value;
using std::chrono_literals::operator""ms;

constexpr int kHoldCycles =
    42;  // whole cycles of 12 ms in the 500 ms that a command holds, and one

TEST_F(LolaServerTest, OneFrameEveryTwelveMillisecondsOfSimulatedTime) {
  LolaDaemon daemon(lockstep());
  EXPECT_EQ(daemon.model().name, "nao_h25_v60");
  LolaClient client(path_);
  constexpr int kFrames = 250;
  for (int k = 0; k < kFrames; ++k) {
    client.receive();
    if (k < kFrames - 1) client.send(drive(0));
  }
  // The last one is not answered: there the world waits.
  daemon.awaitTime(SimTime(kFrames * 12ms));
  EXPECT_EQ(daemon.stop().time, SimTime(kFrames * 12ms));
}

TEST_F(LolaServerTest, TheWorldWaitsForItsFirstClient) {
  LolaDaemon daemon(lockstep());
  TcpClient qi(daemon.port());
  const auto memory = qi.service("UsarSim");  // others are served meanwhile
  const auto time = qi.call({memory, 1, qi.method(memory, "time")}, Value::tuple({}));
  EXPECT_EQ(*qi.answer(time, "d").find<double>(), 0);
}

TEST_F(LolaServerTest, AHeadFollowsASine) {
  LolaDaemon daemon(lockstep());
  LolaClient client(path_);
  double furthest = 0;
  for (int k = 0; k < 250; ++k) {
    const Value frame = client.receive();
    const double angle = 0.8 * std::sin(2 * 3.14159265 * k * 0.012 / 2);  // 0.5 Hz
    furthest = std::max(furthest, LolaClient::at(frame, "Position", 0));
    client.send(drive(static_cast<float>(angle)));
  }
  EXPECT_NEAR(furthest, 0.8, 0.05);  // a servo lags, and damps a little
}

TEST_F(LolaServerTest, EqualRunsSendEqualBytes) {
  std::string bytes[2];
  for (std::string& run : bytes) {
    LolaDaemon daemon(lockstep());
    LolaClient client(path_);
    for (int k = 0; k < 100; ++k) {
      run += client.receiveBytes();
      client.send(drive(0.005F * static_cast<float>(k)));
    }
  }
  EXPECT_TRUE(bytes[0] == bytes[1]);
  EXPECT_EQ(bytes[0].size(), 100U * 896U);
}

TEST_F(LolaServerTest, AStandingRobotFeelsGravityDownwards) {
  LolaDaemon daemon(lockstep());
  LolaClient client(path_);
  const RobotModel& model = daemon.model();
  const auto& stand = model.findPosture("StandInit")->angle;
  Value frame;
  std::vector<double> start;
  for (int k = 0; k < 250; ++k) {
    frame = client.receive();
    if (k == 0) {
      for (std::size_t i = 0; i < 25; ++i) start.push_back(LolaClient::at(frame, "Position", i));
    }
    std::vector<Value> way;  // from its crouch, in two seconds
    for (std::size_t i = 0; i < 25; ++i) {
      const double end = stand[model.findJoint(kLolaJoints[i]).value()];
      way.emplace_back(static_cast<float>(start[i] + std::min(k / 167.0, 1.0) * (end - start[i])));
    }
    client.send({{"Stiffness", LolaClient::list(1)}, {"Position", Value::list(std::move(way))}});
  }
  EXPECT_NEAR(LolaClient::at(frame, "Accelerometer", 2), -9.81, 0.3);  // its noise and zero
  double weight = 0;
  for (std::size_t i = 0; i < 8; ++i) weight += LolaClient::at(frame, "FSR", i);
  EXPECT_NEAR(weight, model.totalMass(), 0.3);
}

TEST_F(LolaServerTest, TheLastOfSeveralMapsOfACycleCountsAndOthersComplete) {
  LolaDaemon daemon(lockstep());
  LolaClient client(path_);
  client.receive();
  // One send, so that all of them are there when the world goes on.
  client.send(LolaClient::packed({{"Stiffness", LolaClient::list(0.25F)}}) +
              LolaClient::packed(drive(0.5F, 0.5F)) +
              LolaClient::packed({{"Stiffness", LolaClient::list(0.75F)}}));
  EXPECT_EQ(LolaClient::at(client.receive(), "Stiffness", 0), 0.75);
}

TEST_F(LolaServerTest, AFrameInPiecesIsTakenOnceItIsWhole) {
  LolaDaemon daemon(lockstep());
  LolaClient client(path_);
  client.receive();
  const std::string map = LolaClient::packed(drive(0.5F, 0.5F));
  client.send(map.substr(0, 100));
  client.send(map.substr(100));
  EXPECT_EQ(LolaClient::at(client.receive(), "Stiffness", 0), 0.5);
}

TEST_F(LolaServerTest, BadFramesKeepTheLastCommandForHalfASecond) {
  const std::vector<LolaClient::Map> bad{
      {{"Position", LolaClient::list(NAN)}, {"Stiffness", LolaClient::list(1)}},
      {{"Position", "stand"}},
      {{"Position", LolaClient::list(0, 24)}},
      {{"Position", LolaClient::list(90)}, {"Stiffness", LolaClient::list(1)}}};
  for (const auto& map : bad) {
    LolaDaemon daemon(lockstep());
    LolaClient client(path_);
    client.receive();
    client.send(drive(0.5F));
    for (int k = 0; k < kHoldCycles; ++k) {
      EXPECT_EQ(LolaClient::at(client.receive(), "Stiffness", 0), 1) << k;
      client.send(map);
    }
    EXPECT_EQ(LolaClient::at(client.receive(), "Stiffness", 0), 0);
    client.send(drive(0.5F));
    EXPECT_EQ(LolaClient::at(client.receive(), "Stiffness", 0), 1);
  }
}

TEST_F(LolaServerTest, AClientThatSendsNothingHoldsNobodyUp) {
  LolaDaemon daemon(freeRunning());
  LolaClient silent(path_);
  silent.receive();
  TcpClient qi(daemon.port());
  const auto sim = qi.service("UsarSim");
  const auto time = [&, method = qi.method(sim, "time")] {
    return *qi.answer(qi.call({sim, 1, method}, Value::tuple({})), "d").find<double>();
  };
  const double start = time();
  while (time() < start + 2) {
  }
  // It has one frame to read, not all that it missed; the next may come while it reads.
  const std::size_t bytes = silent.receiveBytes().size();
  EXPECT_GE(bytes, LolaClient::kFrame);
  EXPECT_LE(bytes, 2 * LolaClient::kFrame);
}

TEST_F(LolaServerTest, ASlowClientIsWaitedForOnlySoLong) {
  Options options = lockstep();
  options.lola_lockstep = 0.01;
  LolaDaemon daemon(options);
  LolaClient client(path_);
  client.receive();
  client.receive();  // although the first one was not answered
}

TEST_F(LolaServerTest, WhoComesBackDrivesAgain) {
  LolaDaemon daemon(freeRunning());
  for (const float own : {0.25F, 0.5F, 0.75F}) {
    LolaClient client(path_);
    double stiffness = 0;
    for (int k = 0; k < 1000 && stiffness != double{own}; ++k) {
      stiffness = LolaClient::at(client.receive(), "Stiffness", 0);
      client.send(drive(0, own));
    }
    EXPECT_EQ(stiffness, double{own});
  }
}

TEST_F(LolaServerTest, ASecondClientIsClosedAndTheFirstStays) {
  LolaDaemon daemon(lockstep());
  LolaClient first(path_);
  first.receive();
  LolaClient second(path_);
  EXPECT_EQ(second.receiveBytes(), "");
  first.send(drive(0));
  first.receive();
}

TEST_F(LolaServerTest, AHundredMegabytesCloseTheirSenderAlone) {
  Options options = lockstep();
  options.robots = {{"good", "nao_h25_v60", {}}, {"bad", "nao_h25_v60", {}}};
  options.lola = {{"bad", path_ + "_bad"}, {"good", path_}};
  LolaDaemon daemon(options);
  LolaClient good(path_);
  LolaClient bad(path_ + "_bad");
  good.receive();
  bad.receive();
  good.send(drive(0.5F));
  bad.send(drive(0.5F));
  good.receive();
  bad.receive();
  constexpr char kMapOfMillions[] = "\xdf\x00\xff\xff\xff";  // map 32
  std::string huge(kMapOfMillions, 5);
  huge.resize(100U << 20U, '\x01');
  EXPECT_FALSE(bad.send(huge));
  for (int k = 0; k < 2 * kHoldCycles; ++k) {
    good.send(drive(0.5F));
    EXPECT_EQ(LolaClient::at(good.receive(), "Stiffness", 0), 1);
  }
  LolaClient again(path_ + "_bad");
  good.send(drive(0.5F));
  EXPECT_EQ(LolaClient::at(again.receive(), "Stiffness", 0), 0);
}

TEST_F(LolaServerTest, BytesThatAreNoMessagePackCloseTheirSender) {
  LolaDaemon daemon(freeRunning());
  LolaClient client(path_);
  EXPECT_TRUE(client.send(std::string(64, '\xc1')));  // never used in MessagePack
  std::string rest = client.receiveBytes();
  while (!rest.empty()) rest = client.receiveBytes();
  LolaClient(path_).receive();
}

// --- The socket ---

TEST_F(LolaServerTest, ItsSocketGoesWithIt) {
  LolaDaemon daemon(lockstep());
  struct stat file {};
  EXPECT_EQ(::lstat(path_.c_str(), &file), 0);
  daemon.stop();
  EXPECT_NE(::lstat(path_.c_str(), &file), 0);
}

TEST_F(LolaServerTest, ASocketThatNobodyAnswersGivesWay) {
  boost::asio::io_context io;
  {
    boost::asio::local::stream_protocol::acceptor left(
        io, boost::asio::local::stream_protocol::endpoint(path_));
  }
  LolaDaemon daemon(freeRunning());
  LolaClient(path_).receive();
}

TEST_F(LolaServerTest, ASocketThatIsAnsweredDoesNot) {
  LolaDaemon first(freeRunning());
  EXPECT_THROW(Daemon{freeRunning()}, InputError);
  LolaClient(path_).receive();
}

TEST_F(LolaServerTest, AFileThatIsNoSocketStays) {
  folder_.write("robocup", "a note");
  EXPECT_THROW(Daemon{freeRunning()}, InputError);
  std::ifstream note(path_);
  EXPECT_TRUE(note);
}

TEST_F(LolaServerTest, ASocketThatCanNotBeMadeIsToldInOneSentence) {
  for (const std::string& path : {std::string("/nowhere/robocup"), std::string(300, 'x')}) {
    Options options = freeRunning();
    options.lola = {{"", path}};
    EXPECT_THROW(Daemon{options}, InputError);
  }
}

TEST_F(LolaServerTest, AnyRobotCanBeServed) {
  for (const char* model : {"nao_h21_v33", "nao_h25_v40", "nao_h25_v50"}) {
    Options options = lockstep();
    options.robots = {{"nao", model, {}}};
    LolaDaemon daemon(options);
    EXPECT_EQ(daemon.model().cycle, 12ms) << model;
    LolaClient client(path_);
    for (int k = 0; k < 10; ++k) {
      client.receive();
      client.send(drive(0));
    }
    EXPECT_EQ(LolaClient::at(client.receive(), "Stiffness", 0), 1) << model;
  }
}

}  // namespace
}  // namespace nao::daemon

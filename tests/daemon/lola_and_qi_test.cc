// A LoLA client and a qi client on one body: who drives it.
#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>

#include "tests/daemon/lola_daemon.h"
#include "tests/daemon/tcp_client.h"

namespace nao::daemon {
namespace {

using rpc::Value;

class LolaAndQiTest : public LolaServerTest {};

/// Answers every frame with the same, in lockstep: however slow the machine is, it drives.
class Program {
 public:
  explicit Program(const std::string& path) : client_(path), thread_([this] { run(); }) {}
  ~Program() { end(); }
  void end() {
    ends_ = true;
    if (thread_.joinable()) thread_.join();
    client_.close();
  }

 private:
  void run() {
    while (!ends_) {
      if (client_.receiveBytes().size() != 896) return;
      client_.send(drive(0.5F, 0.5F));
    }
  }

  LolaClient client_;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

TEST_F(LolaAndQiTest, LolaDrivesAndQiSeesIt) {
  LolaDaemon daemon(lockstep());
  Program lola(path_);
  TcpClient qi(daemon.port());
  const auto floatOf = [&](const char* method, const Value& arguments) {
    const std::uint32_t motion = qi.service("ALMotion");
    const wire::Address address{motion, 1, qi.method(motion, method)};
    return qi.answer(qi.call(address, arguments), "[f]").to<std::vector<float>>().at(0);
  };
  const auto stiffness = [&] {
    return floatOf("getStiffnesses", Value::tuple("(m)", {"HeadYaw"}));
  };
  for (int k = 0; k < 10000 && stiffness() != 0.5F; ++k) {
  }
  EXPECT_EQ(stiffness(), 0.5F);
  EXPECT_EQ(floatOf("getAngles", Value::tuple("(mb)", {"HeadYaw", false})), 0.5F);
  // Motions fail with a reason, and nothing of them reaches the body.
  EXPECT_NE(qi.result("ALMotion", "wakeUp", {}, "v").print().find("a LoLA client drives"),
            std::string::npos);
  EXPECT_EQ(stiffness(), 0.5F);
  lola.end();
  // It is gone: half a second later ALMotion drives.
  for (int k = 0; k < 10000 && stiffness() != 0; ++k) {
  }
  EXPECT_EQ(qi.result("ALMotion", "wakeUp", {}, "v"), Value());
  EXPECT_GT(stiffness(), 0);
}

TEST_F(LolaAndQiTest, AClientThatOnlyListensLeavesTheBodyToQi) {
  LolaDaemon daemon(freeRunning());
  LolaClient lola(path_);
  lola.receive();
  TcpClient qi(daemon.port());
  EXPECT_EQ(qi.result("ALMotion", "wakeUp", {}, "v"), Value());
  lola.receive();
  lola.send({{"Chest", LolaClient::list(1, 3)}});  // lights are anybody's
  double stiffness = 0;
  for (int k = 0; k < 100; ++k) stiffness = LolaClient::at(lola.receive(), "Stiffness", 0);
  EXPECT_GT(stiffness, 0);
  double red = 0;
  for (int k = 0; k < 10000 && red != 1; ++k) {
    red = qi.result("ALMemory", "getData",
                    {"Device/SubDeviceList/ChestBoard/Led/Red/Actuator/Value"}, "m")
              .findNumber()
              .value();
  }
  EXPECT_EQ(red, 1);
}

}  // namespace
}  // namespace nao::daemon

// examples/lola_sine.cc, run as its first comment says, and a long talk with a client of our own.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include "daemon/daemon.h"
#include "tests/core/temporary_folder.h"
#include "tests/daemon/lola_client.h"
#include "tests/daemon/running_daemon.h"

namespace nao::daemon {
namespace {

using std::chrono_literals::operator""ms;

class LolaExampleTest : public testing::Test {
 protected:
  Options options() const {
    Options options = optionsFor({});
    options.lola = {{"", path_}};
    options.lola_lockstep = 60;  // [s] of the wall: far more than any answer takes
    return options;
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.path() + "/robocup";
};

std::string outputOf(const std::string& command) {
  std::FILE* pipe = ::popen(command.c_str(), "r");
  std::string output;
  std::array<char, 256> part{};
  while (std::fgets(part.data(), part.size(), pipe) != nullptr) output += part.data();
  EXPECT_EQ(::pclose(pipe), 0);
  return output;
}

TEST_F(LolaExampleTest, TheSineNodsTheHead) {
  const Running running(options());
  const std::string output = outputOf(std::string(NAO_LOLA_SINE) + " " + path_ + " 4");
  const std::string before = "the head went ";
  ASSERT_EQ(output.substr(0, before.size()), before) << output;
  // Of 0.5 rad: a servo lags, and damps a little.
  EXPECT_NEAR(std::atof(output.substr(before.size()).c_str()), 0.5, 0.03);
}

// 60 simulated seconds; NAO_LOLA_SECONDS=600 for ten minutes, by hand. Whole frames only
// (LolaClient::receive() throws otherwise), one every 12 ms: 83.3 a second.
TEST_F(LolaExampleTest, AClientRunsInLockstepWithoutAMalformedFrame) {
  const char* wish = std::getenv("NAO_LOLA_SECONDS");
  const double seconds = wish ? std::atof(wish) : 60;
  Daemon daemon(options());
  std::thread thread([&] { daemon.run(); });
  const int frames = static_cast<int>(std::lround(seconds / 0.012));
  {
    LolaClient client(path_);
    for (int k = 0; k < frames; ++k) {
      client.receive();
      const auto angle = static_cast<float>(0.5 * std::sin(0.012 * k));
      if (k < frames - 1) {
        client.send({{"Position", LolaClient::list(0.1F * angle)},
                     {"Stiffness", LolaClient::list(0.5F)},
                     {"Chest", LolaClient::list(std::abs(angle), 3)}});
      }
    }
    // The last one is not answered: there the world waits.
    while (daemon.state().time < SimTime(frames * 12ms)) std::this_thread::yield();
    daemon.stop();
    thread.join();
  }
  EXPECT_EQ(daemon.state().time, SimTime(frames * 12ms));
}

}  // namespace
}  // namespace nao::daemon

#include "daemon/child_process.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <csignal>
#include <string>
#include <vector>

#include "tests/core/temporary_folder.h"

namespace nao::daemon {
namespace {

sigset_t noSignals() {
  sigset_t none;
  ::sigemptyset(&none);
  return none;
}

int codeOf(const ChildProcess& child) {
  siginfo_t info{};
  EXPECT_EQ(::waitid(P_PID, static_cast<id_t>(child.id()), &info, WEXITED | WNOWAIT), 0);
  return child.findEnd().value_or(-1);
}

int codeOf(const std::vector<std::string>& command, const std::string& folder = ".") {
  return codeOf(ChildProcess({command, folder, {{"COLOR", "green"}}}, noSignals()));
}

TEST(ChildProcess, TellsHowItEnded) {
  EXPECT_EQ(codeOf({"sh", "-c", "exit 3"}), 3);
  EXPECT_EQ(codeOf({"sh", "-c", "kill -TERM $$"}), kBySignal + SIGTERM);
  EXPECT_EQ(codeOf({"no-such-program-anywhere"}), kNotFound);
  EXPECT_EQ(codeOf({"true"}, "/no-such-folder"), kNotFound);
  EXPECT_EQ(codeOf(ChildProcess([] { return 4; }, noSignals())), 4);
}

TEST(ChildProcess, TellsItAgain) {
  const ChildProcess child({{"sh", "-c", "exit 3"}, ".", {}}, noSignals());
  codeOf(child);
  EXPECT_EQ(child.findEnd(), 3);
}

TEST(ChildProcess, EndsWithItsObject) {
  pid_t process = 0;
  {
    const ChildProcess child({{"sleep", "1000"}, ".", {}}, noSignals());
    process = child.id();
    EXPECT_FALSE(child.hasEnded());
  }
  EXPECT_EQ(::kill(process, 0), -1);
}

TEST(ChildProcess, RunsInItsFolderWithItsEnvironment) {
  const TemporaryFolder folder;
  folder.write("inside", "");
  EXPECT_EQ(codeOf({"sh", "-c", "test -f inside && test $COLOR = green"}, folder.path()), 0);
}

}  // namespace
}  // namespace nao::daemon

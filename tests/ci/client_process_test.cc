#include "ci/client_process.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <csignal>

#include "tests/core/temporary_folder.h"

namespace nao::ci {
namespace {

int codeOf(const std::vector<std::string>& command, const std::string& folder = ".") {
  const ClientProcess client({command, folder, {{"COLOR", "green"}}});
  siginfo_t info{};
  EXPECT_EQ(::waitid(P_PID, static_cast<id_t>(client.id()), &info, WEXITED | WNOWAIT), 0);
  return client.findEnd().value_or(-1);
}

TEST(ClientProcess, TellsHowItEnded) {
  EXPECT_EQ(codeOf({"sh", "-c", "exit 3"}), 3);
  EXPECT_EQ(codeOf({"sh", "-c", "kill -TERM $$"}), 128 + SIGTERM);
  EXPECT_EQ(codeOf({"no-such-program-anywhere"}), 127);
}

TEST(ClientProcess, EndsWithItsObject) {
  pid_t process = 0;
  {
    const ClientProcess client({{"sleep", "1000"}, ".", {}});
    process = client.id();
    EXPECT_FALSE(client.findEnd());
  }
  EXPECT_EQ(::kill(process, 0), -1);
}

TEST(ClientProcess, RunsInItsFolderWithItsEnvironment) {
  const TemporaryFolder folder;
  folder.write("inside", "");
  EXPECT_EQ(codeOf({"sh", "-c", "test -f inside && test $COLOR = green"}, folder.path()), 0);
}

}  // namespace
}  // namespace nao::ci

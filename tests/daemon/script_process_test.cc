#include "daemon/script_process.h"

#include <gtest/gtest.h>

#include <optional>

#include "tests/core/temporary_folder.h"

namespace nao::daemon {
namespace {

// A module of that name in place of the real one.
class ScriptProcessTest : public testing::Test {
 protected:
  std::optional<std::string> run(const std::string& code, bool stop = false) {
    folder.write("usarnaoqi_behavior.py", code);
    std::optional<std::string> told;
    const auto process =
        ScriptProcess::start(io, {"some.xar", folder.path(), "127.0.0.1:1", token},
                             [&told](const std::string& failure) { told = failure; });
    EXPECT_FALSE(told);
    if (stop) process->stop();
    io.run();
    return told;
  }

  TemporaryFolder folder;
  std::string token;
  boost::asio::io_context io;
};

TEST_F(ScriptProcessTest, TellsOfItsEndAndWhetherItFailed) {
  const std::string check =
      "import sys\nif sys.argv[1:] != ['some.xar', '--address', '127.0.0.1:1']: sys.exit(5)\n";
  EXPECT_EQ(run(check), "");
  io.restart();
  EXPECT_NE(run("raise ValueError()").value_or(""), "");
}

TEST_F(ScriptProcessTest, KnowsWhoToSayItIsWhereThatIsAsked) {
  const std::string code =
      "import os, sys\nsys.exit(os.environ.get('USARNAOQI_TOKEN') != 'secret' or "
      "os.environ.get('USARNAOQI_USER') != 'usarnaoqi-script')\n";
  EXPECT_NE(run(code), "");
  io.restart();
  token = "secret";
  EXPECT_EQ(run(code), "");
}

TEST_F(ScriptProcessTest, EndsWhenAsked) {
  EXPECT_EQ(run("import signal\nsignal.pause()\n", true), "");
}

TEST_F(ScriptProcessTest, WhoLetsGoOfItEndsIt) {
  folder.write("usarnaoqi_behavior.py", "import signal\nsignal.pause()\n");
  bool told = false;
  ScriptProcess::start(io, {"some.xar", folder.path(), "127.0.0.1:1", ""},
                       [&told](const std::string&) { told = true; });
  io.run();
  EXPECT_FALSE(told);
}

}  // namespace
}  // namespace nao::daemon

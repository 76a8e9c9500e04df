// The program itself, cut off in the middle and started again, and as several processes: what it
// writes is the same to the byte.
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/check.h"
#include "tests/core/temporary_folder.h"
#include "tests/hidden/trial.h"

namespace nao::hidden {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

pid_t start(const std::vector<std::string>& words, const std::string& log) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const pid_t child = fork();
  NAO_CHECK(child >= 0);
  if (child != 0) return child;
  if (freopen(log.c_str(), "w", stdout) == nullptr || dup2(1, 2) < 0) _exit(127);
  execvp(arguments[0], arguments.data());
  _exit(127);
}

int exitCodeOf(pid_t child) {
  int status = 0;
  NAO_CHECK(waitpid(child, &status, 0) == child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

// Returns when a file that ends with `ending` has got its name in `folder`.
void awaitFile(const std::string& folder, const std::string& ending) {
  const int watch = inotify_init1(IN_CLOEXEC);
  NAO_CHECK(watch >= 0 && inotify_add_watch(watch, folder.c_str(), IN_MOVED_TO) >= 0);
  alignas(inotify_event) char buffer[4096];
  for (bool seen = false; !seen;) {
    const ssize_t got = ::read(watch, buffer, sizeof buffer);
    NAO_CHECK(got > 0);
    for (ssize_t at = 0; at < got;) {
      const auto* event = reinterpret_cast<const inotify_event*>(buffer + at);
      const std::string name = event->name;
      seen = seen || (name.size() > ending.size() &&
                      name.compare(name.size() - ending.size(), ending.size(), ending) == 0);
      at += static_cast<ssize_t>(sizeof *event + event->len);
    }
  }
  close(watch);
}

// Two joints of a set that is as short as can be.
class TakenUpAgain : public testing::Test {
 protected:
  TakenUpAgain() {
    HiddenCase hidden;
    hidden.kind = Kind::NearNull;
    hidden.seed = 700200;
    hidden.joints = {"HeadYaw", "HeadPitch"};
    hidden.repeats = 2;
    hidden.seconds = 1;
    hidden.limbs = true;
    TrialPlace place;
    place.program = NAO_PROGRAM;
    place.robots_dir = NAO_SOURCE_DIR "/robots";
    place.folder = folder_.path();
    set_ = sealSet(hidden, place).folder;
    whole_ = diagnosed("whole", {});
  }

  std::vector<std::string> command(const std::string& out, std::vector<std::string> before) const {
    for (const char* word : {NAO_PROGRAM, "diagnose"}) before.emplace_back(word);
    before.insert(before.end(), {set_, "--model", "nao_h21_v33", "--robots-dir",
                                 NAO_SOURCE_DIR "/robots", "--out", folder_.path() + "/" + out});
    return before;
  }
  std::string reports(const std::string& out) const {
    const fs::path folder = fs::path(folder_.path()) / out;
    EXPECT_FALSE(fs::exists(folder / "unfinished"));
    return read(folder / "report.json") + read(folder / "report.html");
  }
  std::string log() const { return folder_.path() + "/log.txt"; }
  std::vector<std::string> atLimbLevel(const std::string& out) const {
    std::vector<std::string> words = command(out, {});
    words.insert(words.end(), {"--level", "limb"});
    return words;
  }
  // report.json and report.html.
  std::string diagnosed(const std::string& out, const std::vector<std::string>& before) const {
    exitCodeOf(start(command(out, before), log()));
    return reports(out);
  }

  TemporaryFolder folder_;
  std::string set_, whole_;
};

TEST_F(TakenUpAgain, AfterItWasKilledItWritesTheSame) {
  ASSERT_GT(whole_.size(), 1000u);
  const std::string kept = folder_.path() + "/cut/unfinished";
  const std::string report = folder_.path() + "/cut/report.json";
  fs::create_directories(kept);
  std::ofstream(report) << "an earlier one";
  for (const auto& [unit, signal] : {std::pair(".look.unit", SIGKILL), {".verdict.unit", SIGINT}}) {
    const pid_t child = start(command("cut", {}), log());
    awaitFile(kept, unit);
    kill(child, signal);
    EXPECT_EQ(exitCodeOf(child), 128 + signal);
    EXPECT_EQ(read(report), "an earlier one");
  }
  EXPECT_NE(read(log()).find("the same command goes on"), std::string::npos) << read(log());
  EXPECT_EQ(diagnosed("cut", {}), whole_);
  EXPECT_NE(read(log()).find("going on with what is finished"), std::string::npos) << read(log());
}

// Where a whole limb is replayed each simulated run is kept.
TEST_F(TakenUpAgain, AtLimbLevelItWritesTheSameAfterItWasKilled) {
  const int said = exitCodeOf(start(atLimbLevel("limb"), log()));
  const std::string whole = reports("limb");
  ASSERT_GT(whole.size(), 1000u);
  const std::string kept = folder_.path() + "/cut/unfinished";
  fs::create_directories(kept);
  const pid_t child = start(atLimbLevel("cut"), log());
  for (int runs = 0; runs < 20; ++runs) awaitFile(kept, ".unit");
  kill(child, SIGKILL);
  EXPECT_EQ(exitCodeOf(child), 128 + SIGKILL);
  EXPECT_EQ(exitCodeOf(start(atLimbLevel("cut"), log())), said);
  EXPECT_EQ(reports("cut"), whole);
  EXPECT_NE(read(log()).find("going on with what is finished"), std::string::npos) << read(log());
}

TEST_F(TakenUpAgain, WhatIsOfOtherOptionsIsNotTakenUp) {
  const std::string kept = folder_.path() + "/other/unfinished";
  fs::create_directories(kept);
  std::vector<std::string> one_joint = command("other", {});
  one_joint.insert(one_joint.end(), {"--joint", "HeadYaw"});
  const pid_t child = start(one_joint, log());
  awaitFile(kept, ".look.unit");
  kill(child, SIGKILL);
  exitCodeOf(child);
  EXPECT_EQ(diagnosed("other", {}), whole_);
  EXPECT_NE(read(log()).find("begun anew"), std::string::npos) << read(log());
}

TEST_F(TakenUpAgain, SeveralProcessesWriteTheSameAsOne) {
  const std::string library = fs::path(NAO_PROGRAM).parent_path() / "libusarnaoqi_mpi.so";
  if (std::system("mpirun --version > /dev/null 2>&1") != 0 || !fs::exists(library)) {
    GTEST_SKIP() << "mpirun or Boost.MPI is not installed";
  }
  for (const char* count : {"2", "3"}) {  // of three one has nothing to do
    EXPECT_EQ(diagnosed(std::string("ranks") + count,
                        {"mpirun", "--allow-run-as-root", "--oversubscribe", "-n", count}),
              whole_)
        << read(log());
  }
}

}  // namespace
}  // namespace nao::hidden

#include "tests/sdk_cpp/robot_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>

namespace nao {
namespace {

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

std::vector<std::string> environmentWith(const std::vector<std::string>& settings) {
  std::vector<std::string> all = settings;
  for (char** entry = environ; *entry != nullptr; ++entry) all.emplace_back(*entry);
  return all;
}

std::vector<std::string> wordsOf(const std::vector<std::string>& options,
                                 const std::string& speed) {
  std::vector<std::string> words = {NAO_PROGRAM, "serve", "--robot", "nao_h25_v50",
                                    "--port",    "0",     "--speed", speed};
  words.insert(words.end(), options.begin(), options.end());
  return words;
}

}  // namespace

Process::Process(std::vector<std::string> words, std::vector<std::string> settings) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  std::vector<std::string> environment = environmentWith(settings);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  const int error = ::posix_spawn(&process_, words.front().c_str(), &actions, nullptr,
                                  pointersTo(words).data(), pointersTo(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  output_ = ends[0];
  if (error != 0) throw std::runtime_error("can not start " + words.front());
}

Process::~Process() {
  if (process_ != 0) {
    ::kill(process_, SIGTERM);
    wait();
  }
  ::close(output_);
}

std::string Process::readLine() {
  std::string line;
  for (char letter = 0; ::read(output_, &letter, 1) == 1 && letter != '\n';) line += letter;
  return line;
}

std::string Process::readLineWith(const std::string& text) {
  std::string line;
  do {
    line = readLine();
  } while (!line.empty() && line.find(text) == std::string::npos);
  return line;
}

void Process::interrupt() { ::kill(process_, SIGINT); }

int Process::wait() {
  int status = 0;
  ::waitpid(process_, &status, 0);
  process_ = 0;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

RobotProcess::RobotProcess(const std::vector<std::string>& options, const std::string& speed)
    : process_(wordsOf(options, speed)) {
  const std::string ready = process_.readLineWith("ready: ");
  const std::size_t colon = ready.rfind(':');
  if (ready.empty()) throw std::runtime_error("the daemon did not start");
  port_ = std::stoi(ready.substr(colon + 1));
}

}  // namespace nao

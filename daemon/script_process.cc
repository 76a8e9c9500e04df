#include "daemon/script_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/asio/buffer.hpp>
#include <cstring>
#include <utility>
#include <vector>

#include "core/check.h"
#include "naoqi_api/call_error.h"

namespace nao::daemon {
namespace {

constexpr int kAlive = 3;  // descriptor of the pipe in the process; it gets no others but 0 to 2

// This program's environment, with the Python client first where Python looks for modules, and who
// that is to say it is.
std::vector<std::string> environmentOf(const ScriptProcess::Job& job) {
  const std::string modules = job.modules.string();
  const std::string name = "PYTHONPATH=";
  std::string path = name + modules;
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (text.rfind(name, 0) != 0) {
      all.push_back(text);
    } else if (text.size() > name.size()) {
      path += ":" + text.substr(name.size());
    }
  }
  all.push_back(path);
  if (job.token.empty()) return all;
  all.push_back(std::string("USARNAOQI_USER=") + ScriptProcess::kUser);
  all.push_back("USARNAOQI_TOKEN=" + job.token);
  return all;
}

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

}  // namespace

std::shared_ptr<ScriptProcess> ScriptProcess::start(boost::asio::io_context& io, const Job& job,
                                                    Ended ended) {
  std::shared_ptr<ScriptProcess> process(new ScriptProcess(io, std::move(ended)));
  process->run(job);
  process->waitForEnd();
  return process;
}

ScriptProcess::ScriptProcess(boost::asio::io_context& io, Ended ended)
    : alive_(io), ended_(std::move(ended)) {}

ScriptProcess::~ScriptProcess() {
  if (process_ == 0) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

void ScriptProcess::stop() const {
  if (process_ != 0) ::kill(process_, SIGTERM);
}

void ScriptProcess::run(const Job& job) {
  int ends[2];
  NAO_CHECK(::pipe2(ends, O_CLOEXEC) == 0);
  alive_.assign(ends[0]);
  std::vector<std::string> words = {"python3",         "-m",        "usarnaoqi_behavior",
                                    job.file.string(), "--address", job.address};
  std::vector<std::string> environment = environmentOf(job);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], kAlive);
  posix_spawn_file_actions_addclosefrom_np(&actions, kAlive + 1);
  pid_t process = 0;
  const int error = ::posix_spawnp(&process, "python3", &actions, nullptr, pointersTo(words).data(),
                                   pointersTo(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  if (error != 0) {
    throw rpc::CallError(std::string("python3 can not be started: ") + std::strerror(error));
  }
  process_ = process;
}

// When the process has ended, its end of the pipe is closed.
void ScriptProcess::waitForEnd() {
  alive_.async_read_some(
      boost::asio::buffer(&nothing_, 1),
      [weak = weak_from_this()](const boost::system::error_code& error, std::size_t /*count*/) {
        const auto self = weak.lock();
        if (!self || error == boost::asio::error::operation_aborted) return;
        int status = 0;
        ::waitpid(self->process_, &status, 0);
        self->process_ = 0;
        const bool well = WIFSIGNALED(status) || WEXITSTATUS(status) == 0;
        self->ended_(well ? "" : "code in its boxes failed; the simulator's output tells where");
      });
}

}  // namespace nao::daemon

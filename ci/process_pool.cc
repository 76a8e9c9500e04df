#include "ci/process_pool.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <ctime>
#include <map>

#include "daemon/child_process.h"

namespace nao::ci {
namespace {

using Wall = std::chrono::steady_clock;

constexpr timespec kLook{0, 200'000'000};  // between two looks at who takes too long

struct Running {
  std::size_t job;
  Wall::time_point start;
  bool slow = false;
};

sigset_t justChildren() {
  sigset_t children;
  ::sigemptyset(&children);
  ::sigaddset(&children, SIGCHLD);
  return children;
}

// Reads nothing and writes into the file.
bool speakInto(const std::string& output) {
  const int file = ::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (file < 0 || nothing < 0) return false;
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(file, STDOUT_FILENO);
  ::dup2(file, STDERR_FILENO);
  return true;
}

pid_t start(const PoolJob& job, const sigset_t& mask) {
  const daemon::Words words(job.command);
  const auto work = [&] { return speakInto(job.output) ? words.become() : daemon::kNotFound; };
  return daemon::startChild(work, mask, SIGTERM);
}

void endSlow(std::map<pid_t, Running>& running, double longest) {
  const auto now = Wall::now();
  for (auto& [process, job] : running) {
    if (std::chrono::duration<double>(now - job.start).count() < longest) continue;
    // First asked, then ended: a second look later.
    ::kill(process, job.slow ? SIGKILL : SIGTERM);
    job.slow = true;
  }
}

}  // namespace

void runPool(const std::vector<PoolJob>& jobs, std::size_t at_a_time, double longest,
             const std::function<void(std::size_t job, const PoolEnd& end)>& ended) {
  const sigset_t children = justChildren();
  sigset_t before;
  ::pthread_sigmask(SIG_BLOCK, &children, &before);
  std::map<pid_t, Running> running;
  for (std::size_t next = 0; next < jobs.size() || !running.empty();) {
    while (next < jobs.size() && running.size() < at_a_time) {
      const pid_t process = start(jobs[next], before);
      running[process] = {next++, Wall::now()};
    }
    int status = 0;
    pid_t process = 0;
    while ((process = ::waitpid(-1, &status, WNOHANG)) > 0) {
      const auto found = running.find(process);
      if (found == running.end()) continue;
      const Running done = found->second;
      running.erase(found);
      PoolEnd end;
      end.code = daemon::exitCodeOf(status);
      end.slow = done.slow;
      end.wall = std::chrono::duration<double>(Wall::now() - done.start).count();
      ended(done.job, end);
    }
    endSlow(running, longest);
    if (running.size() < at_a_time && next < jobs.size()) continue;
    if (!running.empty()) ::sigtimedwait(&children, nullptr, &kLook);
  }
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

}  // namespace nao::ci

#include "bench/server_watch.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace nao::bench {

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double processorTime(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(file, text);
  text = text.substr(text.rfind(')') + 2);
  unsigned long user = 0;
  unsigned long system = 0;
  std::sscanf(text.c_str(), "%*c %*d %*d %*d %*d %*d %*u %*u %*u %*u %*u %lu %lu", &user, &system);
  return static_cast<double>(user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

ServerWatch::ServerWatch(const WireServer& server)
    : server_(server),
      start_(Clock::now()),
      processor_s_(processorTime(server.process)),
      cycles_(server.lateness->count.load(std::memory_order_acquire)) {}

double ServerWatch::cpuPercent() const {
  return 100 * (processorTime(server_.process) - processor_s_) / secondsSince(start_);
}

double ServerWatch::latenessP99Ms() const {
  std::vector<double> late;
  const std::size_t end = server_.lateness->count.load(std::memory_order_acquire);
  for (std::size_t k = cycles_; k < end; ++k) {
    late.push_back(double{server_.lateness->late_ms[k % Lateness::kMost]});
  }
  std::sort(late.begin(), late.end());
  return late.empty() ? 0 : late[late.size() * 99 / 100];
}

}  // namespace nao::bench

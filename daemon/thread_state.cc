#include "daemon/thread_state.h"

#include <unistd.h>

#include <fstream>
#include <sstream>
#include <string>

namespace nao::daemon {
namespace {

struct Stat {
  char state = 'X';
  double processor = 0;  // [s]
};

// /proc/.../stat: its second word is a name in brackets and may hold anything.
Stat readStat(const std::string& path) {
  std::ifstream file(path);
  std::string text;
  std::getline(file, text);
  const std::size_t name = text.rfind(')');
  if (name == std::string::npos) return {};
  std::istringstream words(text.substr(name + 1));
  Stat stat;
  words >> stat.state;
  std::string skipped;
  for (int i = 0; i < 10; ++i) words >> skipped;  // words 4 to 13
  double user = 0;
  double system = 0;
  words >> user >> system;
  stat.processor = (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
  return stat;
}

Stat statOf(std::int32_t process, std::int32_t thread) {
  return readStat("/proc/" + std::to_string(process) + "/task/" + std::to_string(thread) + "/stat");
}

}  // namespace

bool isAlive(std::int32_t process) {
  const char state = readStat("/proc/" + std::to_string(process) + "/stat").state;
  return state != 'X' && state != 'Z';
}

double processorTime(std::int32_t process, std::int32_t thread) {
  return statOf(process, thread).processor;
}

bool isAsleep(std::int32_t process, std::int32_t thread) {
  const char state = statOf(process, thread).state;
  return state == 'S' || state == 'D';
}

}  // namespace nao::daemon

#include <qi/os.hpp>

#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

namespace qi::os {

void sleep(unsigned int seconds) { std::this_thread::sleep_for(std::chrono::seconds(seconds)); }

void msleep(unsigned int milliseconds) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

int gettimeofday(timeval* time) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto us = std::chrono::duration_cast<std::chrono::microseconds>(now).count();
  constexpr long long kSecond = 1000000;
  time->tv_sec = us / kSecond;
  time->tv_usec = us % kSecond;
  return 0;
}

long long ustime() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(now).count();
}

std::string getenv(const char* name) {
  const char* text = std::getenv(name);
  return text ? text : "";
}

int setenv(const char* name, const char* value) { return ::setenv(name, value, 1); }

std::string gethostname() {
  char name[256] = "";
  ::gethostname(name, sizeof name - 1);
  return name;
}

std::string home() { return getenv("HOME"); }

std::string tmp() { return std::filesystem::temp_directory_path().string(); }

int getpid() { return static_cast<int>(::getpid()); }

}  // namespace qi::os

#include <qi/log.hpp>

#include <atomic>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

namespace qi::log {
namespace {

int startLevel() {
  const char* text = std::getenv("QI_LOG_LEVEL");
  return text ? std::atoi(text) : LogLevel_Info;
}

std::atomic<int>& level() {
  static std::atomic<int> the_level{startLevel()};
  return the_level;
}

constexpr const char* kLetters[] = {"", "[F]", "[E]", "[W]", "[I]", "[V]", "[D]"};

}  // namespace

void setVerbosity(LogLevel wanted) { level() = wanted; }

LogLevel verbosity() { return static_cast<LogLevel>(level().load()); }

void write(LogLevel its, const std::string& category, const std::string& text) {
  if (its > verbosity() || its == LogLevel_Silent) return;
  std::string line = std::string(kLetters[its]) + " " + category + ": " + text;
  if (line.back() != '\n') line += '\n';
  std::fputs(line.c_str(), stderr);
}

Line::Line(LogLevel its, const std::string& category, const char* format, ...)
    : level_(its), category_(category) {
  char text[4096];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  text_ << text;
}

}  // namespace qi::log

#pragma once
// Without warnings on __VA_OPT__, which g++ and clang++ know before C++20, too.
#pragma GCC system_header

#include <sstream>
#include <string>

#include <usarnaoqi_sdk/export.h>

namespace qi {

enum LogLevel {
  LogLevel_Silent = 0,
  LogLevel_Fatal,
  LogLevel_Error,
  LogLevel_Warning,
  LogLevel_Info,
  LogLevel_Verbose,
  LogLevel_Debug
};

namespace log {

/// Messages up to this level are written to stderr; Info at first, or what QI_LOG_LEVEL (0 to 6)
/// says.
USARNAOQI_SDK_API void setVerbosity(LogLevel level);
USARNAOQI_SDK_API LogLevel verbosity();
inline void setLogLevel(LogLevel level) { setVerbosity(level); }
inline LogLevel logLevel() { return verbosity(); }
inline void init(LogLevel level = LogLevel_Info, int = 0, bool = true) { setVerbosity(level); }
inline void destroy() {}
inline void flush() {}

/// Writes one line, whole, whatever other threads write.
USARNAOQI_SDK_API void write(LogLevel level, const std::string& category, const std::string& text);

/// A line under way: what is streamed into it, written at its end.
class USARNAOQI_SDK_API Line {
 public:
  Line(LogLevel level, const std::string& category) : level_(level), category_(category) {}
  /// Starts it with a text as printf makes it.
  Line(LogLevel level, const std::string& category, const char* format, ...)
      __attribute__((format(printf, 4, 5)));
  ~Line() { write(level_, category_, text_.str()); }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  template <class T>
  Line& operator<<(const T& item) {
    text_ << item;
    return *this;
  }
  Line& operator<<(std::ostream& (*manipulator)(std::ostream&)) {
    text_ << manipulator;
    return *this;
  }

 private:
  LogLevel level_;
  std::string category_;
  std::ostringstream text_;
};

}  // namespace log
}  // namespace qi

/// Names the category of the messages below that name none.
#define qiLogCategory(category) \
  static const char* const _QI_LOG_CATEGORY __attribute__((unused)) = (category)

// qiLogInfo("category") << "text", qiLogInfo("category", "%d", 1), or qiLogInfo() << "text" below a
// qiLogCategory.
#define USARNAOQI_LOG_FIRST(first, ...) first
#define USARNAOQI_LOG_REST(first, ...) __VA_OPT__(, ) __VA_ARGS__
#define USARNAOQI_LOG(level, ...)                                                              \
  ::qi::log::Line((level), USARNAOQI_LOG_FIRST(__VA_ARGS__ __VA_OPT__(, ) _QI_LOG_CATEGORY, 0) \
                               USARNAOQI_LOG_REST(__VA_ARGS__))
#define qiLogFatal(...) USARNAOQI_LOG(::qi::LogLevel_Fatal __VA_OPT__(, ) __VA_ARGS__)
#define qiLogError(...) USARNAOQI_LOG(::qi::LogLevel_Error __VA_OPT__(, ) __VA_ARGS__)
#define qiLogWarning(...) USARNAOQI_LOG(::qi::LogLevel_Warning __VA_OPT__(, ) __VA_ARGS__)
#define qiLogInfo(...) USARNAOQI_LOG(::qi::LogLevel_Info __VA_OPT__(, ) __VA_ARGS__)
#define qiLogVerbose(...) USARNAOQI_LOG(::qi::LogLevel_Verbose __VA_OPT__(, ) __VA_ARGS__)
#define qiLogDebug(...) USARNAOQI_LOG(::qi::LogLevel_Debug __VA_OPT__(, ) __VA_ARGS__)

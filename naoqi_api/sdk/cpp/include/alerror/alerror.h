#pragma once

#include <stdexcept>
#include <string>

#include <usarnaoqi_sdk/export.h>

namespace AL {

/// What every call of the SDK throws: which module and method, and why. what() is the text as NaoQi
/// writes it: "\tmodule::method\n\tdescription".
class USARNAOQI_SDK_API ALError : public std::runtime_error {
 public:
  ALError(const std::string& module, const std::string& method, const std::string& description,
          const std::string& file = std::string(), unsigned int line = 0);
  ~ALError() throw();

  /// A robot's answer to module.method. One that is in NaoQi's shape already is kept as it is.
  static ALError ofAnswer(const std::string& module, const std::string& method,
                          const std::string& text);

  std::string toString() const { return what(); }
  const std::string& getModuleName() const { return module_; }
  const std::string& getMethodName() const { return method_; }
  const std::string& getDescription() const { return description_; }
  const std::string& getFileName() const { return file_; }
  unsigned int getLine() const { return line_; }

 private:
  struct Whole {};
  ALError(Whole, const std::string& module, const std::string& method, const std::string& text);

  std::string module_;
  std::string method_;
  std::string description_;
  std::string file_;
  unsigned int line_;
};

}  // namespace AL

#define ALERROR(module, method, description) \
  ::AL::ALError((module), (method), (description), __FILE__, __LINE__)

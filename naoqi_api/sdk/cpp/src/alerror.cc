#include <alerror/alerror.h>

namespace AL {

ALError::ALError(const std::string& module, const std::string& method,
                 const std::string& description, const std::string& file, unsigned int line)
    : std::runtime_error("\t" + module + "::" + method + "\n\t" + description),
      module_(module),
      method_(method),
      description_(description),
      file_(file),
      line_(line) {}

ALError::ALError(Whole /*text*/, const std::string& module, const std::string& method,
                 const std::string& text)
    : std::runtime_error(text), module_(module), method_(method), description_(text), line_(0) {}

ALError::~ALError() throw() = default;

ALError ALError::ofAnswer(const std::string& module, const std::string& method,
                          const std::string& text) {
  const bool in_shape = !text.empty() && text.front() == '\t';
  return in_shape ? ALError(Whole(), module, method, text) : ALError(module, method, text);
}

}  // namespace AL

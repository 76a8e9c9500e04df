#pragma once

#include <tinyxml2.h>

#include <string>
#include <vector>

namespace nao::motion {

/// Parses a motion file in XML. Where it is not well-formed it is mended (mendXml).
/// @returns what was broken, "source:line: ...". @throws InputError if it is beyond mending.
std::vector<std::string> parseXml(tinyxml2::XMLDocument& document, const std::string& text,
                                  const std::string& source);

/// One element of a behavior. What version 3 writes as an attribute, version 1 writes as a child
/// element of that name; both are read alike here.
class XarElement {
 public:
  XarElement(const tinyxml2::XMLElement* element, const std::string* source)
      : element_(element), source_(source) {}

  explicit operator bool() const { return element_ != nullptr; }
  std::string name() const { return element_->Name(); }

  XarElement child(const char* name) const;
  std::vector<XarElement> children(const char* name) const;

  /// The text of an attribute or child element; `missing` if there is neither.
  std::string text(const char* name, const std::string& missing = {}) const;

  std::string ownText() const;  // what stands between its own tags

  /// The same as a finite number. @throws InputError if the text is no number.
  double number(const char* name, double missing) const;
  double number(const char* name) const;  // @throws InputError if missing

  bool flag(const char* name, bool missing) const;  // a number, or "true" or "false"

  /// @throws InputError "source:line: message".
  [[noreturn]] void fail(const std::string& message) const;
  std::string place() const;  // "source:line"

 private:
  const tinyxml2::XMLElement* element_;
  const std::string* source_;
};

}  // namespace nao::motion

#include "motion/timeline/xar_element.h"

#include <cmath>
#include <cstdlib>

#include "core/check.h"
#include "motion/timeline/xml_mender.h"

namespace nao::motion {

std::vector<std::string> parseXml(tinyxml2::XMLDocument& document, const std::string& text,
                                  const std::string& source) {
  if (document.Parse(text.data(), text.size()) == tinyxml2::XML_SUCCESS) return {};
  const std::string at_line = source + ":" + std::to_string(document.ErrorLineNum());
  const MendedXml mended = mendXml(text);
  if (document.Parse(mended.text.data(), mended.text.size()) != tinyxml2::XML_SUCCESS) {
    throw InputError(at_line + ": this is not well-formed XML");
  }
  std::vector<std::string> broken;
  for (const MendedXml::Break& b : mended.breaks) {
    broken.push_back(source + ":" + std::to_string(b.line) + ": no well-formed XML: " + b.sentence);
  }
  return broken;
}

XarElement XarElement::child(const char* name) const {
  return {element_ == nullptr ? nullptr : element_->FirstChildElement(name), source_};
}

std::vector<XarElement> XarElement::children(const char* name) const {
  std::vector<XarElement> found;
  if (element_ == nullptr) return found;
  for (auto* e = element_->FirstChildElement(name); e != nullptr; e = e->NextSiblingElement(name)) {
    found.emplace_back(e, source_);
  }
  return found;
}

std::string XarElement::text(const char* name, const std::string& missing) const {
  if (const char* attribute = element_->Attribute(name)) return attribute;
  const tinyxml2::XMLElement* written_out = element_->FirstChildElement(name);
  if (written_out == nullptr) return missing;
  const char* text = written_out->GetText();
  return text == nullptr ? "" : text;
}

std::string XarElement::ownText() const {
  const char* text = element_->GetText();
  return text == nullptr ? "" : text;
}

double XarElement::number(const char* name, double missing) const {
  const std::string digits = text(name);
  if (digits.empty()) return missing;
  char* end = nullptr;
  const double value = std::strtod(digits.c_str(), &end);
  if (*end != '\0' || !std::isfinite(value)) {
    fail(std::string(name) + " must be a number, not \"" + digits.substr(0, 40) + "\"");
  }
  return value;
}

double XarElement::number(const char* name) const {
  if (text(name).empty()) fail(this->name() + " lacks its " + name);
  return number(name, 0);
}

bool XarElement::flag(const char* name, bool missing) const {
  const std::string word = text(name);
  if (word == "true" || word == "false") return word == "true";
  return number(name, missing ? 1 : 0) != 0;
}

void XarElement::fail(const std::string& message) const {
  throw InputError(place() + ": " + message);
}

std::string XarElement::place() const {
  return *source_ + ":" + std::to_string(element_->GetLineNum());
}

}  // namespace nao::motion

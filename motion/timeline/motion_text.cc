#include "motion/timeline/motion_text.h"

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "core/check.h"

namespace nao::motion {
namespace {

constexpr std::size_t kMostQuoted = 40;  // characters of a wrong word in a message

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(" \t\r");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

}  // namespace

MotionText::MotionText(const std::string& text, std::string source_name)
    : source(std::move(source_name)) {
  std::istringstream in(text);
  std::string line;
  while (std::getline(in, line)) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    lines.push_back({static_cast<int>(lines.size()) + 1, line});
  }
}

void MotionText::fail(int line, const std::string& message) const {
  throw InputError(place(line) + ": " + message);
}

std::string MotionText::place(int line) const { return source + ":" + std::to_string(line); }

double MotionText::number(const std::string& word, int line, const char* what) const {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0' || !std::isfinite(value)) {
    fail(line,
         std::string(what) + " must be a number, not \"" + word.substr(0, kMostQuoted) + "\"");
  }
  return value;
}

std::vector<std::string> splitAt(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::string part;
  std::istringstream in(text);
  while (std::getline(in, part, separator)) parts.push_back(trimmed(part));
  return parts;
}

std::vector<std::string> wordsOf(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

}  // namespace nao::motion

#include <alerror/alerror.h>
#include <alvalue/alvalue.h>

#include <cstdlib>
#include <limits>
#include <sstream>

// value := array | text | number | "true" | "false"
// array := "[" [value {"," value}] "]"
// text  := '"' {character} '"' | "'" {character} "'"    a backslash takes the next character as it
// is

namespace AL {
namespace {

[[noreturn]] void refuse(const std::string& wanted, const std::string& found) {
  throw ALError("ALValue", "unSerializeFromText",
                "expected " + wanted + ", found " + (found.empty() ? "the end" : found));
}

class Reader {
 public:
  explicit Reader(std::string text) : text_(std::move(text)) {}

  /// The one value of the whole text; none of an empty one.
  ALValue readAll() {
    if (next() == '\0') return {};
    ALValue value = read();
    if (next() != '\0') refuse("the end", text_.substr(at_));
    return value;
  }

 private:
  char next() {
    at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  ALValue read() {
    const char first = next();
    if (first == '[') return readArray();
    if (first == '"' || first == '\'') return readText(first);
    return readWord();
  }

  ALValue readArray() {
    if (++depth_ > kDeepest) refuse("arrays that are less deep", "one more");
    ALValue array;
    array.arraySetSize(0);
    ++at_;
    for (bool is_first = true; next() != ']'; is_first = false) {
      if (!is_first && text_[at_] != ',') refuse("',' or ']'", text_.substr(at_));
      if (!is_first) ++at_;
      array.arrayPush(read());
    }
    ++at_;
    --depth_;
    return array;
  }

  ALValue readText(char quote) {
    std::string text;
    for (++at_; at_ < text_.size() && text_[at_] != quote; ++at_) {
      if (text_[at_] == '\\' && at_ + 1 < text_.size()) ++at_;
      text += text_[at_];
    }
    if (at_ == text_.size()) refuse(std::string("a closing ") + quote, "");
    ++at_;
    return text;
  }

  ALValue readWord() {
    const std::size_t end = std::min(text_.find_first_of(",] \t\r\n", at_), text_.size());
    const std::string word = text_.substr(at_, end - at_);
    at_ = end;
    if (word == "true" || word == "false") return word == "true";
    char* rest = nullptr;
    const long whole = std::strtol(word.c_str(), &rest, 10);
    using Limits = std::numeric_limits<int>;
    if (!word.empty() && *rest == '\0' && whole >= Limits::min() && whole <= Limits::max())
      return static_cast<int>(whole);
    const float number = std::strtof(word.c_str(), &rest);
    if (word.empty() || *rest != '\0') refuse("a value", word);
    return number;
  }

  static constexpr int kDeepest = 100;  // free: no value of NaoQi comes near it

  std::string text_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

std::string quoted(const std::string& text) {
  std::string all = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') all += '\\';
    all += letter;
  }
  return all + '"';
}

// With all its digits, and so that it does not look like an int.
std::string written(float number) {
  std::ostringstream text;
  text.precision(std::numeric_limits<float>::max_digits10);
  text << number;
  const bool looks_whole = text.str().find_first_not_of("-0123456789") == std::string::npos;
  return text.str() + (looks_whole ? ".0" : "");
}

std::string cut(const char* text, int limit) {
  const std::string all = text;
  return all.substr(0, static_cast<std::size_t>(std::max(limit, 0)));
}

}  // namespace

std::string ALValue::serializeToText() const {
  if (isBinary() || isObject()) fail("a value without bytes");
  if (isString()) return quoted(text_);
  if (isFloat()) return written(number_.real);
  if (!isArray()) return toString();
  std::string text = "[";
  for (std::size_t i = 0; i < items_.size(); ++i)
    text += (i == 0 ? "" : ", ") + items_[i].serializeToText();
  return text + ']';
}

void ALValue::unSerializeFromText(const char* text, int limit) {
  *this = Reader(cut(text, limit)).readAll();
}

ALValue::Type ALValue::deduceType(const char* text, int limit) {
  return Reader(cut(text, limit)).readAll().getType();
}

}  // namespace AL

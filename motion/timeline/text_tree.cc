#include "motion/timeline/text_tree.h"

#include <cctype>

#include "core/check.h"

namespace nao::motion {
namespace {

constexpr int kDeepest = 50;  // of brackets in brackets; free choice

class Parser {
 public:
  Parser(const std::string& content, const MotionText& text) : content_(content), text_(text) {}

  // Throws where it can not go on; what was read until then is in `all`.
  void readAll(TextTree& all) {
    skip();
    if (peek() == '{') return readValue(all, 0);
    while (skip(), !atEnd()) readMember(all, 0);
  }

 private:
  bool atEnd() const { return at_ >= content_.size(); }
  char peek() const { return atEnd() ? '\0' : content_[at_]; }
  [[noreturn]] void expected(const std::string& what) { text_.fail(line_, "expected " + what); }

  void advance() {
    if (peek() == '\n') ++line_;
    ++at_;
  }

  // Blanks, comments and the signs between values.
  void skip() {
    while (!atEnd()) {
      if (content_.compare(at_, 2, "//") == 0) {
        while (!atEnd() && peek() != '\n') advance();
      } else if (std::isspace(static_cast<unsigned char>(peek())) || peek() == ',' ||
                 peek() == ';') {
        advance();
      } else {
        return;
      }
    }
  }

  std::string readWord() {
    std::string word;
    if (peek() == '"') {
      advance();
      while (!atEnd() && peek() != '"') word += peek(), advance();
      if (atEnd()) expected("a closing quote");
      advance();
      return word;
    }
    const std::string ends = ",;:=[]{}\"";
    while (!atEnd() && ends.find(peek()) == std::string::npos &&
           !std::isspace(static_cast<unsigned char>(peek()))) {
      word += peek(), advance();
    }
    return word;
  }

  void readMember(TextTree& tree, int depth) {
    const std::string name = readWord();
    skip();
    if (name.empty() || (peek() != ':' && peek() != '=')) expected("a name and a value");
    advance();
    tree.members.emplace_back(name, TextTree());
    readValue(tree.members.back().second, depth);
  }

  void readValue(TextTree& value, int depth) {
    if (depth > kDeepest) text_.fail(line_, "brackets are nested too deeply");
    skip();
    value.line = line_;
    const char open = peek();
    if (open != '{' && open != '[') {
      const bool quoted = open == '"';
      value.word = readWord();
      if (value.word.empty() && !quoted) expected("a value");
      return;
    }
    const char close = open == '{' ? '}' : ']';
    advance();
    while (skip(), peek() != close) {
      if (atEnd()) expected(std::string("a closing ") + close);
      if (open == '{') {
        readMember(value, depth + 1);
      } else {
        value.items.emplace_back();
        readValue(value.items.back(), depth + 1);
      }
    }
    advance();
  }

  const std::string& content_;
  const MotionText& text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace

const TextTree* TextTree::find(const std::string& name) const {
  for (const auto& [key, value] : members) {
    if (key == name) return &value;
  }
  return nullptr;
}

TextTree readTextTree(const std::string& content, const MotionText& text,
                      std::vector<std::string>& broken) {
  TextTree all;
  try {
    Parser(content, text).readAll(all);
  } catch (const InputError& error) {
    broken.push_back(error.what());
  }
  return all;
}

}  // namespace nao::motion

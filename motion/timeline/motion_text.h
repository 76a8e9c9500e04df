#pragma once

#include <string>
#include <vector>

namespace nao::motion {

/// One line of a motion file in plain text.
struct TextLine {
  int number = 1;  // from 1, for messages
  std::string text;
};

/// A motion file in plain text, cut into lines without their ends, and its name for messages.
struct MotionText {
  MotionText(const std::string& text, std::string source_name);

  /// @throws InputError "source:line: message".
  [[noreturn]] void fail(int line, const std::string& message) const;
  std::string place(int line) const;  // "source:line"

  /// A finite number. @throws InputError if `word` is none; `what` says what was expected.
  double number(const std::string& word, int line, const char* what) const;

  std::string source;
  std::vector<TextLine> lines;
};

/// The parts between separators, without blanks around them.
std::vector<std::string> splitAt(const std::string& text, char separator);

/// The parts between blanks.
std::vector<std::string> wordsOf(const std::string& text);

}  // namespace nao::motion

#pragma once

#include <string>
#include <vector>

namespace nao::motion {

/// XML that was not well-formed, made so by leaving out what is broken.
struct MendedXml {
  struct Break {
    int line = 1;
    std::string sentence;  // what was wrong there and what was done
  };
  std::string text;  // its lines are those of the broken text
  std::vector<Break> breaks;
};

/// Leaves out tags that are not well-formed and ends of what is not open, and closes what is left
/// open: where an element around it ends, where one of the same name follows directly (no motion
/// file has an element directly in one of its own name), or where the text ends.
MendedXml mendXml(const std::string& text);

}  // namespace nao::motion

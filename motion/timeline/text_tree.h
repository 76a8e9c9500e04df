#pragma once

#include <string>
#include <utility>
#include <vector>

#include "motion/timeline/motion_text.h"

namespace nao::motion {

/// A value of a structured text: JSON, or the "name = value;" files of B-Human's relatives, which
/// differ only in their signs. Comments begin with two slashes.
struct TextTree {
  int line = 1;
  std::string word;  // of a plain value, without quotes
  std::vector<TextTree> items;
  std::vector<std::pair<std::string, TextTree>> members;

  const TextTree* find(const std::string& name) const;  // nullptr if there is no such member
};

/// Reads up to where brackets or names are missing, and tells that with source and line in
/// `broken`.
TextTree readTextTree(const std::string& content, const MotionText& text,
                      std::vector<std::string>& broken);

}  // namespace nao::motion

#pragma once

#include <string>

namespace nao::validation {

/// What a report was made of, so that others can make it again.
struct Provenance {
  std::string set, model, command;
  std::string level = "joint";
  std::string set_sha256{}, model_sha256{};  // of their folders
  int test_openings = 0;                     // of the set, so far
};

/// In HTML: set, model and level, one clause.
std::string originInHtml(const Provenance& provenance);
/// In HTML: a paragraph with the command and what must be the same for it.
std::string commandInHtml(const Provenance& provenance);

}  // namespace nao::validation

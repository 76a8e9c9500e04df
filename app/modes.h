#pragma once

#include <map>
#include <string>

#include "core/check.h"
#include "runtime/simulation.h"

namespace nao::app {

/// The mode that --mode names. @throws InputError for another word.
inline sim::Mode parseMode(const std::string& word) {
  static const std::map<std::string, sim::Mode> modes{{"implicit", sim::Mode::Implicit},
                                                      {"rk4", sim::Mode::Rk4},
                                                      {"reference", sim::Mode::Reference}};
  const auto at = modes.find(word);
  if (at != modes.end()) return at->second;
  throw InputError("--mode: expected implicit, rk4 or reference, found '" + word + "'");
}

}  // namespace nao::app

#pragma once

#include <string>

#include "ci/scenario.h"
#include "tests/core/temporary_folder.h"

namespace nao::ci {

inline Places shippedPlaces() { return {NAO_SOURCE_DIR "/worlds", NAO_SOURCE_DIR "/robots"}; }

/// A scenario that is whole and says `more` besides.
inline std::string scenarioText(const std::string& more) {
  return "about: A test.\nduration: 10\n" + more;
}

inline Scenario loadText(const std::string& text, std::uint64_t seed = 1) {
  const TemporaryFolder folder;
  return loadScenario(folder.write("s.yaml", text), seed, shippedPlaces());
}

inline const runtime::WorldRequest& requestOf(const Event& event) {
  return std::get<runtime::WorldRequest>(event.deed);
}

}  // namespace nao::ci

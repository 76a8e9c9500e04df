#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace nao::hidden {

/// A line of results.jsonl: what was hidden in a set, what was said of it, and its score.
/// @throws InputError for a line that is no JSON.
nlohmann::ordered_json parseResult(const std::string& line);

}  // namespace nao::hidden

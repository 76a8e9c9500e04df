#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "core/config_node.h"

namespace nao::ci {

/// Draws the numbers of a scenario's `spread`, `name: [low, high]`, evenly between both, each from
/// a stream of its own; and puts them in wherever a whole value reads `$name`. Afterwards the file
/// has no `spread` any more.
/// @throws InputError for a `$name` that is not in it, a name that is not used, and a range that
/// is none.
std::map<std::string, double> drawSpread(ConfigNode& scenario, std::uint64_t seed);

}  // namespace nao::ci

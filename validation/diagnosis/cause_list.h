#pragma once

#include <string>

namespace nao::validation {

/// Every cause that a diagnosis tries, one per line: id, numbers, what it is tried on first.
std::string listCausesAsText();
/// One of them at length. @throws InputError for an id that is not in the catalogue.
std::string showCause(const std::string& id);

}  // namespace nao::validation

#pragma once

#include <string>

namespace nao::validation {

/// A value as bytes, exactly: for files that the same program reads again and for other processes
/// of it. For the types that a source names by NAO_PACKED (packed_as.h).
template <class T>
std::string pack(const T& value);
/// @throws InputError for bytes that are no such value.
template <class T>
T unpack(const std::string& bytes);

}  // namespace nao::validation

#pragma once

#include <string>
#include <vector>

namespace nao::validation {

/// SHA-256 of what a folder's files hold, with their names, in hexadecimal digits: the same for
/// every copy of the folder. Files and folders below it that are named in `except` do not count.
/// @throws InputError if the folder or a file of it can not be read.
std::string sha256OfFolder(const std::string& folder, const std::vector<std::string>& except = {});

/// The same of a text.
std::string sha256Of(const std::string& text);

}  // namespace nao::validation

#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace nao {

/// Writes all of `text` and replaces what stood in `file`. Throws InputError that begins with
/// `option` (of the command line, or nothing) and the file's name, also where a disk is full.
void writeFile(const std::string& option, const std::string& file, const std::string& text);

/// Adds `text` at the end of `file`; throws as writeFile does.
void appendToFile(const std::string& option, const std::string& file, const std::string& text);

/// What a folder holds, by name. Throws InputError where it can not be read.
std::vector<std::filesystem::path> listFolder(const std::filesystem::path& folder);

/// The same without a word where it can not be read: then there is nothing, or nothing more.
std::vector<std::filesystem::path> listReadable(const std::filesystem::path& folder);

/// The files in a folder and in those below it, by name; links to folders are not followed. Throws
/// InputError where any of them can not be read.
std::vector<std::filesystem::path> listFilesBelow(const std::filesystem::path& folder);

/// The same without those that may not be read.
std::vector<std::filesystem::path> listReadableBelow(const std::filesystem::path& folder);

}  // namespace nao

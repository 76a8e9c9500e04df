#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace nao::services {

/// What clients may store below the data directory, in all; free.
inline constexpr std::uintmax_t kDataQuota = 64U << 20U;  // [bytes]

/// Where a client's file name leads: always below `data_dir`, an absolute name too. @throws
/// CallError if there is no data directory, or the name would lead out of it (.. or a link).
std::filesystem::path dataPath(const std::filesystem::path& data_dir, const std::string& name);

/// The same for a file that is there, or nothing.
std::optional<std::filesystem::path> findDataFile(const std::filesystem::path& data_dir,
                                                  const std::string& name);

/// Writes a client's file. @throws CallError as dataPath(), if it can not be written, or if the
/// quota would be exceeded.
void writeDataFile(const std::filesystem::path& data_dir, const std::string& name,
                   const std::string& content);

}  // namespace nao::services

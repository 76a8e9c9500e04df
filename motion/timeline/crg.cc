#include "motion/timeline/crg.h"

#include <cstdlib>
#include <optional>

#include "core/check.h"
#include "motion/timeline/gunzip.h"
#include "motion/timeline/xar.h"

namespace nao::motion {
namespace {

constexpr const char* kBehavior = "behavior.xar";

// Layout of ar(5): a mark, then members of a header and bytes, padded to an even length.
constexpr const char* kArMark = "!<arch>\n";
constexpr std::size_t kArHeader = 60, kArName = 16, kArSizeAt = 48, kArSizeDigits = 10;

// Layout of a POSIX tar: blocks; name at 0, size in octal at 124, kind at 156, prefix at 345.
constexpr std::size_t kTarBlock = 512, kTarName = 100, kTarSizeAt = 124, kTarSizeDigits = 12;

std::optional<std::string> memberOfAr(const std::string& bytes, const std::string& name) {
  std::size_t at = std::string(kArMark).size();
  while (at + kArHeader <= bytes.size()) {
    std::string found = bytes.substr(at, kArName);
    found.erase(found.find_last_not_of(" /") + 1);
    const std::string digits = bytes.substr(at + kArSizeAt, kArSizeDigits);
    const auto size = static_cast<std::size_t>(std::strtoull(digits.c_str(), nullptr, 10));
    at += kArHeader;
    if (size > bytes.size() - at) return std::nullopt;
    if (found == name) return bytes.substr(at, size);
    at += size + size % 2;
  }
  return std::nullopt;
}

std::optional<std::string> fileOfTar(const std::string& tar, const std::string& name) {
  std::size_t at = 0;
  while (at + kTarBlock <= tar.size()) {
    const std::string path = tar.substr(at, kTarName).c_str();  // up to the zero
    const std::string digits = tar.substr(at + kTarSizeAt, kTarSizeDigits);
    const auto size = static_cast<std::size_t>(std::strtoull(digits.c_str(), nullptr, 8));
    at += kTarBlock;
    if (size > tar.size() - at) return std::nullopt;
    const auto slash = path.rfind('/');
    if ((slash == std::string::npos ? path : path.substr(slash + 1)) == name) {
      return tar.substr(at, size);
    }
    at += (size + kTarBlock - 1) / kTarBlock * kTarBlock;
  }
  return std::nullopt;
}

std::string dataOf(const std::string& bytes, const std::string& source) {
  if (bytes.rfind(kArMark, 0) != 0) throw InputError(source + ":1: this is no ar archive");
  if (const auto plain = memberOfAr(bytes, "data.tar")) return *plain;
  const auto packed = memberOfAr(bytes, "data.tar.gz");
  if (!packed) throw InputError(source + ":1: expected a data.tar.gz in this archive");
  try {
    return gunzip(*packed);
  } catch (const GzipError& error) {
    throw InputError(source + ":1: its data.tar.gz can not be unpacked: " + error.what());
  }
}

}  // namespace

std::string unpackCrg(const std::string& bytes, const std::string& source) {
  auto behavior = fileOfTar(dataOf(bytes, source), kBehavior);
  if (!behavior) throw InputError(source + ":1: expected a behavior.xar in its data.tar.gz");
  return std::move(*behavior);
}

Timeline readCrg(const std::string& bytes, const std::string& source, const RobotModel& model) {
  return readXar(unpackCrg(bytes, source), source + "/" + kBehavior, model);
}

}  // namespace nao::motion

#include "validation/log/file_hash.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

#include "core/check.h"
#include "core/files.h"

namespace nao::validation {
namespace {

namespace fs = std::filesystem;

class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
    NAO_CHECK(context_ && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
  }
  void add(const char* bytes, std::size_t count) {
    NAO_CHECK(EVP_DigestUpdate(context_.get(), bytes, count) == 1);
  }
  // With its length before it: "ab", "c" is not "a", "bc".
  void addText(const std::string& text) {
    const std::string length = std::to_string(text.size()) + ":";
    add(length.data(), length.size());
    add(text.data(), text.size());
  }
  std::string hexadecimal() {
    std::array<unsigned char, 32> digest{};
    NAO_CHECK(EVP_DigestFinal_ex(context_.get(), digest.data(), nullptr) == 1);
    std::string text;
    for (const unsigned char byte : digest) {
      char two[3];
      std::snprintf(two, sizeof two, "%02x", byte);
      text += two;
    }
    return text;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

std::string contentOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw InputError(file.string() + ": can not be read");
  return content;
}

bool isBelow(const fs::path& file, const fs::path& folder) {
  const fs::path from = fs::weakly_canonical(file).lexically_relative(fs::weakly_canonical(folder));
  return !from.empty() && *from.begin() != "..";
}

}  // namespace

std::string sha256OfFolder(const std::string& folder, const std::vector<std::string>& except) {
  std::vector<fs::path> files;
  for (const fs::path& file : listFilesBelow(folder)) {
    const auto holds = [&](const std::string& other) {
      return !other.empty() && isBelow(file, other);
    };
    if (std::any_of(except.begin(), except.end(), holds)) continue;
    files.push_back(file.lexically_relative(folder));
  }
  std::sort(files.begin(), files.end());
  Sha256 hash;
  for (const fs::path& file : files) {
    hash.addText(file.generic_string());
    hash.addText(contentOf(folder / file));
  }
  return hash.hexadecimal();
}

std::string sha256Of(const std::string& text) {
  Sha256 hash;
  hash.add(text.data(), text.size());
  return hash.hexadecimal();
}

}  // namespace nao::validation

#pragma once

#include <stdexcept>
#include <string>

namespace nao::motion {

/// The bytes are no gzip, or broken.
struct GzipError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Unpacks gzip data by zlib, up to 64 MiB. @throws GzipError
std::string gunzip(const std::string& bytes);

}  // namespace nao::motion

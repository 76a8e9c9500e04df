#pragma once

#include <stdexcept>
#include <string>

namespace nao::motion {

/// The bytes are no gzip, or broken.
struct GzipError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Unpacks one gzip member (RFC 1952) of DEFLATE data (RFC 1951), up to 64 MiB; its length is
/// checked, its CRC too. @throws GzipError
std::string gunzip(const std::string& bytes);

}  // namespace nao::motion

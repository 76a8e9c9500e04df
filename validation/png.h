#pragma once

#include <string>

#include "camera/raster.h"

namespace nao::validation {

/// The bytes of a PNG file (ISO/IEC 15948) of this picture: 8 bits of red, green and blue.
std::string encodePng(const camera::Raster& picture);

/// Bytes as text for a `data:` address (RFC 4648).
std::string toBase64(const std::string& bytes);

}  // namespace nao::validation

// A PNG is a mark and chunks: length, name, bytes, CRC of name and bytes; all numbers big-endian.
// IHDR: width, height, 8 bits, colour type 2 (RGB), 0, 0, 0. IDAT: the rows, each after a byte 0
// (no filter), as a zlib stream. IEND: nothing.
#include "validation/png.h"

#include <zlib.h>

#include <cstdint>
#include <vector>

#include "core/check.h"

namespace nao::validation {
namespace {

void appendNumber(std::string& out, std::uint32_t number) {
  for (const int shift : {24, 16, 8, 0}) out += static_cast<char>(number >> shift & 0xff);
}

void appendChunk(std::string& out, const std::string& name, const std::string& bytes) {
  appendNumber(out, static_cast<std::uint32_t>(bytes.size()));
  const std::string body = name + bytes;
  out += body;
  const auto* data = reinterpret_cast<const Bytef*>(body.data());
  appendNumber(out, static_cast<std::uint32_t>(crc32(0, data, static_cast<uInt>(body.size()))));
}

std::string rowsOf(const camera::Raster& picture) {
  std::string rows;
  const camera::ImageSize size = picture.size();
  rows.reserve(static_cast<std::size_t>(size.height) * (3 * size.width + 1));
  for (int y = 0; y < size.height; ++y) {
    rows += '\0';
    const camera::Pixel* row = picture.colors(y);
    for (int x = 0; x < size.width; ++x) {
      for (const int shift : {0, 8, 16}) rows += static_cast<char>(row[x] >> shift & 0xff);
    }
  }
  return rows;
}

std::string deflated(const std::string& bytes) {
  uLongf length = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(length, '\0');
  const int result = compress2(reinterpret_cast<Bytef*>(out.data()), &length,
                               reinterpret_cast<const Bytef*>(bytes.data()),
                               static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION);
  NAO_CHECK(result == Z_OK);
  out.resize(length);
  return out;
}

}  // namespace

std::string encodePng(const camera::Raster& picture) {
  std::string header;
  appendNumber(header, static_cast<std::uint32_t>(picture.size().width));
  appendNumber(header, static_cast<std::uint32_t>(picture.size().height));
  header += std::string("\x08\x02\0\0\0", 5);
  std::string out = "\x89PNG\r\n\x1a\n";
  appendChunk(out, "IHDR", header);
  appendChunk(out, "IDAT", deflated(rowsOf(picture)));
  appendChunk(out, "IEND", "");
  return out;
}

std::string toBase64(const std::string& bytes) {
  constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      out += i + k > bytes.size() ? '=' : kDigits[word >> (18 - 6 * k) & 63];
    }
  }
  return out;
}

}  // namespace nao::validation

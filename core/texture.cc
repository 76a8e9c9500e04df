#include "core/texture.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>

#include "core/check.h"

namespace nao {
namespace {

constexpr int kMostPixels = 4096 * 4096;

/// The mean of up to four pixels, each channel rounded.
std::uint32_t meanOf(const Texture::Level& from, int column, int row) {
  std::uint32_t sums[3] = {0, 0, 0};
  for (const int y : {2 * row, std::min(2 * row + 1, from.height - 1)}) {
    for (const int x : {2 * column, std::min(2 * column + 1, from.width - 1)}) {
      const std::uint32_t pixel = from.pixels[static_cast<std::size_t>(y) * from.width + x];
      for (int c = 0; c < 3; ++c) sums[c] += pixel >> (8 * c) & 0xff;
    }
  }
  return (sums[0] + 2) / 4 | (sums[1] + 2) / 4 << 8 | (sums[2] + 2) / 4 << 16;
}

Texture::Level halved(const Texture::Level& from) {
  Texture::Level level{(from.width + 1) / 2, (from.height + 1) / 2, {}};
  level.pixels.reserve(static_cast<std::size_t>(level.width) * level.height);
  for (int row = 0; row < level.height; ++row) {
    for (int column = 0; column < level.width; ++column)
      level.pixels.push_back(meanOf(from, column, row));
  }
  return level;
}

/// Netpbm: "P" and a digit, width, height and, but for P1 and P4, the largest value, apart by
/// white space and comments; then the values, as text (P1 to P3) or as bytes (P4 to P6).
class Netpbm {
 public:
  Netpbm(const std::string& file, std::string content) : file_(file), in_(std::move(content)) {}

  Texture read() {
    if (in_.get() != 'P' || (kind_ = in_.get() - '0') < 1 || kind_ > 6)
      fail("expected a Netpbm picture, P1 to P6");
    const int width = number(1, 65535);
    const int height = number(1, 65535);
    if (width > kMostPixels / height) fail("expected a picture of at most 16 million pixels");
    if (kind_ % 3 != 1) largest_ = number(1, 255);
    if (kind_ > 3) in_.get();  // one white space, then bytes
    std::vector<std::uint32_t> pixels(static_cast<std::size_t>(width) * height);
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = pixel(i % width);
    return makeTexture(width, height, std::move(pixels));
  }

 private:
  [[noreturn]] void fail(const std::string& sentence) { throw InputError(file_ + ": " + sentence); }

  int number(int low, int high) {
    while (in_ >> std::ws && in_.peek() == '#') in_.ignore(1 << 20, '\n');
    int value = -1;
    if (!(in_ >> value) || value < low || value > high)
      fail("expected a number from " + std::to_string(low) + " to " + std::to_string(high));
    return value;
  }

  std::uint32_t pixel(std::size_t column) {
    if (kind_ % 3 != 0) return 0x010101u * value(column);
    const std::uint32_t red = value(column);
    const std::uint32_t green = value(column);
    return red | green << 8 | value(column) << 16;
  }

  /// 0 to 255.
  std::uint32_t value(std::size_t column) {
    if (kind_ == 1) return bit() ? 0 : 255;
    if (kind_ < 4) return static_cast<std::uint32_t>(number(0, largest_) * 255 / largest_);
    if (kind_ == 4) {
      if (column % 8 == 0) bits_ = byte();
      return bits_ >> (7 - column % 8) & 1 ? 0 : 255;
    }
    return static_cast<std::uint32_t>(std::min(byte(), largest_) * 255 / largest_);
  }

  bool bit() {  // of P1, where they may stand without space between them
    char digit = 0;
    if (!(in_ >> digit) || (digit != '0' && digit != '1')) fail("expected 0 or 1");
    return digit == '1';
  }

  int byte() {
    const int value = in_.get();
    if (value < 0) fail("expected more pixels");
    return value;
  }

  const std::string& file_;
  std::istringstream in_;
  int kind_ = 0;
  int largest_ = 1;
  int bits_ = 0;
};

}  // namespace

Texture makeTexture(int width, int height, std::vector<std::uint32_t> pixels) {
  NAO_CHECK(width > 0 && height > 0 && pixels.size() == static_cast<std::size_t>(width) * height);
  Texture texture;
  texture.levels.push_back({width, height, std::move(pixels)});
  while (texture.levels.back().width > 1 || texture.levels.back().height > 1)
    texture.levels.push_back(halved(texture.levels.back()));
  return texture;
}

Texture readTexture(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream content;
  if (!in || !(content << in.rdbuf())) throw InputError(file + ": can not be read");
  return Netpbm(file, content.str()).read();
}

}  // namespace nao

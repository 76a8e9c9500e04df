#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace nao {

/// A picture to paint with, in halves and halves of its size down to one pixel, each the mean of
/// the one before: whoever looks from afar takes a small one. Immutable once made.
struct Texture {
  struct Level {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> pixels;  // rows from the top; red lowest, then green, then blue
  };
  std::vector<Level> levels;  // the whole picture first
};

/// @param pixels rows from the top, width * height of them
Texture makeTexture(int width, int height, std::vector<std::uint32_t> pixels);

/// Reads a Netpbm picture (P1 to P6, up to 255 a channel). @throws InputError naming the file.
Texture readTexture(const std::string& file);

}  // namespace nao

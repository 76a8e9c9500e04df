#pragma once

namespace nao {

/// 8-bit red, green, blue.
struct Color {
  unsigned char red = 200;
  unsigned char green = 200;
  unsigned char blue = 200;
};

}  // namespace nao

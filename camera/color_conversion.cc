#include "camera/color_conversion.h"

#include "camera/wide.h"

namespace nao::camera {
namespace {

Color toColor(Pixel pixel) {
  return {static_cast<std::uint8_t>(pixel), static_cast<std::uint8_t>(pixel >> 8),
          static_cast<std::uint8_t>(pixel >> 16)};
}

std::uint8_t clampToByte(int value) { return static_cast<std::uint8_t>(std::clamp(value, 0, 255)); }

Triple toRgb(Color color) { return {color.red, color.green, color.blue}; }

/// Converts pixels, remembering the last: a synthetic picture has long runs of one colour.
template <class Convert>
class Memo {
 public:
  explicit Memo(Convert convert) : convert_(convert), triple_(convert_(toColor(0))) {}

  const Triple& operator()(Pixel pixel) {
    if (pixel != pixel_) {
      pixel_ = pixel;
      triple_ = convert_(toColor(pixel));
    }
    return triple_;
  }

 private:
  Convert convert_;
  Pixel pixel_ = 0;
  Triple triple_;
};

template <class Convert>
void packTriples(const Pixel* pixels, std::size_t count, Convert convert, std::uint8_t* out,
                 const std::array<int, 3>& order) {
  Memo memo(convert);
  for (std::size_t i = 0; i < count; ++i) {
    const Triple& triple = memo(pixels[i]);
    out[3 * i + 0] = triple[order[0]];
    out[3 * i + 1] = triple[order[1]];
    out[3 * i + 2] = triple[order[2]];
  }
}

template <class Convert>
void packChannel(const Pixel* pixels, std::size_t count, Convert convert, std::uint8_t* out,
                 int channel) {
  Memo memo(convert);
  for (std::size_t i = 0; i < count; ++i) out[i] = memo(pixels[i])[channel];
}

/// Where the bytes of two neighbouring pixels go: both Y, then U, then V.
struct PairLayout {
  int first_y, second_y, u, v;
};
constexpr PairLayout kYuyv = {0, 2, 1, 3};
constexpr PairLayout kYycbcr = {0, 1, 2, 3};

void packPairs(const Pixel* pixels, std::size_t count, std::uint8_t* out, PairLayout layout) {
  for (std::size_t i = 0; i + 1 < count; i += 2, out += 4) {
    const Triple first = toYuv(toColor(pixels[i]));
    const Triple second = toYuv(toColor(pixels[i + 1]));
    out[layout.first_y] = first[0];
    out[layout.second_y] = second[0];
    out[layout.u] = static_cast<std::uint8_t>((first[1] + second[1] + 1) / 2);
    out[layout.v] = static_cast<std::uint8_t>((first[2] + second[2] + 1) / 2);
  }
}

void packYuyv(const Pixel* pixels, std::size_t count, std::uint8_t* out) {
  std::size_t done = 0;
#if defined(__SSE2__)
  for (; done + 8 <= count; done += 8) wide::packYuyv8(pixels + done, out + 2 * done);
#endif
  packPairs(pixels + done, count - done, out + 2 * done, kYuyv);
}

int hueOf(const Color& color, int max, int range) {
  if (range == 0) return 0;
  // Sixths of a turn of 256 * 6 parts, so that the division comes last.
  const int turn = 6 * 256;
  int parts = 0;
  if (max == color.red) {
    parts = (color.green - color.blue) * 256 / range;
  } else if (max == color.green) {
    parts = 2 * 256 + (color.blue - color.red) * 256 / range;
  } else {
    parts = 4 * 256 + (color.red - color.green) * 256 / range;
  }
  return (parts + turn) % turn / 6;
}

}  // namespace

Triple toYuv(Color color) {
  // Weights with 15 bits behind the point (camera/wide.h): .299 .587 .114, then
  // .564 = .5 / (1 - .114) and .713 = .5 / (1 - .299) multiplied out.
  const Pixel pixel = toPixel(color);
  return {clampToByte(wide::weighted(pixel, wide::kToY)),
          clampToByte(wide::weighted(pixel, wide::kToU) + 128),
          clampToByte(wide::weighted(pixel, wide::kToV) + 128)};
}

Triple toHsy(Color color) {
  const int max = std::max({color.red, color.green, color.blue});
  const int min = std::min({color.red, color.green, color.blue});
  const int saturation = max == 0 ? 0 : (max - min) * 255 / max;
  return {static_cast<std::uint8_t>(hueOf(color, max, max - min)),
          static_cast<std::uint8_t>(saturation), toYuv(color)[0]};
}

Triple toPureHue(Color color) {
  const int hue = 6 * toHsy(color)[0];  // 256 to a sixth of a turn
  const int rising = hue % 256;
  const auto up = static_cast<std::uint8_t>(rising);
  const auto down = static_cast<std::uint8_t>(255 - rising);
  switch (hue / 256) {
    case 0:
      return {255, up, 0};
    case 1:
      return {down, 255, 0};
    case 2:
      return {0, 255, up};
    case 3:
      return {0, down, 255};
    case 4:
      return {up, 0, 255};
    default:
      return {255, 0, down};
  }
}

Triple toHueSaturation(Color color) {
  const Triple hsy = toHsy(color);
  return {hsy[0], hsy[1], static_cast<std::uint8_t>((hsy[0] + hsy[1]) / 2)};
}

Bytes toBytes(const Raster& raster, ColorSpace space) {
  const std::size_t count = static_cast<std::size_t>(raster.size().width) * raster.size().height;
  const Pixel* const pixels = raster.colors(0);
  Bytes bytes(count * layers(space));
  std::uint8_t* const out = bytes.data();
  const int channel = static_cast<int>(space) % 3;  // of the spaces 0 to 8
  switch (space) {
    case ColorSpace::kYuv:
    case ColorSpace::kyUv:
    case ColorSpace::kyuV:
      packChannel(pixels, count, toYuv, out, channel);
      break;
    case ColorSpace::kRgb:
    case ColorSpace::krGb:
    case ColorSpace::krgB:
      packChannel(pixels, count, toRgb, out, channel);
      break;
    case ColorSpace::kHsy:
    case ColorSpace::khSy:
    case ColorSpace::khsY:
      packChannel(pixels, count, toHsy, out, channel);
      break;
    case ColorSpace::kYUV422:
      packYuyv(pixels, count, out);
      break;
    case ColorSpace::kYYCbCr:
      packPairs(pixels, count, out, kYycbcr);
      break;
    case ColorSpace::kYUV:
      packTriples(pixels, count, toYuv, out, {0, 1, 2});
      break;
    case ColorSpace::kRGB:
      packTriples(pixels, count, toRgb, out, {0, 1, 2});
      break;
    case ColorSpace::kHSY:
      packTriples(pixels, count, toHsy, out, {0, 1, 2});
      break;
    case ColorSpace::kBGR:
      packTriples(pixels, count, toRgb, out, {2, 1, 0});
      break;
    case ColorSpace::kH2RGB:
      packTriples(pixels, count, toPureHue, out, {0, 1, 2});
      break;
    case ColorSpace::kHSMixed:
      packTriples(pixels, count, toHueSaturation, out, {0, 1, 2});
      break;
  }
  return bytes;
}

}  // namespace nao::camera

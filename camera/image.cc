#include "camera/image.h"

#include <array>

namespace nao::camera {
namespace {

struct NamedSize {
  int id;
  ImageSize size;
};

// NaoQi's resolution numbers (Aldebaran's video definitions), 4:3 ones only.
constexpr std::array<NamedSize, 7> kResolutions = {{{0, {160, 120}},
                                                    {1, {320, 240}},
                                                    {2, {640, 480}},
                                                    {3, {1280, 960}},
                                                    {4, {2560, 1920}},
                                                    {7, {80, 60}},
                                                    {8, {40, 30}}}};

}  // namespace

std::optional<ColorSpace> toColorSpace(int id) {
  if (id < 0 || id > static_cast<int>(ColorSpace::kHSMixed)) return std::nullopt;
  return static_cast<ColorSpace>(id);
}

int layers(ColorSpace space) {
  switch (space) {
    case ColorSpace::kYUV422:
    case ColorSpace::kYYCbCr:
      return 2;
    case ColorSpace::kYUV:
    case ColorSpace::kRGB:
    case ColorSpace::kHSY:
    case ColorSpace::kBGR:
    case ColorSpace::kH2RGB:
    case ColorSpace::kHSMixed:
      return 3;
    case ColorSpace::kYuv:
    case ColorSpace::kyUv:
    case ColorSpace::kyuV:
    case ColorSpace::kRgb:
    case ColorSpace::krGb:
    case ColorSpace::krgB:
    case ColorSpace::kHsy:
    case ColorSpace::khSy:
    case ColorSpace::khsY:
      return 1;
  }
  return 0;
}

std::optional<ImageSize> resolutionSize(int id) {
  for (const NamedSize& known : kResolutions) {
    if (known.id == id) return known.size;
  }
  return std::nullopt;
}

std::optional<int> resolutionOf(ImageSize size) {
  for (const NamedSize& known : kResolutions) {
    if (known.size == size) return known.id;
  }
  return std::nullopt;
}

std::uint64_t Image::hash() const {
  std::uint64_t hash = 14695981039346656037u;
  if (!bytes) return hash;
  for (const std::uint8_t byte : *bytes) hash = (hash ^ byte) * 1099511628211u;
  return hash;
}

}  // namespace nao::camera

#include "camera/sensor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "camera/wide.h"

namespace nao::camera {
namespace {

constexpr double kAdaptation = 0.3;  // [s] of automatic exposure; free choice
constexpr double kHallTemperature =
    4500;                              // [K] of the light that white balance 4500 shows as white
constexpr double kMostAveraged = 0.5;  // two by two pixels; beyond, sensors leave out the others
constexpr int kNoiseCells = 1 << 14;
constexpr int kNoiseStarts = 1 << 12;  // places in the noise at which a row may begin
constexpr int kMostBytes = kNoiseCells - kNoiseStarts;  // of a row: 3,072 pixels
// A signal of 0.8 and more is pressed together by half, so that white at 1.2 is not yet lost.
constexpr std::uint16_t kKnee = 3264;  // 0.8 * 255, in 1/16

/// Scrambles a number (the finaliser of splitmix64, Vigna, public domain).
std::uint64_t scrambled(std::uint64_t h) {
  h += 0x9e3779b97f4a7c15u;
  h = (h ^ h >> 30) * 0xbf58476d1ce4e5b9u;
  h = (h ^ h >> 27) * 0x94d049bb133111ebu;
  return h ^ h >> 31;
}

/// Nearly normal, standard deviation 148: the sum of four bytes.
int normalCell(std::uint64_t number) {
  const std::uint64_t h = scrambled(number);
  return static_cast<int>((h & 0xff) + (h >> 8 & 0xff) + (h >> 16 & 0xff) + (h >> 24 & 0xff)) - 510;
}
constexpr double kCellDeviation = 147.8;

/// Mean of R + 2 G + B over every fourth pixel of the lower two thirds: automatic exposure looks
/// at the field, not at the hall's lamps.
int meter(const Raster& picture) {
  std::int64_t sum = 0;
  std::int64_t count = 0;
  for (int row = picture.size().height / 3; row < picture.size().height; row += 4) {
    const Pixel* const pixels = picture.colors(row);
    for (int column = 0; column < picture.size().width; column += 4, ++count) {
      const Pixel p = pixels[column];
      sum += (p & 0xff) + 2 * (p >> 8 & 0xff) + (p >> 16 & 0xff);
    }
  }
  return static_cast<int>(sum / std::max<std::int64_t>(4 * count, 1));
}

/// sin for |x| <= pi by its series, the same on every machine.
double portableSin(double x) {
  double sum = 0;
  double term = x;
  for (int k = 2; k < 40; k += 2) {
    sum += term;
    term *= -x * x / (k * (k + 1));
  }
  return sum;
}

std::uint16_t clampTo16(double value) {
  return static_cast<std::uint16_t>(std::clamp(value + 0.5, 0.0, 65535.0));
}

/// Light lost in the lens and gained by the response, byte by byte, and noise laid over it.
struct Tone {
  const std::uint16_t* column_loss;  // in 1/65536
  std::uint16_t row_light;
  std::uint16_t channel[8];  // factors of four bytes in 1/4096, twice
  std::uint16_t slope;       // in 1/4096
  std::int16_t offset;       // 0 to 255
  std::uint16_t knee;        // in 1/16: what is above it is pressed together by half
};

/// One byte: 8 bits behind the point after the lens, 4 after the response.
std::uint8_t toned(std::uint8_t byte, std::uint16_t loss, std::uint16_t factor, int noise,
                   const Tone& tone) {
  const std::uint32_t seen =
      (std::uint32_t(byte) << 8) * std::uint16_t(tone.row_light - loss) >> 16;
  std::uint32_t signal = seen * factor >> 16;
  if (signal > tone.knee) signal -= (signal - tone.knee) >> 1;
  const std::uint32_t pressed = std::min<std::uint32_t>(signal, 8191) << 3;
  const int out = static_cast<int>((pressed * tone.slope >> 16) + 4) >> 3;
  return static_cast<std::uint8_t>(std::clamp(out + tone.offset + noise, 0, 255));
}

#if defined(__SSE2__)

__m128i load8(const void* from) { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from)); }

/// toned() of eight bytes, which lie in the upper halves of `bytes`.
__m128i toned8(__m128i bytes, const std::uint16_t* loss, __m128i noise, const Tone& tone) {
  const __m128i left =
      _mm_sub_epi16(_mm_set1_epi16(static_cast<short>(tone.row_light)), load8(loss));
  __m128i signal = _mm_mulhi_epu16(_mm_mulhi_epu16(bytes, left), load8(tone.channel));
  const __m128i over = _mm_subs_epu16(signal, _mm_set1_epi16(static_cast<short>(tone.knee)));
  signal = _mm_sub_epi16(signal, _mm_srli_epi16(over, 1));
  signal = _mm_sub_epi16(signal, _mm_subs_epu16(signal, _mm_set1_epi16(8191)));
  const __m128i slope = _mm_set1_epi16(static_cast<short>(tone.slope));
  const __m128i fine = _mm_mulhi_epu16(_mm_slli_epi16(signal, 3), slope);
  const __m128i out = _mm_srli_epi16(_mm_add_epi16(fine, _mm_set1_epi16(4)), 3);
  return _mm_adds_epi16(_mm_adds_epi16(out, _mm_set1_epi16(tone.offset)), noise);
}

/// The bytes done, sixteen at a time.
int toneWide(std::uint8_t* bytes, int count, const std::int16_t* noise, const Tone& tone) {
  const __m128i zero = _mm_setzero_si128();
  int i = 0;
  for (; i + 16 <= count; i += 16) {
    const __m128i all = load8(bytes + i);
    const __m128i low = toned8(_mm_unpacklo_epi8(zero, all), tone.column_loss + i,
                               noise ? load8(noise + i) : zero, tone);
    const __m128i high = toned8(_mm_unpackhi_epi8(zero, all), tone.column_loss + i + 8,
                                noise ? load8(noise + i + 8) : zero, tone);
    _mm_storeu_si128(reinterpret_cast<__m128i*>(bytes + i), _mm_packus_epi16(low, high));
  }
  return i;
}

#else

int toneWide(std::uint8_t*, int, const std::int16_t*, const Tone&) { return 0; }

#endif

void toneRow(std::uint8_t* bytes, int count, const std::int16_t* noise, const Tone& tone) {
  for (int i = toneWide(bytes, count, noise, tone); i < count; ++i)
    bytes[i] =
        toned(bytes[i], tone.column_loss[i], tone.channel[i % 8], noise ? noise[i] : 0, tone);
}

void colorRow(Pixel* pixels, int count, const int (&chroma)[4]) {
  for (int i = 0; i < count; ++i) {
    const Pixel p = pixels[i];
    const int r = p & 0xff, g = p >> 8 & 0xff, b = p >> 16 & 0xff;
    const int y = (77 * r + 150 * g + 29 * b) >> 8;
    const int from_red = (chroma[0] * (r - y) + chroma[1] * (b - y)) >> 8;
    const int from_blue = (chroma[2] * (r - y) + chroma[3] * (b - y)) >> 8;
    // Green is what keeps the brightness: 77 dr + 150 dg + 29 db = 0.
    const int from_green = -(77 * from_red + 29 * from_blue) / 150;
    const auto clamped = [](int value) {
      return static_cast<std::uint8_t>(std::clamp(value, 0, 255));
    };
    pixels[i] = toPixel({clamped(y + from_red), clamped(y + from_green), clamped(y + from_blue)});
  }
}

void noiseRow(std::uint8_t* bytes, int count, const std::int16_t* noise) {
  for (int i = 0; i < count; ++i) {
    const auto sum = static_cast<std::int16_t>(bytes[i] + noise[i]);
    bytes[i] = static_cast<std::uint8_t>(std::clamp<std::int16_t>(sum, 0, 255));
  }
}

}  // namespace

void Sensor::expose(Raster& picture, const CameraSettings& settings, double light, SimTime time) {
  adapt(picture, settings, light, time);
  fallOff(picture.size());
  applyTo(picture, responseFor(picture.size(), settings, light), time);
  flip(picture, settings.get(type_, Parameter::kHFlip) != 0,
       settings.get(type_, Parameter::kVFlip) != 0);
}

void Sensor::use(const CameraEffects& effects) {
  if (effects.vignetting != effects_.vignetting) fall_off_size_ = {};
  effects_ = effects;
}

void Sensor::adapt(const Raster& picture, const CameraSettings& settings, double light,
                   SimTime time) {
  const double unit = type_.neutral_exposure;
  if (settings.get(type_, Parameter::kAutoExposure) == 0) {
    state_.exposure = settings.get(type_, Parameter::kExposure) * type_.exposure_unit;
    state_.gain = settings.get(type_, Parameter::kGain) / type_.unit_gain;
    state_.signal = state_.exposure / unit * state_.gain;
    state_.looked.reset();
    state_.brightness = meter(picture);
    return;
  }
  if (state_.looked && *state_.looked == time) return;  // another size of the same instant
  state_.brightness = meter(picture);
  const ParameterRange& wish = *findParameter(type_, static_cast<int>(Parameter::kBrightness));
  const double part =
      static_cast<double>(settings.get(wish) - wish.min) / (wish.initial - wish.min);
  const double ratio = type_.metered * part / std::max(state_.brightness, 1);
  const double goal = std::clamp(ratio * ratio / light, type_.exposure_unit / unit,
                                 type_.longest_exposure / unit * type_.largest_gain);
  const double passed = state_.looked ? toSeconds(time - *state_.looked) : -1;
  // The first picture, or one before the last: as if it had long looked.
  state_.signal = passed < 0
                      ? goal
                      : state_.signal + (goal - state_.signal) * (passed / (passed + kAdaptation));
  state_.looked = time;
  state_.exposure = std::min(state_.signal * unit, type_.longest_exposure);
  state_.gain = std::max(state_.signal * unit / state_.exposure, 1.0);
}

Sensor::Response Sensor::responseFor(ImageSize size, const CameraSettings& settings,
                                     double light) const {
  Response response;
  const auto value = [&](Parameter parameter) { return settings.get(type_, parameter); };
  // Pictures are as bright as the root of the light is strong (gamma 2).
  const double factor = effects_.response ? std::sqrt(state_.signal * light) : 1;
  std::array<double, 3> balance = {1, 1, 1};
  if (effects_.response) {
    balance = type_.cast;
    if (value(Parameter::kAutoWhiteBalance) == 0) {
      const double warmth = 0.5 * (value(Parameter::kWhiteBalance) / kHallTemperature - 1);
      balance[0] *= 1 + warmth;
      balance[2] *= 1 - warmth;
    }
    response.black = static_cast<int>(type_.black);
    const ParameterRange& contrast = *findParameter(type_, static_cast<int>(Parameter::kContrast));
    response.slope = 256 * settings.get(contrast) / contrast.initial;
    const ParameterRange& color = *findParameter(type_, static_cast<int>(Parameter::kSaturation));
    const double chroma = 256 * type_.colorfulness * settings.get(color) / color.initial;
    const double hue = type_.naoqi_model == 2 ? 0 : value(Parameter::kHue) * M_PI / 180;
    const double cosine = portableSin(M_PI / 2 - std::abs(hue)), sine = portableSin(hue);
    response.chroma[0] = response.chroma[3] = static_cast<int>(chroma * cosine);
    response.chroma[2] = static_cast<int>(chroma * sine);
    response.chroma[1] = -response.chroma[2];
    response.turns_color = response.chroma[0] != 256 || response.chroma[1] != 0;
  }
  for (std::size_t c = 0; c < 3; ++c) response.channel[c] = clampTo16(4096 * factor * balance[c]);
  if (effects_.noise) {
    const double averaged = std::sqrt(static_cast<double>(size.width) * size.height / type_.pixels);
    const double deviation = 255 / type_.signal_to_noise * std::sqrt(state_.gain) *
                             std::clamp(averaged, kMostAveraged, 1.0);
    response.noise = static_cast<int>(16 * deviation + 0.5);
  }
  return response;
}

// Light falls off with the square of the distance from the middle, as far as it matters.
void Sensor::fallOff(ImageSize size) {
  if (fall_off_size_ == size) return;
  fall_off_size_ = size;
  const double loss = effects_.vignetting ? 65535 * type_.corner_loss : 0;
  const double half_width = size.width / 2.0, half_height = size.height / 2.0;
  const double corner = half_width * half_width + half_height * half_height;
  const auto lost = [&](int at, double half) {
    const double far = at + 0.5 - half;
    return loss * far * far / corner;
  };
  column_loss_.assign(static_cast<std::size_t>((4 * size.width + 7) / 8 * 8), 0);
  row_light_.resize(static_cast<std::size_t>(size.height));
  for (int i = 0; i < 4 * size.width; ++i)
    column_loss_[static_cast<std::size_t>(i)] = clampTo16(lost(i / 4, half_width));
  for (int i = 0; i < size.height; ++i)
    row_light_[static_cast<std::size_t>(i)] = clampTo16(65535 - lost(i, half_height));
}

void Sensor::makeNoise(int deviation) {
  if (deviation == noise_deviation_) return;
  noise_deviation_ = deviation;
  noise_.clear();
  for (int i = 0; i < kNoiseCells; ++i) {
    const double cell = normalCell(static_cast<std::uint64_t>(i)) * (deviation / 16.0);
    noise_.push_back(static_cast<std::int16_t>(std::floor(cell / kCellDeviation + 0.5)));
  }
}

void Sensor::applyTo(Raster& picture, const Response& response, SimTime time) {
  if (!effects_.response && !effects_.vignetting && response.noise == 0) return;
  const ImageSize size = picture.size();
  makeNoise(response.noise);
  const std::uint64_t picture_seed =
      scrambled(seed_ ^ scrambled(static_cast<std::uint64_t>(time.time_since_epoch().count())));
  // (t - 128) slope + 128, t from black to white: one slope and one offset.
  const double slope = response.slope / 256.0;
  Tone tone{};
  tone.column_loss = column_loss_.data();
  for (int i = 0; i < 8; ++i) tone.channel[i] = response.channel[i % 4];
  tone.slope = clampTo16(4096 * slope * (255 - response.black) / 255);
  tone.offset = static_cast<std::int16_t>(std::floor(128 + slope * (response.black - 128) + 0.5));
  tone.knee = effects_.response ? kKnee : 65535;
  for (int row = 0; row < size.height; ++row) {
    auto* const bytes = reinterpret_cast<std::uint8_t*>(picture.colors(row));
    tone.row_light = row_light_[static_cast<std::size_t>(row)];
    const std::uint64_t start = scrambled(picture_seed + static_cast<std::uint64_t>(row));
    const bool has_noise = response.noise > 0 && 4 * size.width <= kMostBytes;
    const std::int16_t* const noise = has_noise ? noise_.data() + start % kNoiseStarts : nullptr;
    toneRow(bytes, 4 * size.width, response.turns_color ? nullptr : noise, tone);
    if (!response.turns_color) continue;
    colorRow(picture.colors(row), size.width, response.chroma);
    if (noise) noiseRow(bytes, 4 * size.width, noise);
  }
}

void flip(Raster& picture, bool horizontally, bool vertically) {
  const ImageSize size = picture.size();
  for (int row = 0; horizontally && row < size.height; ++row)
    std::reverse(picture.colors(row), picture.colors(row) + size.width);
  for (int row = 0; vertically && row < size.height / 2; ++row) {
    Pixel* const upper = picture.colors(row);
    std::swap_ranges(upper, upper + size.width, picture.colors(size.height - 1 - row));
  }
}

}  // namespace nao::camera

#pragma once

#include <cstdint>

#if defined(__SSE2__)  // every x86-64 has it
#include <emmintrin.h>
#endif

#include "camera/raster.h"

// Loops over rows of pixels, eight at a time where the processor can. All numbers are whole, so
// the bits are those of the plain loops beside them.

namespace nao::camera::wide {

/// Weights of red, green, blue and nothing, in 1/32768.
using Weights = std::int16_t[4];
inline constexpr Weights kToY = {9798, 19235, 3735, 0};
inline constexpr Weights kToU = {-5530, -10854, 16384, 0};
inline constexpr Weights kToV = {16384, -13720, -2664, 0};

inline int weighted(Pixel p, const Weights& w) {
  const int sum = w[0] * int(p & 0xff) + w[1] * int(p >> 8 & 0xff) + w[2] * int(p >> 16 & 0xff);
  return (sum + (1 << 14)) >> 15;
}

#if defined(__SSE2__)

inline __m128i weighted4(__m128i pixels, const Weights& w) {
  const __m128i weights = _mm_setr_epi16(w[0], w[1], w[2], 0, w[0], w[1], w[2], 0);
  const __m128i zero = _mm_setzero_si128();
  const __m128 low = _mm_castsi128_ps(_mm_madd_epi16(_mm_unpacklo_epi8(pixels, zero), weights));
  const __m128 high = _mm_castsi128_ps(_mm_madd_epi16(_mm_unpackhi_epi8(pixels, zero), weights));
  const __m128i red_green = _mm_castps_si128(_mm_shuffle_ps(low, high, _MM_SHUFFLE(2, 0, 2, 0)));
  const __m128i blue = _mm_castps_si128(_mm_shuffle_ps(low, high, _MM_SHUFFLE(3, 1, 3, 1)));
  const __m128i sum = _mm_add_epi32(_mm_add_epi32(red_green, blue), _mm_set1_epi32(1 << 14));
  return _mm_srai_epi32(sum, 15);
}

/// The mean of two neighbours' chroma each, as 32 bits.
inline __m128i chroma4(__m128i first, __m128i second, const Weights& w) {
  __m128i eight = _mm_packs_epi32(weighted4(first, w), weighted4(second, w));
  eight = _mm_min_epi16(_mm_add_epi16(eight, _mm_set1_epi16(128)), _mm_set1_epi16(255));
  const __m128i sums = _mm_madd_epi16(eight, _mm_set1_epi16(1));
  return _mm_srli_epi32(_mm_add_epi32(sums, _mm_set1_epi32(1)), 1);
}

/// Y U Y V of eight pixels, 16 bytes.
inline void packYuyv8(const Pixel* pixels, std::uint8_t* out) {
  const __m128i first = _mm_loadu_si128(reinterpret_cast<const __m128i*>(pixels));
  const __m128i second = _mm_loadu_si128(reinterpret_cast<const __m128i*>(pixels + 4));
  const __m128i y = _mm_packs_epi32(weighted4(first, kToY), weighted4(second, kToY));
  const __m128i u = _mm_slli_epi32(chroma4(first, second, kToU), 8);
  const __m128i v = _mm_slli_epi32(chroma4(first, second, kToV), 24);
  _mm_storeu_si128(reinterpret_cast<__m128i*>(out), _mm_or_si128(y, _mm_or_si128(u, v)));
}

#endif

}  // namespace nao::camera::wide

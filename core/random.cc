#include "core/random.h"

#include <cmath>

namespace nao {
namespace {

// FNV-1a: small, and the same everywhere, unlike std::hash.
std::uint64_t hashOf(std::string_view name, std::uint64_t seed) {
  std::uint64_t hash = 14695981039346656037ULL ^ seed;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return hash;
}

// The sequence that xoshiro's authors recommend to fill its state (Steele, Lea, Flood 2014).
std::uint64_t splitMix(std::uint64_t& x) {
  std::uint64_t z = x += 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

std::uint64_t rotateLeft(std::uint64_t x, int bits) { return (x << bits) | (x >> (64 - bits)); }

}  // namespace

Random::Random(std::uint64_t seed, std::string_view name, Pair pair)
    : mirrored_(pair == Pair::Mirrored) {
  std::uint64_t x = hashOf(name, seed);
  for (std::uint64_t& word : state_) word = splitMix(x);
}

std::uint64_t Random::next() {
  auto& s = state_;
  const std::uint64_t result = rotateLeft(s[0] + s[3], 23) + s[0];
  const std::uint64_t t = s[1] << 17;
  s[2] ^= s[0];
  s[3] ^= s[1];
  s[1] ^= s[2];
  s[0] ^= s[3];
  s[2] ^= t;
  s[3] = rotateLeft(s[3], 45);
  return result;
}

// The distributions are spelled out: the standard's differ between libraries.
double Random::plainUniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

double Random::uniform() {
  const double plain = plainUniform();
  return mirrored_ ? 1 - 0x1.0p-53 - plain : plain;
}

double Random::uniform(double low, double high) { return low + (high - low) * uniform(); }

double Random::normal() {  // Box and Muller
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  const double sign = mirrored_ ? -1 : 1;
  const double radius = sign * std::sqrt(-2 * std::log(1 - plainUniform()));
  const double angle = 2 * M_PI * plainUniform();
  spare_ = radius * std::sin(angle);
  has_spare_ = true;
  return radius * std::cos(angle);
}

}  // namespace nao

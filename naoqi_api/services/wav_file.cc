#include "naoqi_api/services/wav_file.h"

#include <algorithm>

namespace nao::services {
namespace {

void append(std::string& bytes, std::uint32_t number, int size) {
  for (int i = 0; i < size; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xffU);
}

}  // namespace

Sound Sound::silence(double seconds, int rate, int channels) {
  Sound sound{rate, channels, {}};
  sound.samples.resize(static_cast<std::size_t>(std::max(seconds, 0.0) * rate) *
                       static_cast<std::size_t>(channels));
  return sound;
}

double Sound::length() const {
  return static_cast<double>(samples.size()) / (static_cast<double>(rate) * channels);
}

std::string wavFile(const Sound& sound) {
  constexpr std::uint32_t kBytes = 2;  // of a sample
  const auto size = static_cast<std::uint32_t>(sound.samples.size()) * kBytes;
  const auto channels = static_cast<std::uint32_t>(sound.channels);
  const auto rate = static_cast<std::uint32_t>(sound.rate);
  std::string file = "RIFF";
  file.reserve(44 + size);
  append(file, 36 + size, 4);
  file += "WAVEfmt ";
  append(file, 16, 4);  // bytes of the format that follows
  append(file, 1, 2);   // plain samples
  append(file, channels, 2);
  append(file, rate, 4);
  append(file, rate * channels * kBytes, 4);
  append(file, channels * kBytes, 2);
  append(file, 8 * kBytes, 2);
  file += "data";
  append(file, size, 4);
  for (const std::int16_t sample : sound.samples) {
    append(file, static_cast<std::uint16_t>(sample), 2);
  }
  return file;
}

}  // namespace nao::services

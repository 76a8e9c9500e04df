#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace nao::services {

/// Sound as it is: 16 bit samples, channels interleaved.
struct Sound {
  int rate = 16000;  // [Hz]
  int channels = 1;
  std::vector<std::int16_t> samples;

  static Sound silence(double seconds, int rate, int channels);
  double length() const;  // [s]
};

/// The sound as a WAV file: a RIFF header of 44 bytes and the samples.
std::string wavFile(const Sound& sound);

}  // namespace nao::services

#pragma once

#include <optional>
#include <string>

#include "naoqi_api/services/wav_file.h"

namespace nao::voice {

/// How a text is to sound.
struct Manner {
  std::string locale = "en_US";
  double speed = 1;  // 1: 175 words a minute
  double pitch = 1;
};

/// A text as sound, by espeak-ng; nothing where the simulator was built without it, or if it does
/// not speak that language. Takes some hundredth of the sound's length. One thread.
std::optional<services::Sound> speak(const std::string& text, const Manner& manner);

}  // namespace nao::voice

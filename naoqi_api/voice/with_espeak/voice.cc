#include <espeak-ng/speak_lib.h>

#include <algorithm>
#include <cmath>

#include "naoqi_api/voice/voice.h"

namespace nao::voice {
namespace {

// The rate espeak-ng works at, or nothing if it finds no voices.
std::optional<int> start() {
  static const int rate =
      espeak_Initialize(AUDIO_OUTPUT_SYNCHRONOUS, 0, nullptr, espeakINITIALIZE_DONT_EXIT);
  return rate > 0 ? std::optional<int>(rate) : std::nullopt;
}

// Called by espeak-ng with each piece of sound.
int collect(short* samples, int count, espeak_EVENT* events) {
  auto* sound = static_cast<services::Sound*>(events->user_data);
  if (samples && sound) sound->samples.insert(sound->samples.end(), samples, samples + count);
  return 0;
}

// "pt_BR" is pt-br, or else pt.
bool setVoice(std::string locale) {
  std::transform(locale.begin(), locale.end(), locale.begin(), [](char c) {
    return c == '_' ? '-' : static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  });
  return espeak_SetVoiceByName(locale.c_str()) == EE_OK ||
         espeak_SetVoiceByName(locale.substr(0, locale.find('-')).c_str()) == EE_OK;
}

}  // namespace

std::optional<services::Sound> speak(const std::string& text, const Manner& manner) {
  const auto rate = start();
  if (!rate || !setVoice(manner.locale)) return std::nullopt;
  espeak_SetParameter(espeakRATE, static_cast<int>(std::lround(espeakRATE_NORMAL * manner.speed)),
                      0);
  espeak_SetParameter(espeakPITCH, std::clamp(static_cast<int>(50 * manner.pitch), 0, 100), 0);
  espeak_SetSynthCallback(collect);
  services::Sound sound{*rate, 1, {}};
  const auto said = espeak_Synth(text.c_str(), text.size() + 1, 0, POS_CHARACTER, 0,
                                 espeakCHARS_UTF8, nullptr, &sound);
  if (said != EE_OK) return std::nullopt;
  return sound;
}

}  // namespace nao::voice

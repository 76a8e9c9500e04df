#include "naoqi_api/voice/voice.h"

namespace nao::voice {

std::optional<services::Sound> speak(const std::string& /*text*/, const Manner& /*manner*/) {
  return std::nullopt;
}

}  // namespace nao::voice

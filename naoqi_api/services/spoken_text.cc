#include "naoqi_api/services/spoken_text.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace nao::services {
namespace {

constexpr double kCharactersPerSecond = 14;
constexpr std::chrono::milliseconds kLeast{500};
constexpr double kLongestPause = 60;  // [s]

struct Tag {
  std::string name;
  double value = 0;
  std::size_t end = 0;  // of it in the text
};

// The tag \name=value\ that starts at `start`, if one does.
std::optional<Tag> findTag(const std::string& text, std::size_t start) {
  constexpr std::size_t kLongestTag = 64;
  if (text[start] != '\\') return std::nullopt;
  const std::size_t end = text.find('\\', start + 1);
  if (end == std::string::npos || end - start > kLongestTag) return std::nullopt;
  const std::string inside = text.substr(start + 1, end - start - 1);
  const std::size_t equals = inside.find('=');
  if (equals == std::string::npos) return std::nullopt;
  const double value = std::strtod(inside.c_str() + equals + 1, nullptr);
  return Tag{inside.substr(0, equals), std::isfinite(value) ? value : 0, end + 1};
}

bool isSpace(char letter) {
  return letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r';
}

// UTF-8: every byte but those that continue a character.
bool startsCharacter(char byte) { return (static_cast<unsigned char>(byte) & 0xc0U) != 0x80U; }

// Walks through a text in step with the voice.
class Voice {
 public:
  explicit Voice(double speed) : speed_(speed) {}

  void take(char letter) {
    if (isSpace(letter)) {
      endWord();
    } else {
      if (word_.empty()) word_start_ = now_;
      word_ += letter;
    }
    if (startsCharacter(letter)) now_ += 1 / (kCharactersPerSecond * speed_ * pace_);
  }

  void take(const Tag& tag) {
    endWord();
    if (tag.name == "pau") now_ += std::clamp(tag.value / 1000, 0.0, kLongestPause);
    if (tag.name == "rspd") pace_ = std::clamp(tag.value / 100, 0.3, 4.0);
    if (tag.name == "mrk") {
      constexpr double kLast = 65535;
      spoken_.marks.push_back(
          {static_cast<int>(std::clamp(tag.value, 0.0, kLast)), fromSeconds(now_)});
    }
  }

  SpokenText finish() {
    endWord();
    spoken_.length = std::max<Duration>(fromSeconds(now_), kLeast);
    return std::move(spoken_);
  }

 private:
  void endWord() {
    if (word_.empty()) return;
    spoken_.words.push_back({std::move(word_), fromSeconds(word_start_)});
    word_.clear();
  }

  double speed_;
  double pace_ = 1;  // what \rspd says
  double now_ = 0;   // [s]
  std::string word_;
  double word_start_ = 0;  // [s]
  SpokenText spoken_;
};

}  // namespace

SpokenText calcSpokenText(const std::string& text, double speed) {
  Voice voice(speed);
  for (std::size_t i = 0; i < text.size();) {
    if (const auto tag = findTag(text, i)) {
      voice.take(*tag);
      i = tag->end;
    } else {
      voice.take(text[i++]);
    }
  }
  return voice.finish();
}

}  // namespace nao::services

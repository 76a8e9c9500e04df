#pragma once

#include <string>
#include <vector>

#include "core/sim_time.h"

namespace nao::services {

/// A text as a voice would say it: what happens when, after it began. Voice tags of the form
/// \name=value\ are not spoken: \pau=ms\ is a pause, \mrk=number\ a bookmark, \rspd=percent\ the
/// speed from there on; others change the sound only and are left out.
struct SpokenText {
  struct Word {
    std::string text;
    Duration start{};
  };
  struct Mark {
    int number = 0;
    Duration start{};
  };
  std::vector<Word> words;
  std::vector<Mark> marks;
  Duration length{};
};

/// How long words take is a choice: 14 characters a second, which is an unhurried speaker of
/// English (150 words a minute), and half a second at least for any text. `speed`: 1 is that.
SpokenText calcSpokenText(const std::string& text, double speed = 1);

}  // namespace nao::services

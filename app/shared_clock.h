#pragma once

#include <string>

#include "clock/clock_page.h"

namespace nao::app {

/// The page through which a world and the programs in its time share clocks and turns: nameless
/// memory of this process, so that nothing of it can stay behind. Both children inherit the page;
/// programs open it by path().
class SharedClock {
 public:
  /// @throws InputError when the system gives none.
  explicit SharedClock(clock::Mode mode);
  SharedClock(const SharedClock&) = delete;
  SharedClock& operator=(const SharedClock&) = delete;
  ~SharedClock();

  clock::ClockPage& page() { return *page_; }
  std::string path() const;

  /// The world has ended: from now on programs' clocks go on by themselves.
  void stop();

 private:
  int file_ = -1;
  clock::ClockPage* page_ = nullptr;
};

/// The library that makes a program's clocks the world's; beside this program.
/// @throws InputError if it is not there.
std::string clockLibrary();

}  // namespace nao::app

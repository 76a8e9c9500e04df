#pragma once

#include <unistd.h>

#include <cstdint>

#include "core/latest.h"

namespace nao::daemon {

/// A connected LoLA client as the simulation thread sees it: a descriptor of its own to send to,
/// closed with the object.
class LolaPeer {
 public:
  LolaPeer(std::uint64_t number, int socket) : number_(number), descriptor_(::dup(socket)) {}
  ~LolaPeer() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  LolaPeer(const LolaPeer&) = delete;
  LolaPeer& operator=(const LolaPeer&) = delete;

  std::uint64_t number() const { return number_; }  // another one for every client
  int descriptor() const { return descriptor_; }    // below 0: none was left

 private:
  std::uint64_t number_;
  int descriptor_;
};

/// Where the I/O thread, which reads a robot's LoLA socket, meets the simulation thread, which
/// sends.
struct LolaMeeting {
  Latest<LolaPeer> peer;        // who is connected; null: nobody
  Latest<std::uint64_t> heard;  // how often actuator frames came; null: never
};

}  // namespace nao::daemon

#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "core/latest.h"

namespace nao::daemon {

/// A connected LoLA client: a descriptor of its own to send to, closed with the object, and what
/// has become of what was sent. Any thread.
class LolaPeer {
 public:
  explicit LolaPeer(int socket);
  ~LolaPeer();
  LolaPeer(const LolaPeer&) = delete;
  LolaPeer& operator=(const LolaPeer&) = delete;

  enum class Sent { Whole, Not, Gone };
  /// A frame, without waiting for anything.
  Sent send(const std::string& frame);

  /// Frames that were sent whole. One that its client has read is counted.
  std::uint64_t framesSent() const;

  /// Whether it has read all of them; never again if it closed before.
  bool hasReadAll() const;

 private:
  int descriptor_;  // below 0: none was left
  mutable std::mutex mutex_;
  std::uint64_t frames_ = 0;
  mutable bool left_some_ = false;  // unread, when it closed
};

/// What the I/O thread knows of a robot's clients, as of one moment.
struct LolaNews {
  std::shared_ptr<LolaPeer> peer;    // who is connected; null: nobody
  std::uint64_t clients = 0;         // that have come, it included
  std::uint64_t answers = 0;         // to frames; one a frame at most
  std::uint64_t answers_before = 0;  // of them, those of clients before the last
};

/// Where the I/O thread, which reads a robot's LoLA socket, meets the simulation thread, which
/// sends.
struct LolaMeeting {
  Latest<LolaNews> news;  // null: nobody ever came
};

}  // namespace nao::daemon

#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/robot_io.h"
#include "daemon/lola_meeting.h"
#include "naoqi_api/wire/lola_sensors.h"

namespace nao::daemon {

/// Sends a robot's LoLA client what the robot senses: at every cycle one frame in one piece. Never
/// waits: a client that has not read its last frame misses this one, so that it never finds more
/// than one. Simulation thread.
class LolaSender {
 public:
  static constexpr Duration kCycle = std::chrono::milliseconds(12);

  using Seconds = std::chrono::duration<double>;

  /// How the world waits for clients.
  struct Lockstep {
    std::optional<Seconds> patience;  // for an answer, of the wall; none: it does not wait at all
    bool for_next = false;            // for another client, too, when the first one has gone
  };
  LolaSender(wire::LolaSensors encoder, std::shared_ptr<LolaMeeting> meeting, Lockstep lockstep);

  void send(const SensorFrame& frame, const JointCommand& command);

  /// Whether the world has to wait at `now`: for its first client, and then, before each of the
  /// robot's cycles, for the answer to the frame before. A client that takes too long is waited for
  /// again once it has answered.
  bool holdsTime(SimTime now);

 private:
  std::uint64_t heard() const;
  bool isPatient();

  wire::LolaSensors encoder_;
  std::shared_ptr<LolaMeeting> meeting_;
  const Lockstep lockstep_;
  bool came_ = false;          // a client has, once
  std::uint64_t sent_to_ = 0;  // the last frame; 0: it was not sent
  std::uint64_t gone_ = 0;     // the last client that had closed when a frame was sent
  std::uint64_t heard_then_ = 0;
  std::optional<std::chrono::steady_clock::time_point> waits_since_;
  bool gave_up_ = false;
};

}  // namespace nao::daemon

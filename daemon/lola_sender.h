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
/// than one; a receive with room for two may get the next as well if that is sent while it runs.
/// Simulation thread.
class LolaSender {
 public:
  static constexpr Duration kCycle = std::chrono::milliseconds(12);

  using Seconds = std::chrono::duration<double>;

  /// `patience`: of the wall, for an answer; none: the world does not wait at all.
  LolaSender(wire::LolaSensors encoder, std::shared_ptr<LolaMeeting> meeting,
             std::optional<Seconds> patience);

  void send(const SensorFrame& frame, const JointCommand& command);

  /// What the client asks of the time. Every client that comes and every answer is followed by one
  /// cycle, whether its client is still there or not; so it does not matter when that is seen.
  enum class Wish {
    Go,    // a cycle is due; or no cycle is near, or nobody is waited for
    Wait,  // for the first client, or for the answer to the last frame
    Rest,  // the client has gone, all that it ordered has been done
  };
  /// At `now`, before a cycle. A client that takes too long is waited for again once it has
  /// answered.
  Wish wish(SimTime now);

 private:
  void sendTo(LolaPeer& peer, const SensorFrame& frame, const JointCommand& command);
  bool isThere(const LolaNews& news) const;
  bool isPatient();

  wire::LolaSensors encoder_;
  std::shared_ptr<LolaMeeting> meeting_;
  const std::optional<Seconds> patience_;
  std::uint64_t greeted_ = 0;   // clients whose first cycle has been
  std::uint64_t followed_ = 0;  // answers whose cycle has been
  std::uint64_t sent_to_ = 0;   // whose client's number the last frame was sent to; 0: to nobody
  std::uint64_t gone_ = 0;      // the last client that had closed when a frame was sent
  std::optional<std::chrono::steady_clock::time_point> waits_since_;
  bool gave_up_ = false;
};

}  // namespace nao::daemon

#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/robot_io.h"
#include "core/scene_frame.h"

namespace nao::ci {

/// A value of a robot's memory, as text and, if it is one, as a number.
struct HeardValue {
  std::string text;
  std::optional<double> number;
};
/// An event that was raised.
struct HeardEvent {
  std::size_t robot = 0;
  std::string key;
  HeardValue value;
};
/// What came from the robots' services between two beats, and what memory held at the second.
struct Heard {
  std::vector<HeardEvent> events;                                    // in order
  std::map<std::pair<std::size_t, std::string>, HeardValue> memory;  // by robot and key
};

/// A program that has ended.
struct EndedClient {
  std::size_t client = 0;
  int code = 0;  // 128 + n: by signal n
};

/// A fault that a robot showed at a beat, for NoViolation.
struct Violation {
  std::size_t robot = 0;
  std::string kind;
  std::string text;  // "LKneePitch asked for 400 degrees/s, its top speed is 366 degrees/s"
};

/// All that is judged at one beat.
struct Moment {
  SimTime now{};
  std::shared_ptr<const SceneFrame> scene;                  // the truth
  std::vector<std::shared_ptr<const SensorFrame>> sensors;  // by robot; null before the first
  Heard heard;
  std::vector<EndedClient> ended;     // since the beat before
  std::vector<Violation> violations;  // at this beat
};

}  // namespace nao::ci

#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <variant>

#include <Eigen/Core>

#include "core/joint.h"
#include "core/sim_time.h"

namespace nao::ci {

/// What a value heard from a robot should be; what is not given does not matter.
struct Comparison {
  std::optional<std::string> equals;    // as a number if both are numbers, else as text
  std::optional<std::string> contains;  // in the value as text
  std::optional<double> min, max;
  double tolerance = 0;  // of `equals`

  bool accepts(const std::string& text, const std::optional<double>& number) const;
  /// "at least 0.5", or nothing.
  std::string described() const;
};

/// The torso tilts by less than 60 degrees from upright.
struct Upright {
  std::size_t robot = 0;
};
/// The torso tilts by more than that.
struct Fallen {
  std::size_t robot = 0;
};
/// A robot's place on the floor, between its soles, or a ball's.
struct InPlace {
  bool is_ball = false;
  std::size_t which = 0;
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  // [m] in W
  double radius = 0;                                 // [m]
  std::optional<double> heading;                     // [rad] of a robot
  double heading_tolerance = 0;                      // [rad]
};
/// What ALMemory holds under a key.
struct MemoryIs {
  std::size_t robot = 0;
  std::string key;
  Comparison value;
};
/// An event that ALMemory raises.
struct EventRaised {
  std::size_t robot = 0;
  std::string key;
  Comparison value;
};
/// A text that the robot begins to say.
struct TextSaid {
  std::size_t robot = 0;
  std::string text;  // part of it
};
struct ClientEnded {
  std::size_t client = 0;
  int code = 0;
};
/// A ball in a camera's picture, as its pinhole sees the world at 160 x 120.
struct SeesBall {
  std::size_t robot = 0;
  std::size_t camera = 0;
  std::size_t ball = 0;
  int pixels = 1;  // at least so many
};
/// What a joint's encoder reports.
struct JointIs {
  std::size_t robot = 0;
  Joint joint{};
  double angle = 0;      // [rad]
  double tolerance = 0;  // [rad]
};
/// Nothing that a robot should not be asked for, or do: kinds as in ViolationLog.
struct NoViolation {
  std::size_t robot = 0;
  std::set<std::string> allowed;
};

using Condition = std::variant<Upright, Fallen, InPlace, MemoryIs, EventRaised, TextSaid,
                               ClientEnded, SeesBall, JointIs, NoViolation>;

/// When a condition is to hold. `At`: in the first beat at or after `to`. `By`: at some beat after
/// `from` and up to `to`. `Always`, `Never`: at every or no beat from `from` to `to`.
struct When {
  enum class Kind { At, By, Always, Never };
  Kind kind = Kind::Always;
  Duration from{};
  Duration to{};

  std::string described() const;
};

struct Expectation {
  Condition condition;
  When when;
  std::string text;  // "nao within 0.1 m of (0.5, 0) at 15 s"
  int line = 0;      // of the scenario's file
};

}  // namespace nao::ci

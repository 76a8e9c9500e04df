#pragma once

#include <vector>

#include "core/archive.h"
#include "core/robot_io.h"
#include "core/robot_model.h"
#include "sim/surroundings.h"

namespace nao::sim {

/// The ultrasonic sensors. Ten times a second every receiver hears, of each thing around, the echo
/// of its nearest surface point that lies inside the receiver's cone; echoes come nearest first.
/// Nearer than the smallest range a thing is there, no more is known: it reads that range. Where
/// no (further) echo comes it reads the largest. Things: obstacles, balls, other robots' solids;
/// not the ground, and nothing hides behind another thing.
class Sonar {
 public:
  explicit Sonar(const RobotModel& model) : model_(model) {}

  void reset() { since_ = kPeriod; }

  /// `dt` [s] since the sample before.
  void sample(const Surroundings& around, double dt, SensorFrame& frame);

  /// What a receiver at `X_WR`, looking along its x axis, hears now.
  SonarEchoes listen(const Surroundings& around, const Pose& X_WR) const;

  void archive(Archive& archive) {
    archive.value(since_);
    archive.value(echoes_);
  }

 private:
  static constexpr double kPeriod = 0.1;  // [s] between pings (2.1.4.13 documentation, sonar)

  const RobotModel& model_;
  double since_ = kPeriod;  // [s] the last ping
  std::array<SonarEchoes, 2> echoes_{};
};

/// The distance [m] from the apex of the cone about the x axis of `X_WC` to the nearest point of
/// `shape` that is inside it, `half_angle` [rad] wide; beyond `farthest`: none.
std::optional<double> calcDistanceInCone(const Pose& X_WC, double half_angle, double farthest,
                                         const Shape& shape, const Pose& X_WS);

}  // namespace nao::sim

#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "ci/result.h"
#include "core/scene_frame.h"
#include "runtime/simulation.h"

namespace nao::ci {

/// Keeps what a report shows of the last seconds: scenes for its filmstrip, and what joints, robots
/// and balls did. Once something has failed, it goes on for a second and keeps that. Simulation
/// thread.
class LastSeconds {
 public:
  static constexpr Duration kLength = std::chrono::seconds(4);        // free choice
  static constexpr Duration kAfterwards = std::chrono::seconds(1);    // after a failure
  static constexpr Duration kStill = std::chrono::milliseconds(500);  // between two pictures

  /// At every beat.
  void look(runtime::Simulation& simulation, const std::shared_ptr<const SceneFrame>& scene,
            bool has_failed);

  /// Draws the pictures.
  Course take() const;

 private:
  struct Beat {
    double time = 0;                          // [s]
    std::vector<std::vector<double>> asked;   // [rad] by robot and joint; empty before the first
    std::vector<std::vector<double>> sensed;  // [rad]
    std::vector<Pose2> robots;                // on the floor
    std::vector<Eigen::Vector2d> balls;       // [m]
  };
  void keepBeat(runtime::Simulation& simulation, const SceneFrame& scene);

  std::deque<Beat> beats_;
  std::deque<std::shared_ptr<const SceneFrame>> scenes_;
  SimTime stop_ = SimTime::max();
};

}  // namespace nao::ci

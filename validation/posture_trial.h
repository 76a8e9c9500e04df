#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "validation/motion_trial.h"
#include "validation/trial.h"

namespace nao::validation {

/// How goToPosture went, asked again after every failure as ALRobotPosture does.
struct Arrival {
  bool said = false;   // by the robot, from what it senses
  bool there = false;  // in truth, and still there a second later
  int tries = 0;
  double seconds = 0;   // until the robot said so or gave up
  double tilt_deg = 0;  // of the torso from upright, at the end
};

/// A robot that differs from run to run in mass and friction too (Spread), sent into postures.
class PostureTrial {
 public:
  static constexpr int kTries = 3;  // ALRobotPosture's maxTryNumber, unless a client changes it

  PostureTrial(const ExperimentSettings& settings, std::uint64_t seed);

  Arrival goTo(const std::string& posture, int tries = kTries);
  /// A push at the torso that a standing robot can not bear, along its own x and y axis; then all
  /// joints are stiff again.
  void knockOver(double newton_x, double newton_y);
  /// Whether the limbs and the torso, not their sensors, are as `posture` says.
  bool isReallyIn(const std::string& posture);

  Trial& trial() { return trial_; }

 private:
  double calcTilt();

  Trial trial_;
};

}  // namespace nao::validation

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/scene_frame.h"
#include "sim/effects/catalogue.h"
#include "sim/robot_body.h"
#include "sim/sensor_board.h"
#include "sim/world.h"

namespace nao::sim {

/// One robot of a world: its body, its effects, its sensors, and what it was told last.
class WorldRobot {
 public:
  WorldRobot(const RobotSetup& setup, const WorldModel& world, const WorldOptions& options);

  RobotBody& body() { return body_; }
  const RobotBody& body() const { return body_; }
  std::map<std::string, double> draw() const { return effects_.draw(); }

  /// From now on `watch`, which must outlive the robot, is told of the phases of its steps.
  void setWatch(const PhaseWatch* watch);

  /// At rest and limp, in the start posture or in `angles`.
  void place(const Pose2& pose, const JointArray<double>* angles);
  /// Where it started, the seed's offset included.
  void reset();

  void setCommand(const JointCommand& command, SimTime now);
  bool setLeds(const std::string& leds, float brightness);
  Faults& faults() { return faults_; }
  SensorBoard& sensors() { return sensors_; }
  void setLensDirt(std::size_t camera, float dirt) { lens_dirt_[camera] = dirt; }
  void push(const Vec3& force_W, SimTime until) { push_ = {force_W, until}; }

  /// Lets effects, motors and `external` forces act from `now` for `step`.
  void step(SimTime now, Duration step, std::vector<ExternalForce>& external);

  SensorFrame readSensors(const Surroundings& around, SimTime now);
  TouchSensors& touch() { return sensors_.touch(); }
  SceneFrame::Robot scene() const;
  void archive(Archive& archive);

 private:
  struct Push {
    Vec3 f_W = Vec3::Zero();
    SimTime until{};
  };
  const DriveTerms* calcTerms(SimTime now, double h);
  void ended(Phase phase) const {
    if (watch_) (*watch_)(phase);
  }

  const RobotSetup& setup_;
  EffectChain effects_;
  RobotBody body_;
  SensorBoard sensors_;
  Faults faults_;
  JointCommand sent_;  // by the control side
  SimTime sent_at_{};
  JointCommand followed_;  // by the motors, after the effects
  DriveTerms terms_;
  Push push_;
  std::vector<std::string> led_names_;
  LedState leds_{};
  std::vector<float> lens_dirt_;  // by camera
  const PhaseWatch* watch_ = nullptr;
};

}  // namespace nao::sim

#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/value_ptr.h"
#include "motion/phase.h"
#include "motion/speed_profile.h"
#include "motion/trajectory.h"

namespace nao::motion {

/// Follows the keys of one or more joints.
class FollowCurves final : public Phase {
 public:
  explicit FollowCurves(Interpolate request) : request_(std::move(request)) {}
  void begin(Body& body) override;
  Progress advance(double dt, const JointSet& mine, Body& body) override;
  std::unique_ptr<Phase> clone() const override { return std::make_unique<FollowCurves>(*this); }
  void archive(Archive& archive) override;

 private:
  struct Track {
    Joint joint{};
    Trajectory trajectory;
  };
  Interpolate request_;
  std::vector<Track> tracks_;
  double elapsed_ = 0;
  double duration_ = 0;
};

/// A straight way of several joints to their targets, all at the same pace.
class Glide final : public Phase {
 public:
  struct Course {
    JointSet joints;
    JointArray<double> target;  // [rad]
    double fraction = 1;        // of each joint's top speed, never passed
    double ramp = 0.2;          // [s] to reach that speed and to lose it again
    double at_least = 0;        // [s] if there is any way to go
  };
  explicit Glide(const Course& course) : course_(course) {}
  void begin(Body& body) override;
  Progress advance(double dt, const JointSet& mine, Body& body) override;
  std::unique_ptr<Phase> clone() const override { return std::make_unique<Glide>(*this); }
  void archive(Archive& archive) override;

 private:
  Course course_;
  JointArray<double> start_;
  SpeedProfile profile_{0, 0};
  double elapsed_ = 0;
};

/// Several phases, one after the other; the first failure ends them all.
class Sequence final : public Phase {
 public:
  explicit Sequence(std::vector<ValuePtr<Phase>> phases) : phases_(std::move(phases)) {}
  void begin(Body& body) override;
  Progress advance(double dt, const JointSet& mine, Body& body) override;
  std::string failure() const override;
  std::unique_ptr<Phase> clone() const override { return std::make_unique<Sequence>(*this); }
  void archive(Archive& archive) override;

 private:
  std::vector<ValuePtr<Phase>> phases_;
  std::size_t current_ = 0;
  bool begun_ = false;
};

/// Another phase, but only if the robot is in a certain state when its turn comes.
class OnlyIf final : public Phase {
 public:
  using Condition = std::function<bool(const Body&)>;
  OnlyIf(Condition condition, ValuePtr<Phase> phase)
      : condition_(std::move(condition)), phase_(std::move(phase)) {}
  void begin(Body& body) override;
  Progress advance(double dt, const JointSet& mine, Body& body) override;
  std::string failure() const override { return phase_->failure(); }
  std::unique_ptr<Phase> clone() const override { return std::make_unique<OnlyIf>(*this); }
  void archive(Archive& archive) override;

 private:
  Condition condition_;
  ValuePtr<Phase> phase_;
  bool applies_ = false;
};

/// All joints to one stiffness along a line; a stiff robot is awake.
class RampStiffness final : public Phase {
 public:
  RampStiffness(double value, double seconds) : value_(value), seconds_(seconds) {}
  void begin(Body& body) override;
  Progress advance(double dt, const JointSet& mine, Body& body) override;
  std::unique_ptr<Phase> clone() const override { return std::make_unique<RampStiffness>(*this); }
  void archive(Archive& archive) override;

 private:
  double value_;
  double seconds_;
  double elapsed_ = 0;
};

/// Gives the body a moment to arrive at a posture and fails if it has not.
class CheckPosture final : public Phase {
 public:
  /// `posture` must outlive this.
  explicit CheckPosture(const Posture& posture) : posture_(posture) {}
  void begin(Body& body) override;
  Progress advance(double dt, const JointSet& mine, Body& body) override;
  std::string failure() const override;
  std::unique_ptr<Phase> clone() const override { return std::make_unique<CheckPosture>(*this); }
  void archive(Archive& archive) override;

 private:
  const Posture& posture_;
  double elapsed_ = 0;
};

}  // namespace nao::motion

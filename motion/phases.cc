#include "motion/phases.h"

#include <algorithm>
#include <cmath>

#include "motion/postures.h"

namespace nao::motion {
namespace {

// Half a nanosecond: below any cycle, above the rounding of summed cycles.
constexpr double kTimeRounding = 5e-10;  // [s]

// The servos lag a few cycles behind and give way under load; longer means it will not arrive.
constexpr double kTimeToArrive = 1.0;  // [s]

Phase::Progress progressAt(double elapsed, double duration) {
  return elapsed >= duration - kTimeRounding ? Phase::Progress::Done : Phase::Progress::Running;
}

void archiveKey(Archive& archive, Key& key) {
  archive.value(key.time);
  archive.value(key.angle);
  for (Handle* handle : {&key.before, &key.after}) {
    archive.value(handle->kind);
    archive.value(handle->dt);
    archive.value(handle->dangle);
  }
}

}  // namespace

void FollowCurves::begin(Body& body) {
  for (Curve& curve : request_.curves) {
    const double start = body.angle[curve.joint];
    if (request_.relative) {
      for (Key& key : curve.keys) key.angle += start;
    }
    if (request_.smooth) setAutoHandles(start, curve.keys);
    tracks_.push_back({curve.joint, Trajectory(start, curve.keys)});
    duration_ = std::max(duration_, tracks_.back().trajectory.duration());
  }
  request_ = {};
}

Phase::Progress FollowCurves::advance(double dt, const JointSet& mine, Body& body) {
  elapsed_ += dt;
  const Progress progress = progressAt(elapsed_, duration_);
  const double time = progress == Progress::Done ? duration_ : elapsed_;
  for (const Track& track : tracks_) {
    if (mine.test(index(track.joint))) body.angle[track.joint] = track.trajectory.at(time);
  }
  return progress;
}

void FollowCurves::archive(Archive& archive) {
  archive.value(request_.relative);
  archive.value(request_.smooth);
  archive.each(request_.curves, [&archive](Curve& curve) {
    archive.value(curve.joint);
    archive.each(curve.keys, [&archive](Key& key) { archiveKey(archive, key); });
  });
  archive.each(tracks_, [&archive](Track& track) {
    archive.value(track.joint);
    track.trajectory.archive(archive);
  });
  archive.value(elapsed_);
  archive.value(duration_);
}

void Glide::begin(Body& body) {
  start_ = body.angle;
  double way_time = 0;
  for (std::size_t i = 0; i < start_.size(); ++i) {
    if (!course_.joints.test(i)) continue;
    const double speed = course_.fraction * body.model.actuators[i].max_velocity;
    way_time = std::max(way_time, std::abs(course_.target[i] - start_[i]) / speed);
  }
  if (way_time > 0) way_time = std::max(way_time, course_.at_least - course_.ramp);
  profile_ = SpeedProfile(way_time, course_.ramp);
}

Phase::Progress Glide::advance(double dt, const JointSet& mine, Body& body) {
  elapsed_ += dt;
  const Progress progress = progressAt(elapsed_, profile_.duration());
  const double part = progress == Progress::Done ? 1 : profile_.at(elapsed_);
  for (std::size_t i = 0; i < start_.size(); ++i) {
    if (!course_.joints.test(i) || !mine.test(i)) continue;
    body.angle[i] = start_[i] + part * (course_.target[i] - start_[i]);
  }
  return progress;
}

void Glide::archive(Archive& archive) {
  archive.value(course_.joints);
  archive.value(course_.target);
  archive.value(course_.fraction);
  archive.value(course_.ramp);
  archive.value(course_.at_least);
  archive.value(start_);
  profile_.archive(archive);
  archive.value(elapsed_);
}

void Sequence::begin(Body& /*body*/) { begun_ = false; }

Phase::Progress Sequence::advance(double dt, const JointSet& mine, Body& body) {
  if (current_ == phases_.size()) return Progress::Done;
  Phase& phase = *phases_[current_];
  if (!begun_) phase.begin(body);
  begun_ = true;
  const Progress progress = phase.advance(dt, mine, body);
  if (progress != Progress::Done) return progress;
  begun_ = false;
  ++current_;
  return current_ == phases_.size() ? Progress::Done : Progress::Running;
}

std::string Sequence::failure() const {
  return current_ < phases_.size() ? phases_[current_]->failure() : std::string();
}

void Sequence::archive(Archive& archive) {
  archive.value(current_);
  archive.value(begun_);
  for (const ValuePtr<Phase>& phase : phases_) phase->archive(archive);
}

void OnlyIf::begin(Body& body) {
  applies_ = condition_(body);
  if (applies_) phase_->begin(body);
}

Phase::Progress OnlyIf::advance(double dt, const JointSet& mine, Body& body) {
  return applies_ ? phase_->advance(dt, mine, body) : Progress::Done;
}

void OnlyIf::archive(Archive& archive) {
  archive.value(applies_);
  phase_->archive(archive);
}

void RampStiffness::begin(Body& body) {
  const JointArray<double>& now = body.stiffness.value();
  const auto is_there = [this](double stiffness) { return stiffness == value_; };
  if (std::all_of(now.begin(), now.end(), is_there)) seconds_ = 0;
  body.stiffness.ramp(allJoints(body.model), value_, seconds_);
}

Phase::Progress RampStiffness::advance(double dt, const JointSet& /*mine*/, Body& body) {
  elapsed_ += dt;
  const Progress progress = progressAt(elapsed_, seconds_);
  if (progress == Progress::Done) body.awake = value_ > 0;
  return progress;
}

void RampStiffness::archive(Archive& archive) {
  archive.value(value_);
  archive.value(seconds_);
  archive.value(elapsed_);
}

void CheckPosture::begin(Body& /*body*/) { elapsed_ = 0; }

Phase::Progress CheckPosture::advance(double dt, const JointSet& /*mine*/, Body& body) {
  elapsed_ += dt;
  if (isIn(body.model, body.measured, posture_)) return Progress::Done;
  return elapsed_ < kTimeToArrive ? Progress::Running : Progress::Failed;
}

void CheckPosture::archive(Archive& archive) {
  JointArray<double> angle = posture_.angle;
  archive.value(angle);
  archive.value(elapsed_);
}

std::string CheckPosture::failure() const {
  return "the robot did not arrive in the posture " + posture_.name;
}

}  // namespace nao::motion

// Faults of the inertial unit by other laws than the catalogue's: turned by angles one after
// another, smoothed by a mean over the last readings.
#include <algorithm>
#include <deque>

#include "tests/hidden/laws/laws.h"

namespace nao::hidden {
namespace {

// Mounted turned: about z, then the new y, then the new x.
class TurnedBoard final : public sim::Effect {
 public:
  explicit TurnedBoard(const sim::EffectSetup& setup)
      : R_TB_(Eigen::AngleAxisd(setup.value("z"), Vec3::UnitZ()) *
              Eigen::AngleAxisd(setup.value("y"), Vec3::UnitY()) *
              Eigen::AngleAxisd(setup.value("x"), Vec3::UnitX())) {}

  void alterImu(SensorFrame& frame, Duration) override {
    frame.accelerometer = R_TB_.conjugate() * frame.accelerometer;
    frame.gyroscope = R_TB_.conjugate() * frame.gyroscope;
  }

 private:
  Eigen::Quaterniond R_TB_;
};

// Tells the mean of what it read during the last `time`.
class AveragingBoard final : public sim::Effect {
 public:
  explicit AveragingBoard(const sim::EffectSetup& setup) : time_(setup.value("time")) {}

  void alterImu(SensorFrame& frame, Duration cycle) override {
    readings_.push_back({frame.accelerometer, frame.gyroscope});
    const auto most = static_cast<std::size_t>(std::max(1.0, time_ / toSeconds(cycle)));
    while (readings_.size() > most) readings_.pop_front();
    frame.accelerometer.setZero();
    frame.gyroscope.setZero();
    for (const Reading& one : readings_) {
      frame.accelerometer += one.acceleration / static_cast<double>(readings_.size());
      frame.gyroscope += one.turning / static_cast<double>(readings_.size());
    }
  }

  // A run is never taken up in the middle.
  void archive(Archive& archive) override {
    if (archive.mode() == Archive::Mode::Load) readings_.clear();
  }

 private:
  struct Reading {
    Vec3 acceleration;  // [m/s^2]
    Vec3 turning;       // [rad/s]
  };
  double time_;  // [s]
  std::deque<Reading> readings_;
};

}  // namespace

sim::EffectType turnedBoard() {
  return {
      "hidden_turned_board",
      "The inertial unit sits turned, by angles about its own axes.",
      {{"x", "rad", 0, 0, -1, 1, 0}, {"y", "rad", 0, 0, -1, 1, 0}, {"z", "rad", 0, 0, -1, 1, 0}},
      sim::Acts::OnImu,
      sim::makeEffect<TurnedBoard>};
}

sim::EffectType averagingBoard() {
  return {"hidden_averaging_board",
          "The inertial unit tells means.",
          {{"time", "s", 0, 0, 0, 1, 0}},
          sim::Acts::OnImu,
          sim::makeEffect<AveragingBoard>};
}

}  // namespace nao::hidden

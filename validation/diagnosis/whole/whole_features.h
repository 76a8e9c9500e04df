#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "validation/diagnosis/replay/whole_simulator.h"

namespace nao::validation {

/// Where one signal stands in the features of a run.
struct FeatureGroup {
  std::string name;  // of the joint; "roll", "pitch", "weight_left" ...; "gait"
  std::string unit;
  Eigen::Index offset = 0, size = 0;
  double dt = 0;     // [s] between values; 0: they are no course of time
  double floor = 0;  // SD below which nothing is told apart, in the group's unit
};

/// What of a run is compared, as one vector: angles of joints, tilt of the torso and weight on the
/// soles in bins of 20 ms; of every half second the mean of accelerometer and gyroscope, in which
/// what steps and gears make them shake is gone, and how far the torso came and turned, seen from
/// where it was then (chaos adds up in places, not in these); and the run's gait numbers.
class FeatureSpace {
 public:
  /// `joints`: whose angles count; `body`: whether tilt, weight, place and gait do.
  FeatureSpace(const WholeSimulator& simulator, const WholeBlock& block,
               const std::vector<Joint>& joints, bool body);

  Eigen::Index size() const { return size_; }
  const std::vector<FeatureGroup>& groups() const { return groups_; }
  Eigen::VectorXd of(const WholeRun& run) const;

 private:
  void add(std::string name, std::string unit, Eigen::Index size, double dt, double floor);

  std::vector<Joint> joints_;
  bool body_;
  Eigen::Index rows_, per_bin_, per_stretch_;
  Eigen::Index size_ = 0;
  std::vector<FeatureGroup> groups_;
};

}  // namespace nao::validation

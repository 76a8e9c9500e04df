#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace nao::validation {

/// Torques that a joint's own motion makes up: a library of shapes in which a remainder is written.
/// A feature has one column, two (sine and cosine) or three.
class TorqueFeatures {
 public:
  TorqueFeatures();

  struct Feature {
    std::string name;  // "v|v|", "sin and cos of 18 q" ...
    std::vector<Eigen::Index> columns;
    int periods = 0;  // in 2 pi of the joint, of a torque that goes with its angle alone
  };

  /// Of how many columns the last are not torques of the motion's own but what the model lacks
  /// where its encoder misreads by shapes of `misreading`.
  Eigen::Index misreadings() const { return misreadings_; }
  Eigen::Index columns() const { return columns_; }
  /// Shape of the i-th of those, at these angles.
  Eigen::VectorXd misreading(Eigen::Index i, const Eigen::VectorXd& angle) const;

  const std::vector<Feature>& all() const { return features_; }

  /// Every column, a row per sample [N m for a factor of one], of one motion: its angle, rate and
  /// second rate by column, and what its servo is off by. Those of misreadings are left zero.
  Eigen::MatrixXd along(const Eigen::MatrixXd& motion, const Eigen::VectorXd& error,
                        double dt) const;

 private:
  void add(const std::string& name, Eigen::Index columns);
  void addDryPlaces();

  std::vector<Feature> features_;
  Eigen::Index columns_ = 0, misreadings_ = 0;
};

}  // namespace nao::validation

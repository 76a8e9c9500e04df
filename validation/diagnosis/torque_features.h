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
  };

  const std::vector<Feature>& all() const { return features_; }

  /// Every column, a row per sample [N m for a factor of one], of one motion: its angle, rate and
  /// second rate by column, and what its servo is off by.
  Eigen::MatrixXd along(const Eigen::MatrixXd& motion, const Eigen::VectorXd& error,
                        double dt) const;

 private:
  void add(const std::string& name, Eigen::Index columns);

  std::vector<Feature> features_;
  Eigen::Index columns_ = 0;
};

}  // namespace nao::validation

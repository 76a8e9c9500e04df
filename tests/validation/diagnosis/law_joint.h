#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/random.h"
#include "sim/effects/catalogue.h"
#include "validation/diagnosis/ensemble/joint_data.h"
#include "validation/diagnosis/joint/candidate_fit.h"

namespace nao::validation::test {

constexpr JointNoise kNoNoise{};

/// The course that a law stretches; it leads as far to either side.
inline Eigen::VectorXd drag(Eigen::Index rows) {
  Eigen::VectorXd course(rows);
  for (Eigen::Index k = 0; k < rows; ++k) course[k] = std::cos(0.02 * static_cast<double>(k));
  return course;
}

/// Moves as a law says of one number, along drag(); runs of different numbers part ways by chance.
class LawJoint final : public JointSimulator {
 public:
  LawJoint(std::string parameter, double number, double chance, std::function<double(double)> law)
      : parameter_(std::move(parameter)), chance_(chance), law_(std::move(law)) {
    measured_ = {{"fit", Split::Fit, 0.01, {}}, {"select", Split::Select, 0.01, {}}};
    for (JointMotion& motion : measured_) {
      for (std::uint64_t r = 0; r < 6; ++r) motion.repeats.push_back(angle(number, 1000 + r));
    }
  }

  std::string joint() const override { return "Law"; }
  const std::vector<JointMotion>& measured() const override { return measured_; }
  Eigen::MatrixXd run(const std::vector<EffectSetting>& causes, std::size_t motion,
                      std::uint64_t stream, const JointNoise&) const override {
    double number = 0;
    for (const EffectSetting& cause : causes) number += cause.parameters.at(parameter_);
    return angle(number, 10 * stream + motion);
  }

 private:
  Eigen::MatrixXd angle(double number, std::uint64_t stream) const {
    Random random(stream, std::to_string(number));
    Eigen::MatrixXd angle = law_(number) * drag(300);
    for (Eigen::Index k = 0; k < angle.rows(); ++k) angle(k, 0) += chance_ * random.normal();
    return angle;
  }

  std::string parameter_;
  double chance_;
  std::function<double(double)> law_;
  std::vector<JointMotion> measured_;
};

/// Such a joint, and what fits of one cause to it need.
struct LawSearch {
  LawSearch(const std::string& id, const JointSimulator& joint)
      : causes{bounded(id, joint)},
        data(joint, kNoNoise),
        ensemble(joint, data, kNoNoise, 1000000),
        stage(ensemble, data, causes, {}, Eigen::MatrixXd(data.size(), 0), effort) {
    stage.lookAround();
  }

  static Cause bounded(const std::string& id, const JointSimulator& joint) {
    for (const Cause& cause : jointCauses()) {
      if (cause.id == id) return boundedAt(cause, joint, sim::standardEffects());
    }
    throw std::logic_error(id);
  }

  std::vector<Cause> causes;
  JointData data;
  Ensemble ensemble;
  Effort effort;
  Stage stage;
};

}  // namespace nao::validation::test

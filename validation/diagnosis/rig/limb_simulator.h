#pragma once

#include <memory>
#include <vector>

#include "core/memo.h"
#include "validation/diagnosis/ensemble/joint_simulator.h"
#include "validation/diagnosis/rig/limb.h"

namespace nao::validation {

/// One joint of a set in its whole limb, as a World moves it: no load is assumed, neighbours rattle
/// in their play by chance as they do in the measurement. Ten times the cost of a rig, none of its
/// errors. Where neighbours were measured to do something else than their model, their orders are
/// altered until they do it, within the set's bandwidth.
class LimbSimulator final : public JointSimulator {
 public:
  /// `measured`: of the joint, what JointSimulator::measured() gives.
  LimbSimulator(std::shared_ptr<const Limb> limb, const std::vector<JointMotion>& measured);

  std::string joint() const override;
  const std::vector<JointMotion>& measured() const override { return measured_; }
  Eigen::MatrixXd run(const std::vector<EffectSetting>& causes, std::size_t motion,
                      std::uint64_t stream, const JointNoise& noise) const override;

 private:
  using Orders = std::vector<JointCommand>;
  Orders alteredOrders(std::size_t motion, const std::vector<EffectSetting>& effects) const;

  std::shared_ptr<const Limb> limb_;
  const std::vector<JointMotion>& measured_;
  std::vector<RobotModel> models_;              // by motion
  std::vector<Orders> orders_;                  // by motion, as they were given
  std::vector<std::vector<std::size_t>> seen_;  // by motion: neighbours that were measured
  mutable Memo<Orders> altered_;
};

}  // namespace nao::validation

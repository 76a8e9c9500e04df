#pragma once

#include <memory>
#include <string>
#include <vector>

#include "validation/diagnosis/ensemble/joint_simulator.h"
#include "validation/diagnosis/maths/grid.h"
#include "validation/diagnosis/rig/limb_loads.h"
#include "validation/diagnosis/rig/limb_simulator.h"

namespace nao::validation {

/// How joints are simulated alone.
struct RigOptions {
  double step = 2.5e-4;       // [s] at most, of a rig: a run of 6 s then costs 1.5 ms of processor
  double coarse_step = 5e-4;  // [s] at most, of JointSimulator::coarse()
  double rough_step = 1e-3;   // [s] at most, of JointSimulator::rough()
  /// [s] of the Worlds whose motions the rigs are compared with. Their implicit steps answer an
  /// order half a step late; a rig's orders come earlier by half of what its own step is longer.
  double world_step = 2.5e-4;
  double settle = 0.5;  // [s] of rest in the first pose before a run
  double bandwidth = kLoadBandwidth;
  const sim::EffectCatalogue* catalogue = nullptr;  // null: standardEffects()
};

/// The motions of a set of a robot with its base held, and what all its joints did in them: shared
/// by the simulators of its joints.
class RigSet {
 public:
  /// `model` is the nominal one; it is suspended here if the set says that the robot was.
  /// @throws InputError for a set that does not fit the model, or of a robot that stood on its
  /// feet.
  RigSet(const LogSet& set, std::shared_ptr<const RobotModel> model, RigOptions options = {});

  const RobotModel& model() const { return *model_; }
  const RigOptions& options() const { return options_; }
  const sim::EffectCatalogue& catalogue() const;
  const std::vector<GriddedMotion>& motions() const { return motions_; }
  /// Joints of the set that were commanded and measured in every run.
  const std::vector<Joint>& joints() const { return joints_; }
  /// Mean of the repeats of a motion, all joints; those not measured hold their start posture.
  const MeasuredMotion& measured(std::size_t motion) const { return measured_[motion]; }
  /// The effects of the model with `causes` on top, and the load that was tied on for this motion.
  std::vector<EffectSetting> effectsWith(const std::vector<EffectSetting>& causes,
                                         const GriddedMotion& motion) const;
  /// The time between rows, of whole rig steps, whole World steps and whole values of the loads.
  Duration row() const { return model_->cycle; }
  int perRow() const { return per_row_; }  // values of the loads
  Duration worldStep() const { return world_step_; }
  Duration rigStep() const { return rig_step_; }
  Duration coarseStep() const { return coarse_step_; }
  Duration roughStep() const { return rough_step_; }

 private:
  void choosePace(double dt);
  void findJoints();
  void layCounts(const LogSet& set);
  MeasuredMotion meanOf(const GriddedMotion& motion) const;

  std::shared_ptr<RobotModel> model_;  // its cycle is a row
  RigOptions options_;
  int per_row_ = 1;
  Duration world_step_{}, rig_step_{}, coarse_step_{}, rough_step_{};
  std::vector<GriddedMotion> motions_;
  std::vector<MeasuredMotion> measured_;
  std::vector<Joint> joints_;
};

/// One joint of a set on a rig: the joint level's simulator. Loads are calculated anew for every
/// list of causes.
class RigSimulator final : public JointSimulator {
 public:
  RigSimulator(std::shared_ptr<const RigSet> set, Joint joint);
  ~RigSimulator() override;

  std::string joint() const override;
  std::vector<Joint> place() const override { return {joint_}; }
  std::vector<Joint> carried() const override { return limb_->carried(); }
  double linkInertia() const override { return limb_->linkInertia(); }
  const std::vector<JointMotion>& measured() const override { return measured_; }
  Eigen::MatrixXd run(const std::vector<EffectSetting>& causes, std::size_t motion,
                      std::uint64_t stream, const JointNoise& noise) const override;
  LedRun led(const std::vector<EffectSetting>& causes, std::size_t motion,
             const Eigen::VectorXd& off, const Eigen::VectorXd& misread) const override;
  double present(const std::string& effect, const std::string& parameter) const override;
  bool isCoupled() const override;
  std::vector<std::vector<double>> touchedLines(bool upper) const override;
  std::pair<double, double> range() const override;
  const JointSimulator& coarse() const override { return coarse_ ? *coarse_ : *this; }
  const JointSimulator& rough() const override;
  const JointSimulator& exact() const override;

 private:
  enum class Loads {
    Quiet,       // of runs without noise
    Drawn,       // two draws: runs of even streams have the one, of odd streams the other
    OfMassOnly,  // drawn; causes alter it only if they are masses, along the motion without them
                 // unless they make the joint sag far, or play and the like
  };
  RigSimulator(const RigSimulator& fine, Duration step, Loads of);
  std::shared_ptr<const sim::JointLoad> loadOf(const std::vector<EffectSetting>& causes,
                                               std::size_t motion, std::uint64_t stream,
                                               const JointNoise& noise) const;
  void addRigs();
  JointMotion measuredOf(const GriddedMotion& motion) const;

  std::shared_ptr<const RigSet> set_;
  Joint joint_;
  Duration step_, world_step_;
  std::vector<JointMotion> measured_;
  std::vector<sim::JointRig> rigs_;       // by motion
  std::vector<sim::JointOrders> orders_;  // by motion
  std::shared_ptr<const Limb> limb_;
  std::unique_ptr<LimbLoads> loads_;
  std::unique_ptr<LimbSimulator> exact_;
  Loads loads_of_ = Loads::Quiet;
  std::unique_ptr<RigSimulator> coarse_, rough_;
};

}  // namespace nao::validation

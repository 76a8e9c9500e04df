#include "validation/diagnosis/replay/limb_replay.h"

#include <algorithm>

#include "core/random.h"
#include "sim/hinge_run.h"
#include "validation/diagnosis/replay/replay_start.h"
#include "validation/diagnosis/rig/limb.h"
#include "validation/suspended.h"

namespace nao::validation {
namespace {

// Of a swinging leg that was recorded by 0.25 ms: by such steps the same to the count, by 1 ms off
// by half a count RMS, at 40 % of the time.
constexpr Duration kStep = std::chrono::microseconds(250);
constexpr Duration kCoarseStep = std::chrono::milliseconds(1);
constexpr double kSettle = 0.5;  // [s] of rest before a run: only limbs swing
constexpr double kLatest = 0.4;  // [s] either way

// [SD] Of two streams in a row, from an odd one, one begins as late as the other does early: when
// the runs of a pool begin makes nothing of their mean.
double drawStart(std::uint64_t stream) {
  const double late = Random((stream + 1) / 2, "start of a run").normal();
  return stream % 2 == 1 ? late : -late;
}

void leaveOut(const char* effect, std::vector<EffectSetting>& from) {
  from.erase(std::remove_if(from.begin(), from.end(),
                            [&](const EffectSetting& one) { return one.name == effect; }),
             from.end());
}

}  // namespace

LimbReplay::LimbReplay(const WholeSimulator& whole, const std::vector<Joint>& joints, Pace pace)
    : whole_(whole), pace_(pace) {
  for (const Joint joint : joints) names_.push_back(whole.model().actuators[index(joint)].name);
  const RobotModel limbs = cutLimbs(whole.model(), names_);
  for (const Actuator& motor : limbs.actuators) {
    kept_.push_back(*whole.model().findJoint(motor.name));
  }
  for (const WholeRun& run : whole.measured()) orders_.push_back(ordersOf(run));
}

std::vector<JointCommand> LimbReplay::ordersOf(const WholeRun& measured) const {
  const JointCommand none{JointArray<double>(kept_.size()), JointArray<double>(kept_.size())};
  std::vector<JointCommand> orders(static_cast<std::size_t>(measured.rows()), none);
  for (Eigen::Index k = 0; k < measured.rows(); ++k) {
    JointCommand& order = orders[static_cast<std::size_t>(k)];
    for (std::size_t j = 0; j < kept_.size(); ++j) {
      const auto column = static_cast<Eigen::Index>(index(kept_[j]));
      order.angle[j] = measured.command(k, column);
      order.stiffness[j] = measured.stiffness(k, column);
    }
  }
  return orders;
}

WholeRun LimbReplay::simulate(const std::vector<EffectSetting>& causes, std::size_t run,
                              std::uint64_t stream, const NoiseParts& noise) const {
  const WholeRun& measured = whole_.measured()[run];
  const auto robot = whole_.robotOf(measured, causes, noise);
  Random random(stream, "start");
  const JointArray<double> start =
      startAngles(*robot, measured, whole_.catalogue(), stream != 0 ? &random : nullptr);
  RobotModel limbs = cutLimbs(stripped(*robot), names_);
  if (pace_ == Pace::Coarse) leaveOut("encoder_quantum", limbs.effects);
  const Duration step = pace_ == Pace::Coarse ? kCoarseStep : kStep;
  const double late = std::clamp(noise.start_sd * drawStart(stream), -kLatest, kLatest);
  sim::HingeRun how{kSettle, step, 1, stream, late, inertiaEvery(step)};
  how.start = JointArray<double>(kept_.size());
  for (std::size_t j = 0; j < kept_.size(); ++j) (*how.start)[j] = start[kept_[j]];
  const sim::HingeMotion motion =
      sim::runHinges(limbs, limbs.effects, orders_[run], how, whole_.catalogue());
  WholeRun played;
  played.dt = measured.dt;
  played.angle = Eigen::MatrixXd::Zero(measured.rows(), measured.angle.cols());
  for (std::size_t j = 0; j < kept_.size(); ++j) {
    played.angle.col(static_cast<Eigen::Index>(index(kept_[j]))) =
        motion.reported.col(static_cast<Eigen::Index>(j));
  }
  return played;
}

}  // namespace nao::validation

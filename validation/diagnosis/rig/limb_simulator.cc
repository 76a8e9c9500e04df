#include "validation/diagnosis/rig/limb_simulator.h"

#include <cmath>

#include "sim/hinge_run.h"
#include "validation/diagnosis/rig/rig_simulator.h"
#include "validation/diagnosis/rig/run_noise.h"
#include "validation/diagnosis/rig/smooth_motion.h"

namespace nao::validation {
namespace {

// Lists of effects, times motions, whose orders are remembered: of 6 s they take 300 kB.
constexpr std::size_t kRemembered = 16;
// A joint follows an altered order late, so that a part of what differs is left each time.
constexpr int kRounds = 2;

std::vector<std::size_t> measuredNeighbours(const Limb& limb, std::size_t motion) {
  const std::vector<bool> assumed = limb.measured(motion).assumed;
  std::vector<std::size_t> seen;
  for (std::size_t j = 0; j < limb.model().jointCount(); ++j) {
    if (toJoint(j) != limb.joint() && (assumed.empty() || !assumed[j])) seen.push_back(j);
  }
  return seen;
}

// [rad] RMS. A zero that is 0.1 degree off and a count are no reason to move a neighbour.
constexpr double kWorthAltering = 3e-3;

bool isWorth(const SmoothMotion& beside) {
  const Eigen::Map<const Eigen::VectorXd> angle(beside.angle.data(),
                                                static_cast<Eigen::Index>(beside.angle.size()));
  return angle.norm() > kWorthAltering * std::sqrt(static_cast<double>(angle.size()));
}

}  // namespace

LimbSimulator::LimbSimulator(std::shared_ptr<const Limb> limb,
                             const std::vector<JointMotion>& measured)
    : limb_(std::move(limb)), measured_(measured), altered_(kRemembered) {
  for (std::size_t m = 0; m < limb_->set().motions().size(); ++m) {
    models_.push_back(limb_->modelIn(m));
    orders_.push_back(limb_->orders(m));
    seen_.push_back(measuredNeighbours(*limb_, m));
  }
}

std::string LimbSimulator::joint() const {
  return limb_->model().actuators[index(limb_->joint())].name;
}

LimbSimulator::Orders LimbSimulator::alteredOrders(
    std::size_t motion, const std::vector<EffectSetting>& effects) const {
  const RigOptions& options = limb_->set().options();
  const MeasuredMotion measured = limb_->measured(motion);
  Orders orders = orders_[motion];
  for (int round = 0; round < kRounds; ++round) {
    const sim::HingeMotion played = sim::runHinges(
        models_[motion], effects, orders,
        {options.settle, limb_->set().worldStep(), 1, 1, 0, inertiaEvery(limb_->set().worldStep())},
        limb_->set().catalogue());
    for (const std::size_t j : seen_[motion]) {
      const auto column = static_cast<Eigen::Index>(j);
      const Eigen::VectorXd beside = measured.angle.col(column) - played.reported.col(column);
      const SmoothMotion smooth =
          smoothed({beside.data(), beside.data() + beside.size()}, measured.dt, options.bandwidth);
      if (!isWorth(smooth)) continue;
      for (std::size_t k = 0; k < orders.size(); ++k) orders[k].angle[j] += smooth.angle[k];
    }
  }
  return orders;
}

Eigen::MatrixXd LimbSimulator::run(const std::vector<EffectSetting>& causes, std::size_t motion,
                                   std::uint64_t stream, const JointNoise& noise) const {
  const RigSet& set = limb_->set();
  const std::vector<EffectSetting> own =
      limb_->effects(set.effectsWith(causes, set.motions()[motion]));
  std::shared_ptr<const Orders> altered;
  if (!seen_[motion].empty()) {
    altered = altered_.get(keyOf(motion, own), [&] { return alteredOrders(motion, own); });
  }
  // First in the list: their random numbers do not depend on the causes.
  std::vector<EffectSetting> effects = limb_->disturbances(noise);
  effects.insert(effects.end(), own.begin(), own.end());
  const RunDraw draw = drawOf(stream, motion);
  const double settle = set.options().settle;
  sim::HingeRun how{settle,
                    set.worldStep(),
                    1,
                    draw.seed,
                    drawLateness(noise, draw, 0.9 * settle),
                    inertiaEvery(set.worldStep())};
  how.pair = draw.pair;
  const sim::HingeMotion played = sim::runHinges(
      models_[motion], effects, altered ? *altered : orders_[motion], how, set.catalogue());
  const auto column = static_cast<Eigen::Index>(index(limb_->joint()));
  Eigen::MatrixXd signals(played.reported.rows(), measured_[motion].repeats.front().cols());
  signals.col(0) = played.reported.col(column);
  if (signals.cols() > 1) signals.col(1) = played.current.col(column);
  addEncoderNoise(noise, draw, signals);
  return signals;
}

}  // namespace nao::validation

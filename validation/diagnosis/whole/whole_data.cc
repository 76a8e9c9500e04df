#include "validation/diagnosis/whole/whole_data.h"

#include <algorithm>
#include <limits>
#include <sstream>

#include "core/check.h"
#include "validation/diagnosis/jobs/team.h"
#include "validation/diagnosis/rig/limb.h"

namespace nao::validation {
namespace {

// In coarse runs: of a robot on its feet, and of limbs that hang.
constexpr int kExactCost = 4, kExactLimbsCost = 3;
constexpr std::uint64_t kStepErrorStream = 4;

// Empty ones left out; empty if there is none.
Eigen::VectorXd meanOfThose(const std::vector<Eigen::VectorXd>& some) {
  Eigen::VectorXd sum;
  double count = 0;
  for (const Eigen::VectorXd& one : some) {
    if (one.size() == 0) continue;
    sum = count == 0 ? one : Eigen::VectorXd(sum + one);
    count += 1;
  }
  return sum / std::max(1.0, count);
}

bool areOf(Blocks blocks, Split split) {
  return blocks == Blocks::All || (blocks == Blocks::Fit) == (split == Split::Fit);
}

// What decides what is simulated, all digits of it.
template <class... Numbers>
std::string sentence(const char* what, Numbers... numbers) {
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << what;
  ((text << ' ' << numbers), ...);
  text << '\n';
  return text.str();
}

}  // namespace

WholeData::WholeData(const WholeSimulator& simulator, const std::vector<Joint>& joints, bool body)
    : simulator_(simulator),
      block_of_(simulator.measured().size()),
      measured_(simulator.measured().size()),
      joints_(joints.size()) {
  if (!body && simulator.model().fixed_base) {
    limbs_ = std::make_unique<LimbReplay>(simulator, joints, Pace::Exact);
    coarse_ = std::make_unique<LimbReplay>(simulator, joints, Pace::Coarse);
  }
  for (const WholeBlock& block : simulator.blocks()) {
    const FeatureSpace space(simulator, block, joints, body);
    offsets_.push_back(size_);
    for (const std::size_t run : block.runs) {
      block_of_[run] = spaces_.size();
      measured_[run] = space.of(simulator.measured()[run]);
    }
    size_ += space.size();
    if (block.split == Split::Fit) fit_size_ = size_;
    spaces_.push_back(space);
  }
}

Eigen::VectorXd WholeData::stackMeans(const std::vector<Eigen::VectorXd>& by_run) const {
  Eigen::VectorXd stacked = Eigen::VectorXd::Zero(size_);
  std::vector<double> count(spaces_.size(), 0);
  for (std::size_t run = 0; run < by_run.size(); ++run) {
    if (by_run[run].size() == 0) continue;
    const std::size_t block = block_of_[run];
    stacked.segment(offsets_[block], spaces_[block].size()) += by_run[run];
    count[block] += 1;
  }
  for (std::size_t block = 0; block < spaces_.size(); ++block) {
    if (count[block] > 0) {
      stacked.segment(offsets_[block], spaces_[block].size()) /= count[block];
    }
  }
  return stacked;
}

Halves WholeData::stackHalves(const WholePool& pool) const {
  WholePool even(pool.size()), odd(pool.size());
  for (std::size_t run = 0; run < pool.size(); ++run) {
    const std::size_t count = pool[run].size();
    for (std::size_t i = 0; i < count; ++i) {
      if (i % 2 == 0) even[run].push_back(pool[run][i]);
      if (i % 2 == 1 || count == 1) odd[run].push_back(pool[run][i]);
    }
  }
  return {stackMeans(meansOf(even)), stackMeans(meansOf(odd))};
}

std::vector<WholeData::Order> WholeData::ordersFor(int per_run, std::size_t most, Blocks blocks,
                                                   std::uint64_t streams) const {
  std::vector<Order> orders;
  for (const WholeBlock& block : simulator_.blocks()) {
    if (!areOf(blocks, block.split)) continue;
    for (std::size_t i = 0; i < std::min(most, block.runs.size()); ++i) {
      for (int s = 0; s < per_run; ++s) {
        const std::size_t run = block.runs[i];
        orders.push_back({run, (streams << 40) + (run << 16) + static_cast<std::size_t>(s) + 1});
      }
    }
  }
  return orders;
}

std::vector<EffectSetting> WholeData::withGiven(const std::vector<EffectSetting>& causes) const {
  std::vector<EffectSetting> acting = given_;
  acting.insert(acting.end(), causes.begin(), causes.end());
  return acting;
}

void WholeData::learnStepErrors(const std::vector<EffectSetting>& causes, int runs,
                                const NoiseParts& noise, int jobs) {
  if (limbs_) return;
  const std::vector<EffectSetting> acting = withGiven(causes);
  step_errors_ = {{}, 2.0 / runs, keyOf(acting)};
  for (std::size_t block = 0; block < spaces_.size(); ++block) {
    const auto mean = [&](Pace pace) {
      const std::string what = sentence("step error", block, static_cast<int>(pace), runs,
                                        noise.torque, noise.jitter, noise.start_sd);
      used_ += runs * (pace == Pace::Exact ? kExactCost : 1);
      const WholePool kept = kept_.remember(what + step_errors_.of, [&] {
        return WholePool{{meanOf(acting, block, pace, runs, noise, jobs)}};
      });
      return kept[0][0];
    };
    const Eigen::VectorXd exact = mean(Pace::Exact), coarse = mean(Pace::Coarse);
    const bool known = exact.size() > 0 && coarse.size() > 0;
    step_errors_.by_block.push_back(known ? Eigen::VectorXd(exact - coarse)
                                          : Eigen::VectorXd::Zero(spaces_[block].size()));
  }
}

// Of the runs that stand; nothing if none does.
Eigen::VectorXd WholeData::meanOf(const std::vector<EffectSetting>& acting, std::size_t block,
                                  Pace pace, int count, const NoiseParts& noise, int jobs) const {
  const std::vector<std::size_t>& runs = simulator_.blocks()[block].runs;
  std::vector<Eigen::VectorXd> features(static_cast<std::size_t>(count));
  inParallel(features.size(), jobs, [&](std::size_t i) {
    const std::size_t run = runs[i % runs.size()];
    const std::uint64_t stream = (kStepErrorStream << 40) + i + 1;
    const WholeRun played = simulator_.simulate(acting, run, stream, noise, pace);
    if (!played.fell) features[i] = spaces_[block].of(played);
  });
  return meanOfThose(features);
}

WholeRun WholeData::replay(const std::vector<EffectSetting>& causes, std::size_t run,
                           std::uint64_t stream, const NoiseParts& noise, Pace pace) const {
  if (!limbs_) return simulator_.simulate(causes, run, stream, noise, Pace::Coarse);
  const LimbReplay& limbs = pace == Pace::Coarse ? *coarse_ : *limbs_;
  return limbs.simulate(causes, run, stream, noise);
}

WholePool WholeData::simulate(const std::vector<EffectSetting>& causes, int per_run,
                              std::size_t most, Blocks blocks, std::uint64_t streams,
                              const NoiseParts& noise, int jobs, Pace pace) const {
  const std::vector<Order> orders = ordersFor(per_run, most, blocks, streams);
  const std::vector<EffectSetting> acting = withGiven(causes);
  const int cost = limbs_ && pace == Pace::Exact ? kExactLimbsCost : 1;
  used_ += cost * static_cast<long>(orders.size());
  const std::string what =
      sentence("runs", per_run, most, static_cast<int>(blocks), streams, noise.torque, noise.jitter,
               noise.start_sd, static_cast<int>(pace), step_errors_.by_block.size()) +
      step_errors_.of + '\n' + keyOf(acting);
  return kept_.remember(what, [&] { return run(acting, orders, noise, jobs, pace); });
}

// The features of all that stands; of a block of which most fell, of all.
WholePool WholeData::run(const std::vector<EffectSetting>& acting, const std::vector<Order>& orders,
                         const NoiseParts& noise, int jobs, Pace pace) const {
  std::vector<Eigen::VectorXd> features(orders.size());
  std::vector<char> fell(orders.size(), 0);
  inParallel(orders.size(), jobs, [&](std::size_t i) {
    const WholeRun run = replay(acting, orders[i].run, orders[i].stream, noise, pace);
    const std::size_t block = block_of_[orders[i].run];
    features[i] = spaces_[block].of(run);
    if (!step_errors_.by_block.empty()) features[i] += step_errors_.by_block[block];
    fell[i] = run.fell;
  });
  std::vector<int> total(spaces_.size(), 0), down(spaces_.size(), 0);
  for (std::size_t i = 0; i < orders.size(); ++i) {
    ++total[block_of_[orders[i].run]];
    down[block_of_[orders[i].run]] += fell[i];
  }
  WholePool pool(measured_.size());
  for (std::size_t i = 0; i < orders.size(); ++i) {
    const std::size_t block = block_of_[orders[i].run];
    const bool most_fell = 2 * down[block] > total[block];
    if (!fell[i] || most_fell) pool[orders[i].run].push_back(std::move(features[i]));
  }
  return pool;
}

std::vector<Eigen::VectorXd> meansOf(const WholePool& pool) {
  std::vector<Eigen::VectorXd> means(pool.size());
  for (std::size_t run = 0; run < pool.size(); ++run) {
    if (pool[run].empty()) continue;
    means[run] = Eigen::VectorXd::Zero(pool[run].front().size());
    for (const Eigen::VectorXd& one : pool[run]) means[run] += one;
    means[run] /= static_cast<double>(pool[run].size());
  }
  return means;
}

}  // namespace nao::validation

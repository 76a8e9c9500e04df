#include "tests/hidden/hidden_set.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/check.h"
#include "core/random.h"
#include "tests/hidden/laws/laws.h"
#include "tests/hidden/look_alikes.h"
#include "tests/hidden/mujoco/recording.h"
#include "tests/hidden/response.h"
#include "tests/hidden/scaling.h"
#include "validation/log/simulated_recording.h"
#include "validation/suspended.h"

namespace nao::hidden {
namespace {

using validation::LogSet;
using validation::RecordedMotion;
using validation::RecordingPlan;

constexpr int kSampleRuns = 4;    // so that an encoder's counts average out
constexpr double kAlike = 1.5;    // [SD of the measured mean] apart: no data tells such causes
constexpr double kPairApart = 3;  // the same of the two effects of a pair
constexpr double kImitated = 3;   // the same of strangers: they must leave something unknown

// The standard motions of these joints alone.
std::vector<RecordedMotion> motionsOf(const std::shared_ptr<const RobotModel>& model,
                                      const std::vector<std::string>& joints, double seconds) {
  std::vector<RecordedMotion> motions = validation::standardRecording(model);
  for (RecordedMotion& motion : motions) motion.duration = seconds;
  validation::moveOnly(joints, model, motions);
  return motions;
}

// The same for the limbs that hold the written joints alone: answers the same at less cost.
RecordingPlan limbOf(const RecordingPlan& plan) {
  RecordingPlan limb = plan;
  const auto cut = std::make_shared<RobotModel>(
      validation::cutLimbs(validation::stripped(*plan.model), plan.joints));
  cut->groups = plan.model->groups;
  limb.model = cut;
  for (RecordedMotion& motion : limb.motions) {
    motion.angles = [whole = plan.model, cut, all = motion.angles](double t) {
      const JointArray<double> angle = all(t);
      JointArray<double> kept(cut->jointCount());
      for (std::size_t j = 0; j < cut->jointCount(); ++j) {
        kept[j] = angle[*whole->findJoint(cut->actuators[j].name)];
      }
      return kept;
    };
  }
  return limb;
}

// Every sample asks for the same rows again.
void tabulate(RecordingPlan& plan) {
  const double row = toSeconds(plan.model->cycle);
  for (RecordedMotion& motion : plan.motions) {
    const auto rows = std::make_shared<std::vector<JointArray<double>>>();
    for (long k = 0; k <= std::lround(motion.duration / row); ++k) {
      rows->push_back(motion.angles(static_cast<double>(k) * row));
    }
    motion.angles = [rows, row](double t) {
      return rows->at(static_cast<std::size_t>(std::lround(t / row)));
    };
  }
}

// For sizes of effects: fit motions only, a few runs, at a coarser step.
RecordingPlan shortened(RecordingPlan plan) {
  plan.repeats = kSampleRuns;
  plan.step = std::chrono::milliseconds(1);
  const auto is_other = [](const RecordedMotion& m) { return m.split != validation::Split::Fit; };
  plan.motions.erase(std::remove_if(plan.motions.begin(), plan.motions.end(), is_other),
                     plan.motions.end());
  return plan;
}

class Maker {
 public:
  Maker(const HiddenCase& hidden, const std::shared_ptr<const RobotModel>& nominal)
      : hidden_(hidden) {
    auto robot = std::make_shared<RobotModel>(suspend(*nominal));
    Random random(hidden.seed, "noise");
    truth_.name = hidden.name();
    truth_.kind = hidden.kind;
    truth_.level = hidden.level;
    truth_.joints = hidden.joints;
    truth_.spoil = hidden.spoil;
    truth_.torque_sd = random.uniform(0.02, 0.045);
    truth_.torque_time = random.uniform(0.03, 0.08);
    truth_.start_sd = random.uniform(0.0005, 0.0015);
    plan_.name = truth_.name;
    plan_.effects = &hiddenEffects();
    // First, so that it is drawn alike whatever is hidden.
    robot->effects.insert(
        robot->effects.begin(),
        {"process_noise", {{"sd", truth_.torque_sd}, {"time", truth_.torque_time}}, {}, ""});
    if (!hidden.isExactNull()) addUndeclaredDifferences(*robot, hidden.seed);
    plan_.model = robot;
    plan_.start_sd = truth_.start_sd;
    plan_.joints = hidden.joints;
    plan_.motions = motionsOf(robot, hidden.joints, hidden.seconds);
    const bool limbs = hidden.limbs || hidden.isMujoco();
    if (limbs) plan_ = limbOf(plan_);
    limb_ = shortened(limbs ? plan_ : limbOf(plan_));
    tabulate(limb_);
  }

  const Truth& choose() {
    for (const Wish& wish : hidden_.wishes) hide(wish);
    return truth_;
  }

  HiddenSet make() {
    choose();
    if (!truth_.shortfall.empty()) return {{}, truth_};
    RecordingPlan plan = plan_;
    plan.repeats = hidden_.repeats;
    plan.seed = 2 + static_cast<std::uint64_t>(Random(hidden_.seed, "runs").uniform() * 1e15);
    HiddenSet made{record(plan), truth_};
    spoilData(made.set, hidden_.spoil);
    return made;
  }

 private:
  // Some runs of each fit motion with these effects on top, all samples by the same chance.
  LogSet sample(const std::vector<EffectSetting>& effects) const {
    RecordingPlan plan = limb_;
    plan.extra.insert(plan.extra.end(), effects.begin(), effects.end());
    return record(plan);
  }

  LogSet record(const RecordingPlan& plan) const {
    return hidden_.isMujoco() ? recordMujoco(plan) : validation::recordSimulated(plan);
  }

  // What the effect changes, in SDs of the measured mean, at the joint where that is most.
  double sizeOf(const EffectSetting& effect, const Hideout& hideout) {
    const LogSet with = sample({effect});
    double most = 0;
    for (const std::string& joint : hidden_.joints) {
      const bool its_own = hidden_.level == "joint" && !hideout.whole_robot;
      if (its_own && joint != hidden_.joints.front()) continue;
      const Repeats change = less(repeatsOf(with, joint), repeatsOf(without(), joint));
      most = std::max(most, rmsWhereActing(change) / meanSd(joint));
    }
    return most;
  }

  // [rad] of the measured mean.
  double meanSd(const std::string& joint) {
    return spreadOf(repeatsOf(without(), joint)) / std::sqrt(static_cast<double>(hidden_.repeats));
  }

  const LogSet& without() {
    if (without_.runs.empty()) without_ = sample({});
    return without_;
  }

  void hide(const Wish& wish) {
    const Hideout& hideout = wish.hideout;
    const std::string joint = placeOf(hideout);
    const double sign = hideout.start < 0 ? -1 : 1;
    const auto [deviation, size] = scaleTo(wish, [&](double one) {
      return sizeOf(settingAt(hideout, sign * one, *limb_.model, joint), hideout);
    });
    const EffectSetting setting = settingAt(hideout, sign * deviation, *plan_.model, joint);
    const EffectSetting in_limb = settingAt(hideout, sign * deviation, *limb_.model, joint);
    note(wish, setting, sign * deviation, size);
    if (truth_.shortfall.empty() && hidden_.level == "joint") compare(hideout, in_limb);
    plan_.extra.push_back(setting);
    limb_.extra.push_back(in_limb);
    without_ = {};
  }

  // Whether this is the other one of a pair.
  bool isOther(const std::string& cause, const Hideout& hideout) const {
    return std::any_of(hidden_.wishes.begin(), hidden_.wishes.end(), [&](const Wish& wish) {
      return wish.hideout.cause != hideout.cause && looksAlike(wish.hideout.cause, cause);
    });
  }

  std::string placeOf(const Hideout& hideout) const {
    return hideout.places.empty() ? hidden_.joints.front() : drawnPlace(hideout, hidden_.seed);
  }

  // Lists beforehand which entries of the catalogue look as what was just noted. Everything looks
  // like a weak effect: of those nothing is listed.
  void compare(const Hideout& hideout, const EffectSetting& effect) {
    if (hidden_.kind == Kind::WeakSingle) return;
    const bool stranger = hideout.cause.empty();
    const std::string& joint = hidden_.joints.front();
    const Disguise disguise{limb_, effect,        hideout.cause,
                            joint, meanSd(joint), hidden_.isMujoco() ? &recordMujoco : nullptr};
    HiddenTruth& hidden = truth_.hidden.back();
    const double below = stranger ? kImitated : hidden_.kind == Kind::Pair ? kPairApart : kAlike;
    const std::vector<LookAlike> nearest = findLookAlikes(disguise, below);
    NAO_CHECK(!nearest.empty());
    hidden.nearest = nearest.front().cause;
    hidden.nearest_apart = nearest.front().apart;
    for (const LookAlike& one : nearest) {
      if (one.apart < (stranger ? kImitated : kAlike)) hidden.look_alikes.push_back(one.cause);
      const bool other = isOther(one.cause, hideout);
      if (other && one.apart < kPairApart) truth_.shortfall += "both look alike here; ";
    }
    if (!stranger || hidden.look_alikes.empty()) return;
    truth_.imitated = true;
    truth_.shortfall += hideout.law + " is imitated here by " + hidden.look_alikes.front() + "; ";
  }

  void note(const Wish& wish, const EffectSetting& setting, double deviation, double size) {
    const Hideout& hideout = wish.hideout;
    HiddenTruth one;
    one.cause = hideout.cause;
    one.law = hideout.law;
    one.parameter = hideout.parameter;
    if (!hideout.whole_robot) one.joint = placeOf(hideout);
    one.value = setting.parameters.at(hideout.parameter);
    one.deviation = deviation;
    one.size = size;
    one.inverse = hideout.inverse;
    one.comparable = hideout.comparable;
    one.features = hideout.features;
    truth_.hidden.push_back(one);
    const bool small = size < 0.75 * wish.size;
    const bool large = hidden_.kind == Kind::WeakSingle && size > 1.5 * wish.size;
    if (small) truth_.shortfall += hideout.law + " cannot be made large enough here; ";
    if (large) truth_.shortfall += hideout.law + " is of no interest when it is that small; ";
  }

  const HiddenCase& hidden_;
  RecordingPlan plan_, limb_;
  Truth truth_;
  LogSet without_;  // a sample without the effect to be hidden next
};

}  // namespace

HiddenSet makeHiddenSet(const HiddenCase& hidden, std::shared_ptr<const RobotModel> model) {
  if (hidden.scene != Scene::HungUp) return makeFloorSet(hidden, model);
  return Maker(hidden, model).make();
}

HiddenSet makeHiddenSetSomewhere(const HiddenCase& hidden,
                                 const std::shared_ptr<const RobotModel>& model) {
  HiddenCase tried = hidden;
  HiddenSet made = makeHiddenSet(tried, model);
  for (std::size_t i = 0; i < hidden.other_places.size(); ++i) {
    if (made.truth.shortfall.empty()) break;
    tried.joints = {hidden.other_places[i]};
    if (i < hidden.spares.size()) tried.wishes.back() = hidden.spares[i];
    made = makeHiddenSet(tried, model);
  }
  return made;
}

Truth chooseHidden(const HiddenCase& hidden, std::shared_ptr<const RobotModel> model) {
  return Maker(hidden, model).choose();
}

}  // namespace nao::hidden

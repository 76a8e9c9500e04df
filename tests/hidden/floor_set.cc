#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "tests/hidden/hidden_set.h"
#include "tests/hidden/laws/laws.h"
#include "tests/hidden/response.h"
#include "tests/hidden/scaling.h"

namespace nao::hidden {
namespace {

using validation::FloorPlan;
using validation::LogRun;
using validation::LogSet;

constexpr int kSampleRuns = 4;        // so that an encoder's counts average out
constexpr double kTooLarge = 1e6;     // the size of what makes a robot fall
constexpr double kFallen = M_PI / 4;  // [rad] of the torso's tilt

bool fell(const LogSet& set) {
  return std::any_of(set.runs.begin(), set.runs.end(), [](const LogRun& run) {
    for (const char* tilt : {"imu.ang.x", "imu.ang.y"}) {
      for (const double angle : run.columns.at(tilt)) {
        if (std::abs(angle) > kFallen) return true;
      }
    }
    return false;
  });
}

std::vector<std::string> anglesOf(const LogSet& set) {
  std::vector<std::string> columns;
  for (const validation::LogJoint& joint : set.joints) columns.push_back("q." + joint.name);
  return columns;
}

class FloorMaker {
 public:
  FloorMaker(const HiddenCase& hidden, const std::shared_ptr<const RobotModel>& nominal)
      : hidden_(hidden), nominal_(nominal) {
    auto robot = std::make_shared<RobotModel>(*nominal);
    if (!hidden.isExactNull()) addUndeclaredDifferences(*robot, hidden.seed);
    addNoise(*robot);
    plan_ = planOf(hidden.scene, robot);
    plan_.effects = &hiddenEffects();
    truth_.name = hidden.name();
    truth_.kind = hidden.kind;
    truth_.level = hidden.level;
    truth_.scene = nameOf(hidden.scene);
  }

  HiddenSet make() {
    for (const Wish& wish : hidden_.wishes) hide(wish);
    if (!truth_.shortfall.empty()) return {{}, truth_};
    FloorPlan plan = plan_;
    plan.repeats = hidden_.repeats;
    plan.step = std::chrono::microseconds(250);
    plan.seed = 2 + static_cast<std::uint64_t>(Random(hidden_.seed, "runs").uniform() * 1e15);
    HiddenSet made{validation::recordOnFloor(plan), truth_};
    made.truth.fell = fell(made.set);
    made.set.name = truth_.name;
    if (plan.motions.size() == 1) splitByRun(made.set);
    return made;
  }

 private:
  // The kinds of the robot's own file, at a level and with a memory of the set's own. The floor is
  // one floor for all runs. They come first, so that they are drawn alike whatever is hidden.
  void addNoise(RobotModel& robot) {
    Random random(hidden_.seed, "noise");
    const double level = random.uniform(0.5, 1.3), memory = random.uniform(0.7, 1.5);
    std::vector<EffectSetting> noise;
    for (EffectSetting effect : nominal_->noise) {
      if (effect.name == "floor_friction") continue;
      if (effect.name == "process_noise") {
        effect.parameters["sd"] *= level;
        effect.parameters["time"] *= memory;
        truth_.torque_sd = std::max(truth_.torque_sd, effect.parameters["sd"]);
        truth_.torque_time = effect.parameters["time"];
      }
      noise.push_back(std::move(effect));
    }
    robot.effects.insert(robot.effects.begin(), noise.begin(), noise.end());
  }

  // Some runs with these effects on top, all samples by the same chance.
  LogSet sample(const std::vector<EffectSetting>& effects) const {
    FloorPlan plan = plan_;
    plan.repeats = kSampleRuns;
    plan.step = std::chrono::milliseconds(1);
    plan.extra.insert(plan.extra.end(), effects.begin(), effects.end());
    return validation::recordOnFloor(plan);
  }

  // What the effect changes, in SDs of the measured mean, in the column where that is most.
  double sizeOf(const EffectSetting& effect, const std::vector<std::string>& columns) {
    const LogSet with = sample({effect});
    if (fell(with)) return kTooLarge;
    double most = 0;
    for (const std::string& column : columns.empty() ? anglesOf(with) : columns) {
      const Repeats before = repeatsOfColumn(without(), column);
      const double sd = spreadOf(before) / std::sqrt(static_cast<double>(hidden_.repeats));
      const Repeats change = less(repeatsOfColumn(with, column), before);
      most = std::max(most, rmsWhereActing(change) / sd);
    }
    return most;
  }

  const LogSet& without() {
    if (without_.runs.empty()) without_ = sample({});
    return without_;
  }

  void hide(const Wish& wish) {
    const Hideout& hideout = wish.hideout;
    const std::string place = placeOf(hideout);
    const double sign = hideout.start < 0 ? -1 : 1;
    const auto settingOf = [&](double one) {
      return settingAt(hideout, sign * one, *plan_.model, place);
    };
    const bool as_it_is = hideout.start == hideout.most;  // its size is what it is
    Scaled scaled{std::abs(hideout.start), 0};
    if (as_it_is) scaled.size = wish.size;
    if (!as_it_is)
      scaled = scaleTo(wish, [&](double one) { return sizeOf(settingOf(one), hideout.columns); });
    note(wish, settingOf(scaled.deviation), sign * scaled.deviation, scaled.size);
    plan_.extra.push_back(settingOf(scaled.deviation));
    without_ = {};
  }

  std::string placeOf(const Hideout& hideout) const {
    if (!hidden_.joints.empty()) return hidden_.joints.front();
    return drawnPlace(hideout, hidden_.seed);
  }

  void note(const Wish& wish, const EffectSetting& setting, double deviation, double size) {
    const Hideout& hideout = wish.hideout;
    HiddenTruth one;
    one.cause = hideout.cause;
    one.law = hideout.law;
    one.parameter = hideout.parameter;
    one.joint = hideout.whole_robot ? "robot" : placeOf(hideout);
    one.value = setting.parameters.at(hideout.parameter);
    one.deviation = deviation;
    one.size = size;
    one.inverse = hideout.inverse;
    one.comparable = hideout.comparable;
    truth_.hidden.push_back(one);
    if (size >= kTooLarge) truth_.shortfall += hideout.law + " makes the robot fall; ";
    if (size < 0.75 * wish.size) truth_.shortfall += hideout.law + " cannot be made large here; ";
  }

  const HiddenCase& hidden_;
  const std::shared_ptr<const RobotModel> nominal_;
  FloorPlan plan_;
  Truth truth_;
  LogSet without_;  // a sample without the effect to be hidden next
};

}  // namespace

HiddenSet makeFloorSet(const HiddenCase& hidden, const std::shared_ptr<const RobotModel>& model) {
  return FloorMaker(hidden, model).make();
}

}  // namespace nao::hidden

#include "tests/hidden/scene.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "motion/timeline/motion_file.h"
#include "motion/trajectory.h"
#include "validation/motion_trial.h"

namespace nao::hidden {
namespace {

using validation::FloorMotion;
using validation::FloorPlan;
using validation::Split;

constexpr double kDegree = M_PI / 180;
constexpr Scene kScenes[] = {Scene::HungUp, Scene::Stand, Scene::Kick,  Scene::Balance,
                             Scene::Walk,   Scene::Turn,  Scene::Circle};

/// One roll command on the right ankle while that foot is in the air, as the experiments have it.
struct Roll {
  double begin, end;  // [s] in the motion
  double angle;       // [rad]
};

// The keys of RAnkleRoll within that time give way to the command.
motion::Timeline withRoll(motion::Timeline timeline, Joint joint, const Roll& roll) {
  constexpr double kSlow = 0.4;  // [s] so that it does not shake the robot
  for (motion::Curve& curve : timeline.curves) {
    if (curve.joint != joint) continue;
    const auto within = [&](const motion::Key& key) {
      return key.time >= roll.begin && key.time <= roll.end + kSlow;
    };
    std::vector<motion::Key>& keys = curve.keys;
    keys.erase(std::remove_if(keys.begin(), keys.end(), within), keys.end());
    for (const double time : {roll.begin + kSlow, roll.end}) {
      motion::Key key;
      key.time = time;
      key.angle = roll.angle;
      keys.push_back(key);
    }
    std::sort(keys.begin(), keys.end(),
              [](const motion::Key& a, const motion::Key& b) { return a.time < b.time; });
    motion::setAutoHandles(0, keys);
  }
  return timeline;
}

FloorMotion add(FloorPlan& plan, const char* name, double seconds, motion::MotionAction action) {
  plan.motions.push_back({name, Split::Fit, seconds, {}});
  plan.actions[name] = std::move(action);
  return plan.motions.back();
}

void addFile(FloorPlan& plan, const char* name, const std::string& file, const Roll& roll) {
  constexpr double kRest = 0.5;  // [s] watched after its end
  const auto joint = plan.model->findJoint("RAnkleRoll");
  NAO_CHECK(joint.has_value());
  const motion::Timeline timeline =
      withRoll(motion::loadMotion(NAO_SOURCE_DIR "/motions/" + file, *plan.model), *joint, roll);
  add(plan, name, timeline.length + kRest, validation::playing(timeline));
}

}  // namespace

const char* nameOf(Scene scene) {
  switch (scene) {
    case Scene::HungUp:
      return "hung_up";
    case Scene::Stand:
      return "stand";
    case Scene::Kick:
      return "kick";
    case Scene::Balance:
      return "balance";
    case Scene::Walk:
      return "walk";
    case Scene::Turn:
      return "turn";
    case Scene::Circle:
      return "circle";
  }
  return "";
}

Scene sceneOf(const std::string& name) {
  std::string known;
  for (const Scene scene : kScenes) {
    if (name == nameOf(scene)) return scene;
    known += std::string(known.empty() ? "" : ", ") + nameOf(scene);
  }
  throw InputError("--scene: expected one of " + known + ", found '" + name + "'");
}

FloorPlan planOf(Scene scene, std::shared_ptr<const RobotModel> model) {
  FloorPlan plan;
  plan.model = std::move(model);
  if (scene == Scene::Stand) {
    plan.motions = {{"squat", Split::Fit, 4, {}},
                    {"sway", Split::Fit, 4, {}},
                    {"squat_fast", Split::Select, 4, {}},
                    {"mixed", Split::Test, 4, {}}};
  }
  if (scene == Scene::Kick) addFile(plan, "kick", "kick_right.xar", {2.6, 3.7, 10 * kDegree});
  if (scene == Scene::Balance) addFile(plan, "balance", "balance.xar", {14.1, 15.3, 45 * kDegree});
  if (scene == Scene::Walk) add(plan, "walk", 5, motion::MoveToward{1, 0, 0, {}});
  if (scene == Scene::Turn) add(plan, "turn", 5, motion::MoveToward{0, 0, 1, {}});
  if (scene == Scene::Circle) {
    constexpr double kSpeed = 0.08, kRadius = 0.6;  // [m/s], [m] as experiment circle has it
    add(plan, "circle", 9, motion::Move{{kSpeed, 0, kSpeed / kRadius}, {}});
  }
  return plan;
}

void splitByRun(validation::LogSet& set) {
  const std::size_t fifth = set.runs.size() / 5, fit = set.runs.size() - 2 * fifth;
  for (std::size_t i = fit; i < set.runs.size(); ++i) {
    set.runs[i].split = i < fit + fifth ? Split::Select : Split::Test;
  }
}

}  // namespace nao::hidden

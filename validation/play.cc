#include "validation/play.h"

#include <cmath>

#include "core/check.h"
#include "runtime/simulation.h"
#include "validation/play_faults.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""ms;

constexpr Duration kSettling = 1000ms;  // free choice: a Nao put down stands still after 0.5 s
constexpr double kPush = 45;            // [N] nearly a Nao's weight: no Nao stays on its feet
constexpr Duration kPushing = 400ms;    // with that
constexpr Duration kFalling = 2500ms;   // to the ground and at rest
constexpr double kLyingDown = 1.5;      // [s] into the pose, on the ground
constexpr const char* kFirst = "first";
constexpr const char* kUsual = "StandInit";

const Posture& postureOf(const RobotModel& model, const std::string& name) {
  if (const Posture* posture = model.findPosture(name)) return *posture;
  std::string known;
  for (const Posture& posture : model.postures) known += " " + posture.name;
  throw InputError("--from: robot " + model.name + " has no posture '" + name +
                   "'; expected first or one of" + known);
}

const Posture& usualPosture(const RobotModel& model) {
  const Posture* usual = model.findPosture(kUsual);
  return usual ? *usual : postureOf(model, model.start_posture);
}

Posture startOf(const motion::Timeline& timeline, const PlaySettings& settings) {
  const RobotModel& model = *settings.model;
  const bool first = settings.from == kFirst;
  if (!first && !settings.from.empty()) return postureOf(model, settings.from);
  Posture start = usualPosture(model);
  if (!first) return start;
  for (const motion::Curve& curve : timeline.curves) {
    if (!curve.keys.empty()) start.angle[curve.joint] = curve.keys.front().angle;
  }
  return start;
}

class Stage {
 public:
  Stage(const motion::Timeline& timeline, const PlaySettings& settings, const PlayWatch& watch)
      : model_(*settings.model),
        timeline_(timeline),
        watch_(watch),
        simulation_(settings.world, {{"nao", settings.model, {}}}, optionsOf(settings)),
        faults_(model_) {
    for (auto* track : {&played_.tracks.asked, &played_.tracks.sensed, &played_.tracks.torque}) {
      track->resize(model_.jointCount());
    }
  }

  Played run(const Posture& start, double hold) {
    const bool lies = start.family == "LyingBack" || start.family == "LyingBelly";
    unguard();
    put(lies ? standingFor(start) : start);
    if (lies) layDown(start);
    simulation_.advanceTo(simulation_.now() + kSettling);
    begin_ = simulation_.now();
    begin();
    const double longest = timeline_.length + 1.0;  // [s] the engine needs one cycle more
    while (!played_.done && time() < longest && simulation_.world().healthy()) step();
    const double end = std::max(time(), timeline_.length) + hold;
    while (time() < end && simulation_.world().healthy()) step();
    return finish(start.angle);
  }

 private:
  static sim::WorldOptions optionsOf(const PlaySettings& settings) {
    sim::WorldOptions options(settings.step);
    options.mode = settings.mode;
    options.seed = settings.seed;
    return options;
  }

  double time() const { return toSeconds(simulation_.now()) - toSeconds(begin_); }
  motion::RobotPorts& ports() { return *simulation_.robot(0).ports(); }

  motion::RequestId ask(motion::MotionAction action) {
    NAO_CHECK(ports().requests.post({++last_id_, std::move(action)}));
    return last_id_;
  }

  // On its soles, stiff.
  void put(const Posture& posture) {
    simulation_.world().placeRobot(0, simulation_.world().robot(0).start, &posture.angle);
    stiffen();
  }

  // The legs as usual, the rest as it will lie: arms under a body have no room to move.
  Posture standingFor(const Posture& posture) const {
    Posture standing = usualPosture(model_);
    for (const char* group : {"Head", "LArm", "RArm"}) {
      const auto joints = model_.groups.find(group);
      if (joints == model_.groups.end()) continue;
      for (const std::string& name : joints->second) {
        if (const auto j = model_.findJoint(name)) standing.angle[*j] = posture.angle[*j];
      }
    }
    return standing;
  }

  // Nobody can put a robot down on its back: it is pushed over, and takes its pose where it lies.
  void layDown(const Posture& posture) {
    simulation_.advanceTo(simulation_.now() + kSettling);
    const double heading = simulation_.world().robot(0).start.theta;
    const double push = posture.family == "LyingBack" ? -kPush : kPush;
    simulation_.world().push(0, {push * std::cos(heading), push * std::sin(heading), 0}, kPushing);
    simulation_.advanceTo(simulation_.now() + kPushing + kFalling);
    motion::Interpolate request;
    request.smooth = true;
    for (std::size_t j = 0; j < model_.jointCount(); ++j) {
      motion::Key key;
      key.time = kLyingDown;
      key.angle = posture.angle[j];
      request.curves.push_back({toJoint(j), {key}});
    }
    ask(request);
    simulation_.advanceTo(simulation_.now() + fromSeconds(kLyingDown));
  }

  // Nothing holds a motion back, so that what it does to the robot is seen.
  void unguard() {
    ask(motion::SetCollisionProtection{false, false});
    ask(motion::SetFallManager{false});
  }

  // One cycle limp, in which the commands take over where the joints are; then stiff.
  void stiffen() {
    simulation_.advanceTo(simulation_.now() + model_.cycle);
    motion::SetStiffness all;
    for (std::size_t j = 0; j < model_.jointCount(); ++j) {
      all.joints.push_back(toJoint(j));
      all.stiffness.push_back(1);
    }
    ask(all);
  }

  void begin() {
    motion::Interpolate request;
    request.curves = timeline_.curves;
    request.smooth = false;
    motion_ = ask(std::move(request));
  }

  void step() {
    const bool cycle = simulation_.now().time_since_epoch() % model_.cycle == Duration::zero();
    simulation_.advanceTo(simulation_.now() + simulation_.stepSize());
    faults_.look(simulation_.world(), time());
    if (watch_) watch_(simulation_.world(), time());
    if (!cycle) return;
    note();
    for (const motion::MotionOutcome& outcome : ports().outcomes.drain()) {
      if (outcome.id != motion_) continue;
      played_.done = outcome.kind == motion::MotionOutcome::Kind::Done;
      played_.duration = toSeconds(ports().state.get()->time + model_.cycle) - toSeconds(begin_);
    }
  }

  // What the cycle that has just begun was told and felt.
  void note() {
    const JointCommand command = ports().state.get()->command;
    const SensorFrame sensors = *ports().sensors.get();
    const JointArray<double> torque = simulation_.world().motors(0).torque;
    PlayTracks& tracks = played_.tracks;
    tracks.time.push_back(toSeconds(sensors.time) - toSeconds(begin_));
    for (std::size_t j = 0; j < model_.jointCount(); ++j) {
      tracks.asked[j].push_back(command.angle[j]);
      tracks.sensed[j].push_back(sensors.angle[j]);
      tracks.torque[j].push_back(torque[j]);
    }
    tracks.tilt.push_back(faults_.tilt());
    tracks.height.push_back(simulation_.world().scene().robots[0].X_WB[0].translation().z());
  }

  Played finish(const JointArray<double>& start) {
    played_.faults = lint(timeline_, model_, start);
    for (motion::MotionFault& fault : faults_.take()) played_.faults.push_back(std::move(fault));
    describeFaults(timeline_, model_, played_.faults);
    played_.fell = faults_.fell();
    played_.upright = faults_.upright();
    played_.draw = simulation_.world().draw();
    played_.hash = simulation_.hash();
    return std::move(played_);
  }

  const RobotModel& model_;
  const motion::Timeline& timeline_;
  const PlayWatch& watch_;
  runtime::Simulation simulation_;
  PlayFaults faults_;
  Played played_;
  SimTime begin_{};
  motion::RequestId last_id_ = 0;
  motion::RequestId motion_ = 0;
};

}  // namespace

Played play(const motion::Timeline& timeline, const PlaySettings& settings,
            const PlayWatch& watch) {
  const Posture start = startOf(timeline, settings);
  return Stage(timeline, settings, watch).run(start, settings.hold);
}

}  // namespace nao::validation

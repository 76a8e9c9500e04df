#include "validation/motion_trial.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "runtime/ground_truth.h"
#include "runtime/simulation.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""ms;

constexpr double kDegree = M_PI / 180;
constexpr Duration kWakingUp = 4000ms;  // from Crouch to StandInit
// A Nao that stands, kicks or bows has its torso above 0.25 m and less than 20 degrees oblique; one
// that has lost its balance passes both of these.
constexpr double kFallenHeight = 0.2;         // [m]
constexpr double kFallenTilt = 45 * kDegree;  // [rad]

class MotionRun {
 public:
  MotionRun(const ExperimentSettings& settings, const std::shared_ptr<const RobotModel>& model,
            std::uint64_t seed)
      : simulation_(loadWorld(settings), {{"nao", model, {}}}, optionsOf(settings, seed)),
        model_(*model) {}

  MotionRecord run(const motion::MotionAction& action, double seconds) {
    ask(motion::WakeUp{});
    simulation_.advanceTo(SimTime(kWakingUp));
    record_.start = place();
    const std::vector<Vec3> soles = calcSoles();
    ask(action);
    const SimTime end = SimTime(kWakingUp) + fromSeconds(seconds);
    while (simulation_.now() < end && !record_.fell && simulation_.world().healthy()) {
      simulation_.advanceTo(simulation_.now() + model_.cycle);
      look();
    }
    record_.fell = record_.fell || !simulation_.world().healthy();
    record_.end = place();
    const Vec3 forward(std::cos(record_.start.theta), std::sin(record_.start.theta), 0);
    for (std::size_t i = 0; i < soles.size(); ++i) {
      record_.foot_moved.push_back(forward.dot(calcSoles()[i] - soles[i]));
    }
    record_.hash = simulation_.hash();
    record_.draw = simulation_.world().draw();
    return std::move(record_);
  }

 private:
  static sim::WorldOptions optionsOf(const ExperimentSettings& settings, std::uint64_t seed) {
    sim::WorldOptions options(settings.step);
    options.seed = seed;
    return options;
  }

  void ask(const motion::MotionAction& action) {
    NAO_CHECK(simulation_.robot(0).ports()->requests.post({++last_id_, action}));
  }

  Pose2 place() {
    return runtime::calcFloorPose(model_, simulation_.world().scene().robots[0].X_WB);
  }

  std::vector<Vec3> calcSoles() {
    std::vector<Vec3> p_WS;
    const SceneFrame::Robot robot = simulation_.world().scene().robots[0];
    for (const FootModel& foot : model_.feet) {
      p_WS.push_back(robot.X_WB[static_cast<std::size_t>(foot.body)] * foot.X_BS.translation());
    }
    return p_WS;
  }

  void look() {
    const SceneFrame::Robot robot = simulation_.world().scene().robots[0];
    const Pose& X_WT = robot.X_WB[0];
    const double tilt = std::acos(std::clamp(X_WT.linear()(2, 2), -1.0, 1.0));
    record_.max_tilt = std::max(record_.max_tilt, tilt);
    record_.fell = X_WT.translation().z() < kFallenHeight || tilt > kFallenTilt;
    const motion::RobotPorts& ports = *simulation_.robot(0).ports();
    record_.t.push_back(toSeconds(simulation_.now() - SimTime(kWakingUp)));
    record_.command.push_back(ports.state.get()->command.angle);
    record_.sensor.push_back(ports.sensors.get()->angle);
    JointArray<double> hinges(model_.jointCount());
    for (std::size_t j = 0; j < model_.jointCount(); ++j) {
      hinges[j] = calcHingeAngle(robot, static_cast<Joint>(j));
    }
    record_.hinge.push_back(hinges);
  }

  runtime::Simulation simulation_;
  const RobotModel& model_;
  motion::RequestId last_id_ = 0;
  MotionRecord record_;
};

}  // namespace

std::shared_ptr<const RobotModel> withSpread(const RobotModel& model, const Spread& spread) {
  auto spread_out = std::make_shared<RobotModel>(model);
  std::vector<EffectSetting>& variation = spread_out->variation;
  if (variation.empty()) return spread_out;  // an ideal robot is the same in every run
  const auto is_friction = [](const EffectSetting& e) { return e.name == "floor_friction"; };
  variation.erase(std::remove_if(variation.begin(), variation.end(), is_friction), variation.end());
  variation.push_back({"floor_friction",
                       {{"low", spread.lowest_friction}, {"high", spread.highest_friction}},
                       {},
                       "spread"});
  variation.push_back({"mass_spread", {{"part", spread.mass}}, {}, "spread"});
  return spread_out;
}

double calcHingeAngle(const SceneFrame::Robot& robot, Joint joint) {
  const std::vector<int>& hinges = robot.model->actuators[index(joint)].coordinates;
  if (hinges.empty()) return 0;
  const std::size_t b = static_cast<std::size_t>(hinges.front()) + 1;
  const Body& body = robot.model->bodies[b];
  const Mat3 R_PB = robot.X_WB[static_cast<std::size_t>(body.parent)].linear().transpose() *
                    robot.X_WB[b].linear();
  const Mat3 R = body.X_PB.linear().transpose() * R_PB;
  const Vec3 turn(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
  return std::atan2(turn.dot(body.axis), R.trace() - 1);
}

MotionRecord runMotion(const ExperimentSettings& settings,
                       const std::shared_ptr<const RobotModel>& model, std::uint64_t seed,
                       const motion::MotionAction& action, double seconds) {
  return MotionRun(settings, model, seed).run(action, seconds);
}

motion::MotionAction playing(const motion::Timeline& timeline) {
  motion::Interpolate request;
  request.curves = timeline.curves;
  request.smooth = false;
  return request;
}

void Tracking::add(const MotionRecord& record) {
  if (record.fell) return;
  if (runs_ == 0) moments_.resize(record.t.size() * joints_);
  NAO_CHECK(moments_.size() == record.t.size() * joints_);
  ++runs_;
  for (std::size_t k = 0; k < record.t.size(); ++k) {
    for (std::size_t j = 0; j < joints_; ++j) {
      Moment& moment = moments_[k * joints_ + j];
      const double angle = record.sensor[k][j];
      const double off = angle - moment.mean;
      moment.mean += off / static_cast<double>(runs_);
      moment.scatter += off * (angle - moment.mean);
      moment.lag += std::pow(angle - record.command[k][j], 2);
    }
  }
}

std::vector<double> Tracking::calcRoot(double Moment::*sum, double runs) const {
  std::vector<double> root(joints_);
  if (moments_.empty() || runs <= 0) return root;
  const double n = runs * static_cast<double>(moments_.size() / joints_);
  for (std::size_t i = 0; i < moments_.size(); ++i) root[i % joints_] += moments_[i].*sum / n;
  for (double& value : root) value = std::sqrt(value) / kDegree;
  return root;
}

std::vector<double> Tracking::calcRms() const {
  return calcRoot(&Moment::lag, static_cast<double>(runs_));
}

std::vector<double> Tracking::calcSd() const {
  return calcRoot(&Moment::scatter, static_cast<double>(runs_) - 1);
}

}  // namespace nao::validation

#include "sim/hinge_run.h"

#include <cmath>

#include "core/check.h"
#include "core/world_model.h"
#include "sim/motor_heat.h"
#include "sim/robot_body.h"

namespace nao::sim {
namespace {

class Player {
 public:
  Player(const RobotModel& model, const std::vector<EffectSetting>& effects, const HingeRun& run,
         const EffectCatalogue& catalogue)
      : model_(model),
        step_(run.step),
        effects_(catalogue, effects, model, run.step, run.seed, model.name, run.pair),
        body_(planOf()),
        heat_(model) {
    frame_.angle = JointArray<double>(model.jointCount());
    if (run.inertia_every > 1) body_.setInertiaEvery(run.inertia_every);
  }

  void place(const JointArray<double>& angle) { body_.place({}, angle); }

  void step(const JointCommand& order) {
    followed_ = order;
    effects_.alterCommand(followed_, now_, toSeconds(step_));
    body_.step(followed_, termsFor(followed_), {}, toSeconds(step_));
    now_ += step_;
  }

  const TreeState& state() const { return body_.tree(); }

  const SensorFrame& report() {
    frame_.time = now_;
    for (std::size_t j = 0; j < model_.jointCount(); ++j) frame_.angle[j] = body_.angle(toJoint(j));
    heat_.sample(body_.drive().torque(), toSeconds(model_.cycle), frame_);
    effects_.alterSensors(frame_, model_.cycle);
    return frame_;
  }

 private:
  BodyPlan planOf() {
    BodyPlan plan(model_, WorldModel());
    effects_.alterPlan(plan);
    return plan;
  }

  const DriveTerms* termsFor(const JointCommand& followed) {
    if (!effects_.actsOnDrive()) return nullptr;
    const Drive& drive = body_.drive();
    effects_.alterDrive({now_, toSeconds(step_), drive.angle(), drive.rate(), followed.angle,
                         followed.stiffness, drive.torque(), drive.load()},
                        terms_);
    return &terms_;
  }

  const RobotModel& model_;
  Duration step_;
  EffectChain effects_;
  RobotBody body_;
  MotorHeat heat_;
  JointCommand followed_;
  DriveTerms terms_;
  SensorFrame frame_;
  SimTime now_{};
};

Eigen::RowVectorXd rowOf(const JointArray<double>& values) {
  return Eigen::Map<const Eigen::RowVectorXd>(values.begin(),
                                              static_cast<Eigen::Index>(values.size()));
}

HingeMotion roomFor(const RobotModel& model, std::size_t orders, int per_cycle) {
  const auto rows = static_cast<Eigen::Index>(orders), kept = (rows - 1) * per_cycle + 1;
  const auto hinges = static_cast<Eigen::Index>(model.coordinates.size());
  const auto joints = static_cast<Eigen::Index>(model.jointCount());
  return {toSeconds(model.cycle) / per_cycle, Eigen::MatrixXd(kept, hinges),
          Eigen::MatrixXd(kept, hinges), Eigen::MatrixXd(rows, joints),
          Eigen::MatrixXd(rows, joints)};
}

}  // namespace

HingeMotion runHinges(const RobotModel& model, const std::vector<EffectSetting>& effects,
                      const std::vector<JointCommand>& orders, const HingeRun& run,
                      const EffectCatalogue& catalogue) {
  if (!model.fixed_base) throw InputError(model.name + ": expected a robot with a fixed base");
  NAO_CHECK(!orders.empty() && run.per_cycle > 0 &&
            model.cycle % (run.per_cycle * run.step) == Duration(0));
  const long row_steps = model.cycle / run.step, kept_steps = row_steps / run.per_cycle;
  const long late = std::lround(run.late / toSeconds(run.step));
  const auto rows = static_cast<long>(orders.size());
  const long rest = std::lround(run.settle / toSeconds(model.cycle));
  HingeMotion motion = roomFor(model, orders.size(), run.per_cycle);
  Player player(model, effects, run, catalogue);
  player.place(run.start ? *run.start : orders.front().angle);
  long row = 0;  // whose orders act
  for (long step = -rest * row_steps; step <= (rows - 1) * row_steps; ++step) {
    if (step % row_steps == 0) {
      const SensorFrame& frame = player.report();
      if (step >= 0) motion.reported.row(step / row_steps) = rowOf(frame.angle);
      if (step >= 0) motion.current.row(step / row_steps) = rowOf(frame.current);
    }
    if (step >= 0 && step % kept_steps == 0) {
      motion.q.row(step / kept_steps) = player.state().q;
      motion.u.row(step / kept_steps) = player.state().u;
    }
    while (row + 1 < rows && (row + 1) * row_steps + late <= step) ++row;
    player.step(orders[static_cast<std::size_t>(row)]);
  }
  return motion;
}

}  // namespace nao::sim

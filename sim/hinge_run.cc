#include "sim/hinge_run.h"

#include <cmath>

#include "core/check.h"
#include "core/world_model.h"
#include "sim/robot_body.h"

namespace nao::sim {
namespace {

class Player {
 public:
  Player(const RobotModel& model, const std::vector<EffectSetting>& effects, Duration step,
         std::uint64_t seed, const EffectCatalogue& catalogue)
      : model_(model),
        step_(step),
        effects_(catalogue, effects, model, step, seed, model.name),
        body_(planOf()) {
    frame_.angle = frame_.current = JointArray<double>(model.jointCount());
  }

  void place(const JointCommand& order) { body_.place({}, order.angle); }

  void play(const JointCommand& order, long steps) {
    for (; steps > 0; --steps) {
      JointCommand followed = order;
      effects_.alterCommand(followed, now_, toSeconds(step_));
      body_.step(followed, termsFor(followed), {}, toSeconds(step_));
      now_ += step_;
    }
  }

  const TreeState& state() const { return body_.tree(); }

  Eigen::RowVectorXd report() {
    for (std::size_t j = 0; j < model_.jointCount(); ++j) frame_.angle[j] = body_.angle(toJoint(j));
    effects_.alterSensors(frame_, model_.cycle);
    return Eigen::Map<const Eigen::RowVectorXd>(frame_.angle.begin(),
                                                static_cast<Eigen::Index>(model_.jointCount()));
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
  DriveTerms terms_;
  SensorFrame frame_;
  SimTime now_{};
};

}  // namespace

HingeMotion runHinges(const RobotModel& model, const std::vector<EffectSetting>& effects,
                      const std::vector<JointCommand>& orders, double settle, Duration step,
                      int per_cycle, std::uint64_t seed, const EffectCatalogue& catalogue) {
  if (!model.fixed_base) throw InputError(model.name + ": expected a robot with a fixed base");
  NAO_CHECK(!orders.empty() && per_cycle > 0 && model.cycle % (per_cycle * step) == Duration(0));
  const long steps = model.cycle / per_cycle / step;
  const auto kept = static_cast<Eigen::Index>(orders.size() - 1) * per_cycle + 1;
  const auto hinges = static_cast<Eigen::Index>(model.coordinates.size());
  HingeMotion motion{toSeconds(model.cycle) / per_cycle, Eigen::MatrixXd(kept, hinges),
                     Eigen::MatrixXd(kept, hinges),
                     Eigen::MatrixXd(static_cast<Eigen::Index>(orders.size()),
                                     static_cast<Eigen::Index>(model.jointCount()))};
  Player player(model, effects, step, seed, catalogue);
  player.place(orders.front());
  for (long row = std::lround(settle / toSeconds(model.cycle)); row > 0; --row) {
    player.report();
    player.play(orders.front(), steps * per_cycle);
  }
  for (Eigen::Index i = 0; i < kept; ++i) {
    const Eigen::Index row = i / per_cycle;
    if (i % per_cycle == 0) motion.reported.row(row) = player.report();
    motion.q.row(i) = player.state().q;
    motion.u.row(i) = player.state().u;
    player.play(orders[static_cast<std::size_t>(row)], steps);
  }
  return motion;
}

}  // namespace nao::sim

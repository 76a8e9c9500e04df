#include "motion/whole_body.h"

#include <algorithm>
#include <cmath>

namespace nao::motion {
namespace {

constexpr std::array<const char*, 3> kLed = {"Head", "LArm", "RArm"};

constexpr double kMargin = 0.015;  // [m] free: what servos give way under load at the hip
constexpr double kAsked = 1e-2;    // [m^2/rad^2] weight of a joint that was asked to move
constexpr double kUnasked = 1e-4;  // of one that was not: it may help
constexpr double kKept = 0.1;      // weight of an effector that keeps its place, below a task's 1
constexpr double kLedFraction = 0.4;  // free: of top speed, for a target that jumps

std::size_t chainOf(const std::string& name) {
  const auto found = std::find(kLed.begin(), kLed.end(), name);
  NAO_CHECK(found != kLed.end());
  return static_cast<std::size_t>(found - kLed.begin());
}

Pose relative(const Kinematics& body, const Effector& base, const Effector& place) {
  return body.calcPose(base).inverse() * body.calcPose(place);
}

Effector soleOf(const RobotModel& model, std::size_t foot) {
  return {model.feet[foot].body, model.feet[foot].X_BS};
}

bool includes(Feet feet, std::size_t foot) {
  return feet == Feet::Both || (feet == Feet::Left) == (foot == 0);
}

}  // namespace

WholeBody::WholeBody(std::shared_ptr<const RobotModel> model)
    : model_(std::move(model)), solver_(model_), wish_(model_->jointCount()) {
  for (std::size_t i = 0; i < 2 && model_->feet.size() == 2; ++i) soles_[i] = soleOf(*model_, i);
}

// The feet stand as they are commanded now.
void WholeBody::stand(const JointArray<double>& angle) {
  solver_.body().update(angle);
  X_LR_ = relative(solver_.body(), soles_[0], soles_[1]);
}

void WholeBody::take(const WbEnable& request, const JointArray<double>& angle) {
  if (request.on && !on_) {
    wish_ = angle;
    stand(angle);
  }
  on_ = request.on;
  by_effector_ = false;
  if (on_) return;
  states_ = {FootState::Free, FootState::Free};
  balance_ = false;
  effectors_ = {};
}

void WholeBody::take(const WbFootState& request, const JointArray<double>& angle) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (includes(request.feet, i)) states_[i] = request.state;
  }
  stand(angle);
}

void WholeBody::take(const WbBalance& request, const JointArray<double>& /*angle*/) {
  balance_ = request.on;
  support_ = request.feet;
}

// Control of an effector brings its own stand: both feet fixed, in balance.
void WholeBody::take(const WbEffector& request, const JointArray<double>& angle) {
  const std::size_t chain = chainOf(request.chain);
  if (request.on && !on_) {
    take(WbEnable{true}, angle);
    take(WbFootState{}, angle);
    take(WbBalance{}, angle);
    by_effector_ = true;
  }
  solver_.body().update(angle);
  effectors_[chain].led = request.on;
  if (request.on) effectors_[chain].task = holdOf(chain);
  if (by_effector_ && !anyLed()) take(WbEnable{false}, angle);
}

bool WholeBody::anyLed() const {
  return std::any_of(effectors_.begin(), effectors_.end(),
                     [](const Led& effector) { return effector.led; });
}

void WholeBody::take(const WbEffectorTarget& request, const JointArray<double>& /*angle*/) {
  Led& effector = effectors_[chainOf(request.chain)];
  if (!effector.led) return;
  if (request.chain == "Head") {
    effector.task.X_BF.linear() =
        rotationFromRpy(request.target.x(), request.target.y(), request.target.z());
  } else {
    effector.task.X_BF.translation() = request.target;
  }
}

void WholeBody::take(const WbOptimize& request, const JointArray<double>& angle) {
  const std::size_t chain = chainOf(request.chain);
  solver_.body().update(angle);
  effectors_[chain].kept = request.on;
  if (request.on && !effectors_[chain].led) effectors_[chain].task = holdOf(chain);
}

std::optional<Foot> WholeBody::anchor() const {
  if (model_->feet.size() != 2) return std::nullopt;
  const std::size_t first = support_ == Feet::Right ? 1 : 0;
  for (const std::size_t foot : {first, 1 - first}) {
    if (states_[foot] != FootState::Free) return foot == 0 ? Foot::Left : Foot::Right;
  }
  return std::nullopt;
}

// Where the effector is now in the robot frame, which stands still with the anchor.
PlaceTask WholeBody::holdOf(std::size_t chain) const {
  const auto found = findChain(*model_, kLed[chain]);
  PlaceTask task;
  if (!found) return task;
  const Kinematics& body = solver_.body();
  const std::optional<Foot> foot = anchor();
  const int base = foot ? soles_[index(*foot)].body : 0;
  task.place = found->place;
  task.base = {base, body.getPose(base).inverse() * body.calcRobotFrame()};
  task.X_BF = relative(body, task.base, task.place);
  task.mask = chain == 0 ? kMaskRotation : kMaskPosition;
  return task;
}

double WholeBody::pursue(const std::vector<PlaceTask>& tasks, const JointSet& joints,
                         const JointArray<double>& angle) {
  pursued_.insert(pursued_.end(), tasks.begin(), tasks.end());
  pursuing_ |= joints;
  BodySolver::Demand demand;
  for (const PlaceTask& task : tasks) {
    if (task.weight >= 1) demand.places.push_back(task);
  }
  return solver_.calcError(demand, angle);
}

void WholeBody::addFeet(BodySolver::Demand& demand) const {
  if (model_->feet.size() != 2) return;
  const bool left_free = states_[0] == FootState::Free;
  if (left_free || states_[1] == FootState::Free) return;
  const bool plane = states_[0] == FootState::Plane || states_[1] == FootState::Plane;
  PlaceTask task;
  task.place = soles_[1];
  task.base = soles_[0];
  task.X_BF = X_LR_;
  task.mask = plane ? kMaskPlane : kMaskAll;
  task.exact = true;
  demand.places.push_back(task);
}

void WholeBody::addBalance(BodySolver::Demand& demand) {
  const std::optional<Foot> foot = anchor();
  if (!balance_ || !foot) return;
  Feet feet = support_;
  if (feet == Feet::Both && states_[0] == FootState::Free) feet = Feet::Right;
  if (feet == Feet::Both && states_[1] == FootState::Free) feet = Feet::Left;
  ComTask com;
  com.floor = soles_[feet == Feet::Right ? 1 : 0];
  com.inside = shrink(calcSupport(solver_.body(), feet), kMargin);
  demand.com = com;
}

void WholeBody::apply(double dt, const JointArray<double>& before, const JointSet& asked,
                      const JointSet& limp, JointArray<double>& angle) {
  std::vector<PlaceTask> pursued;
  pursued.swap(pursued_);
  const JointSet pursuing = pursuing_;
  pursuing_.reset();
  if (!on_) return;
  BodySolver::Demand demand;
  demand.joints = allJoints(*model_) & ~limp;
  demand.dt = dt;
  demand.wish_weight = JointArray<double>(model_->jointCount(), kUnasked);
  for (std::size_t i = 0; i < model_->jointCount(); ++i) {
    const bool wished = asked.test(i) && !pursuing.test(i);
    if (wished || limp.test(i)) wish_[i] = angle[i];
    if (wished) demand.wish_weight[i] = kAsked;
  }
  demand.wish = wish_;
  solver_.body().update(before);
  addFeet(demand);
  addBalance(demand);
  demand.places.insert(demand.places.end(), pursued.begin(), pursued.end());
  for (const Led& effector : effectors_) {
    if (!effector.led && !effector.kept) continue;
    demand.places.push_back(effector.task);
    if (effector.led) demand.fraction = kLedFraction;
    if (!effector.led) demand.places.back().weight = kKept;
  }
  JointArray<double> solved = before;
  solver_.step(demand, solved);
  for (std::size_t i = 0; i < model_->jointCount(); ++i) {
    if (!limp.test(i) && !model_->actuators[i].coordinates.empty()) angle[i] = solved[i];
  }
  // The body stays where a Cartesian target brought it.
  if (!pursued.empty() || anyLed()) wish_ = angle;
}

void WholeBody::archive(Archive& archive) {
  archive.value(on_);
  archive.value(by_effector_);
  archive.value(states_);
  archive.value(balance_);
  archive.value(support_);
  archive.numbers(X_LR_.matrix());
  for (Led& effector : effectors_) {
    archive.value(effector.led);
    archive.value(effector.kept);
    archive.numbers(effector.task.X_BF.matrix());
    archive.value(effector.task.base.body);
    archive.numbers(effector.task.base.X_BF.matrix());
  }
  archive.value(wish_);
}

Polygon calcSupport(const Kinematics& body, Feet feet) {
  const RobotModel& model = body.model();
  const std::size_t first = feet == Feet::Right ? 1 : 0;
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!includes(feet, i)) continue;
    const Pose X_FS = relative(body, soleOf(model, first), soleOf(model, i));
    for (const Eigen::Vector2d& corner : model.feet[i].outline) {
      points.push_back((X_FS * Vec3(corner.x(), corner.y(), 0)).head<2>());
    }
  }
  return calcHull(points);
}

GoToBalance::GoToBalance(std::shared_ptr<const RobotModel> model, const WbGoToBalance& request)
    : solver_(model), request_(request) {
  for (std::size_t i = 0; i < 2 && model->feet.size() == 2; ++i) soles_[i] = soleOf(*model, i);
}

void GoToBalance::begin(Body& body) {
  if (body.model.feet.size() != 2) return;
  Kinematics& now = solver_.body();
  now.update(body.angle);
  const std::size_t foot = request_.feet == Feet::Right ? 1 : 0;
  PlaceTask soles;
  soles.place = soles_[1 - foot];
  soles.base = soles_[foot];
  soles.X_BF = relative(now, soles.base, soles.place);
  soles.exact = true;
  PlaceTask torso;
  torso.base = soles_[foot];
  torso.X_BF = relative(now, torso.base, torso.place);
  torso.mask = kMaskRotation | 4;
  torso.weight = 0.02;  // below the centre of mass, which counts 1
  tasks_ = {soles, torso};
  from_ = (now.calcPose(soles_[foot]).inverse() * now.calcCom()).head<2>();
  to_ = centreOf(calcSupport(now, request_.feet));
}

Phase::Progress GoToBalance::advance(double dt, const JointSet& mine, Body& body) {
  if (tasks_.empty()) return Progress::Failed;
  elapsed_ += dt;
  const double s = std::min(1.0, elapsed_ / request_.seconds);
  const double part = s * s * s * (10 + s * (6 * s - 15));  // minimum jerk
  BodySolver::Demand demand;
  demand.joints = mine;
  demand.places = tasks_;
  demand.com = ComTask{tasks_[0].base, from_ + part * (to_ - from_), {}};
  demand.dt = dt;
  solver_.step(demand, body.angle);
  return s < 1 ? Progress::Running : Progress::Done;
}

std::string GoToBalance::failure() const { return "this robot has no two feet to stand on"; }

void GoToBalance::archive(Archive& archive) {
  archive.value(elapsed_);
  archive.value(request_.feet);
  archive.value(request_.seconds);
  archive.numbers(from_);
  archive.numbers(to_);
  archive.each(tasks_, [&archive](PlaceTask& task) { archive.numbers(task.X_BF.matrix()); });
}

}  // namespace nao::motion

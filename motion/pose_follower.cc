#include "motion/pose_follower.h"

#include <algorithm>
#include <cmath>

#include "motion/walking.h"
#include "motion/whole_body.h"

namespace nao::motion {
namespace {

constexpr double kThere = 2e-5;      // [m] a tenth of an encoder's step at arm's length
constexpr double kNoNearer = 1e-7;   // [m] in a cycle: it has stalled
constexpr double kLinger = 1.0;      // [s] free: a late effector is given this long
constexpr double kHold = 1e-2;       // weight of a torso or leg that shall stay, below a task's 1
constexpr double kRounding = 5e-10;  // [s] of summed cycles

Trajectory smoothTrack(double start, const std::vector<double>& values,
                       const std::vector<double>& times) {
  std::vector<Key> keys(values.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    keys[i].time = times[i];
    keys[i].angle = values[i];
  }
  setAutoHandles(start, keys);
  return {start, keys};
}

Pose moved(const Pose& from, const Pose& change) {
  Pose to = translation(from.translation() + change.translation());
  to.linear() = change.linear() * from.linear();
  return to;
}

}  // namespace

Pose PoseFollower::Course::at(double time) const {
  const double along = turn.at(time);
  const double last = static_cast<double>(turns.size() - 1);
  const auto piece = static_cast<std::size_t>(std::clamp(std::floor(along), 0.0, last - 1));
  const double part = std::clamp(along - static_cast<double>(piece), 0.0, 1.0);
  const Eigen::Quaterniond from(turns[piece]);
  const Eigen::Quaterniond to(turns[piece + 1]);
  Pose pose = translation(Vec3(x.at(time), y.at(time), z.at(time)));
  pose.linear() = from.slerp(part, to).normalized().toRotationMatrix();
  return pose;
}

PoseFollower::PoseFollower(std::shared_ptr<const RobotModel> model, std::vector<PoseTrack> tracks,
                           bool relative)
    : model_(std::move(model)), tracks_(std::move(tracks)), relative_(relative), solver_(model_) {
  for (const PoseTrack& track : tracks_) {
    const auto chain = findChain(*model_, track.chain);
    NAO_CHECK(chain.has_value());
    chains_.push_back(*chain);
    joints_ |= chain->joints;
  }
  for (std::size_t i = 0; i < 2 && model_->feet.size() == 2; ++i) {
    soles_[i] = {model_->feet[i].body, model_->feet[i].X_BS};
  }
}

bool PoseFollower::has(Chain::Kind kind) const {
  return std::any_of(chains_.begin(), chains_.end(),
                     [kind](const Chain& chain) { return chain.kind == kind; });
}

// The space, fixed to what stands still: a sole, or the torso.
Effector PoseFollower::baseOf(const PoseTrack& track, const Pose2& odometry) const {
  const Kinematics& body = solver_.body();
  const Pose X_TSpace = calcSpace(body, track.space, odometry);
  const bool left = has(Chain::Kind::LeftLeg);
  const bool by_torso = track.space == Space::Torso || model_->feet.size() != 2 ||
                        (left && has(Chain::Kind::RightLeg));
  const int anchor = by_torso ? 0 : sole(left ? Foot::Right : Foot::Left).body;
  return {anchor, body.getPose(anchor).inverse() * X_TSpace};
}

void PoseFollower::begin(const JointArray<double>& angle, const Pose2& odometry) {
  solver_.body().update(angle);
  for (std::size_t i = 0; i < tracks_.size(); ++i) beginTrack(tracks_[i], chains_[i], odometry);
  addHolds();
}

void PoseFollower::beginTrack(const PoseTrack& track, const Chain& chain, const Pose2& odometry) {
  PlaceTask task;
  task.place = chain.place;
  task.base = baseOf(track, odometry);
  task.mask = track.mask;
  // Five ways are left to a torso on two feet: its place goes before its turns.
  if (chain.kind == Chain::Kind::Torso) task.radian = 0.03;
  const Kinematics& body = solver_.body();
  task.X_BF = body.calcPose(task.base).inverse() * body.calcPose(task.place);
  const Vec3 start = task.X_BF.translation();
  std::array<std::vector<double>, 4> values;
  Course course;
  course.turns.push_back(task.X_BF.linear());
  for (std::size_t i = 0; i < track.path.size(); ++i) {
    const Pose pose = relative_ ? moved(task.X_BF, track.path[i]) : track.path[i];
    for (std::size_t k = 0; k < 3; ++k)
      values[k].push_back(pose.translation()[static_cast<long>(k)]);
    values[3].push_back(static_cast<double>(i + 1));
    course.turns.push_back(pose.linear());
  }
  course.x = smoothTrack(start.x(), values[0], track.times);
  course.y = smoothTrack(start.y(), values[1], track.times);
  course.z = smoothTrack(start.z(), values[2], track.times);
  course.turn = smoothTrack(0, values[3], track.times);
  duration_ = std::max(duration_, track.times.back());
  courses_.push_back(std::move(course));
  tasks_.push_back(task);
}

// What nobody asked to move stays: the soles to each other under a moving torso, the torso over
// the sole that stands, the other leg when a leg moves in the torso's frame.
void PoseFollower::addHolds() {
  const bool left = has(Chain::Kind::LeftLeg);
  const bool right = has(Chain::Kind::RightLeg);
  const bool torso = has(Chain::Kind::Torso);
  const Kinematics& body = solver_.body();
  const auto hold = [&](const Effector& place, const Effector& base, bool exact) {
    PlaceTask task;
    task.place = place;
    task.base = base;
    task.X_BF = body.calcPose(base).inverse() * body.calcPose(place);
    task.weight = kHold;
    task.exact = exact;
    tasks_.push_back(task);
  };
  if (torso && !left && !right) hold(sole(Foot::Right), sole(Foot::Left), true);
  if (left != right && !torso) hold(Effector{}, sole(left ? Foot::Right : Foot::Left), false);
}

const std::vector<PlaceTask>& PoseFollower::tasksAt(double time) {
  for (std::size_t i = 0; i < courses_.size(); ++i) tasks_[i].X_BF = courses_[i].at(time);
  return tasks_;
}

double PoseFollower::step(double time, double dt, double fraction, const JointSet& mine,
                          JointArray<double>& angle) {
  BodySolver::Demand demand;
  demand.joints = joints_ & mine;
  demand.places = tasksAt(time);
  demand.fraction = fraction;
  demand.dt = dt;
  solver_.step(demand, angle);
  demand.places.resize(courses_.size());
  return solver_.calcError(demand, angle);
}

void PoseFollower::archive(Archive& archive) {
  archive.value(joints_);
  archive.value(duration_);
  for (Course& course : courses_) {
    for (Trajectory* track : {&course.x, &course.y, &course.z, &course.turn}) {
      track->archive(archive);
    }
    archive.each(course.turns, [&archive](Mat3& turn) { archive.numbers(turn); });
  }
  archive.each(tasks_, [&archive](PlaceTask& task) {
    archive.value(task.place.body);
    archive.value(task.base.body);
    archive.numbers(task.base.X_BF.matrix());
    archive.numbers(task.X_BF.matrix());
    archive.value(task.mask);
  });
}

void FollowPoses::begin(Body& body) {
  const Gait* gait = body.walking ? body.walking->gait() : nullptr;
  follower_.begin(body.angle, gait ? gait->position() : Pose2{});
  left_ = 1;
}

Phase::Progress FollowPoses::advance(double dt, const JointSet& mine, Body& body) {
  elapsed_ += dt;
  const double time = std::min(elapsed_, follower_.duration());
  double left = 0;
  if (body.whole_body && body.whole_body->enabled()) {
    left = body.whole_body->pursue(follower_.tasksAt(time), follower_.joints() & mine, body.angle);
  } else {
    left = follower_.step(time, dt, 1.0, mine, body.angle);
  }
  const bool nearer = left < left_ - kNoNearer;
  left_ = left;
  if (elapsed_ < follower_.duration() - kRounding) return Progress::Running;
  const bool over = left < kThere || !nearer || elapsed_ > follower_.duration() + kLinger;
  return over ? Progress::Done : Progress::Running;
}

void FollowPoses::archive(Archive& archive) {
  follower_.archive(archive);
  archive.value(elapsed_);
  archive.value(left_);
}

void PoseGoals::add(PoseFollower follower, double fraction) {
  release(follower.joints());
  goals_.push_back({std::move(follower), fraction, 1e9});
}

void PoseGoals::release(const JointSet& joints) {
  goals_.erase(
      std::remove_if(goals_.begin(), goals_.end(),
                     [&](const Goal& goal) { return (goal.follower.joints() & joints).any(); }),
      goals_.end());
}

JointSet PoseGoals::active() const {
  JointSet joints;
  for (const Goal& goal : goals_) joints |= goal.follower.joints();
  return joints;
}

void PoseGoals::advance(double dt, JointArray<double>& angle) {
  for (std::size_t i = 0; i < goals_.size();) {
    Goal& goal = goals_[i];
    PoseFollower& follower = goal.follower;
    const double left =
        follower.step(follower.duration(), dt, goal.fraction, follower.joints(), angle);
    const bool over = left < kThere || left > goal.left - kNoNearer;
    goal.left = left;
    if (over) {
      goals_.erase(goals_.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
}

void PoseGoals::archive(Archive& archive) {
  for (Goal& goal : goals_) {
    goal.follower.archive(archive);
    archive.value(goal.fraction);
    archive.value(goal.left);
  }
}

}  // namespace nao::motion

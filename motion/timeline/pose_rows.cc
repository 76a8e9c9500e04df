#include "motion/timeline/pose_rows.h"

#include <algorithm>
#include <set>

#include "core/check.h"

namespace nao::motion {

PoseRows::PoseRows(const RobotModel& model, std::string source)
    : model_(model), source_(std::move(source)) {}

std::size_t PoseRows::addColumn(const std::string& joint, int line) {
  const auto found = model_.findJoint(joint);
  if (!found) warn(line, "this robot has no joint " + joint);
  columns_.push_back({joint, found, {}});
  return columns_.size() - 1;
}

bool PoseRows::isHand(std::size_t column) const {
  const auto& joint = columns_.at(column).joint;
  return joint && model_.actuators[index(*joint)].coordinates.empty();
}

void PoseRows::put(std::size_t column, double time, double value, Course course) {
  auto& keys = columns_.at(column).keys;
  if (time <= 0) line_at_zero_ = line_;
  if (!keys.empty() && time <= keys.back().time) keys.pop_back();
  Key key;
  key.time = time;
  key.angle = value;
  key.before.kind = key.after.kind = Handle::Kind::Linear;
  if (course == Course::Level) {
    const double third = (time - (keys.empty() ? 0 : keys.back().time)) / 3;
    if (!keys.empty()) keys.back().after = {Handle::Kind::Bezier, third, 0};
    key.before = {Handle::Kind::Bezier, -third, 0};
  }
  keys.push_back(key);
}

void PoseRows::hold(std::size_t column, double time) {
  const auto& keys = columns_.at(column).keys;
  if (!keys.empty()) put(column, time, keys.back().angle);
}

void PoseRows::jump(std::size_t column, double begin, double end, double value) {
  put(column, std::min(begin + kFirstPose, (begin + end) / 2), value);
  put(column, end, value);
}

void PoseRows::warn(int line, const std::string& sentence) {
  builder_.warn(source_ + ":" + std::to_string(line) + ": " + sentence);
}

void PoseRows::settleFirstKey(std::vector<Key>& keys) const {
  if (keys.empty() || keys.front().time > 0) return;
  keys.front().time = keys.size() == 1 ? kFirstPose : std::min(kFirstPose, keys[1].time / 2);
}

Timeline PoseRows::take() {
  std::set<std::size_t> done;
  // The robot's own name goes first: LHipYawPitch wins over its other name RHipYawPitch.
  for (const bool aliases : {false, true}) {
    for (Column& column : columns_) {
      if (!column.joint || (model_.aliases.count(column.name) != 0) != aliases) continue;
      if (column.keys.empty() || !done.insert(index(*column.joint)).second) continue;
      settleFirstKey(column.keys);
      builder_.add(0, {*column.joint, column.keys});
    }
  }
  if (line_at_zero_) {
    builder_.addFault({{},
                       0,
                       source_ + ":" + std::to_string(*line_at_zero_) +
                           ": this row is at time 0; its pose is reached after " +
                           "0.02 s, or half way to the next row"});
  }
  if (builder_.isEmpty()) {
    builder_.failIfBroken();
    const std::string why = builder_.warnings().empty() ? "" : "; " + builder_.warnings().front();
    throw InputError(source_ + ":1: nothing here moves a joint of this robot" + why);
  }
  return builder_.take();
}

}  // namespace nao::motion

#include "motion/timeline/timeline.h"

#include <algorithm>

namespace nao::motion {
namespace {

constexpr double kSameTime = 1e-6;  // [s] far below the distance of frames

Key holdingKey(double time, double angle) {
  Key key;
  key.time = time;
  key.angle = angle;
  key.before.kind = Handle::Kind::Linear;
  key.after.kind = Handle::Kind::Bezier;
  return key;
}

}  // namespace

void TimelineBuilder::add(double start, const Curve& curve) {
  if (curve.keys.empty()) return;
  lastUntil(start + curve.keys.back().time);
  const auto same_joint = [&](const Curve& c) { return c.joint == curve.joint; };
  auto& curves = timeline_.curves;
  auto mine = std::find_if(curves.begin(), curves.end(), same_joint);
  if (mine == curves.end()) mine = curves.insert(curves.end(), {curve.joint, {}});

  auto& keys = mine->keys;
  while (!keys.empty() && keys.back().time > start + kSameTime) keys.pop_back();
  if (!keys.empty() && keys.back().time < start - kSameTime) {
    keys.back().after = {Handle::Kind::Linear, 0, 0};
    keys.push_back(holdingKey(start, keys.back().angle));
  }
  for (Key key : curve.keys) {
    key.time += start;
    if (keys.empty() || key.time > keys.back().time + kSameTime) keys.push_back(key);
  }
}

void TimelineBuilder::lastUntil(double end) { timeline_.length = std::max(timeline_.length, end); }

}  // namespace nao::motion

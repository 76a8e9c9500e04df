#include "motion/timeline/timeline.h"

#include <algorithm>

#include "core/check.h"

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

double keyReached(const Curve& curve, double time) {
  double number = 0;
  for (const Key& key : curve.keys) number += key.time <= time + kSameTime ? 1 : 0;
  return number;
}

}  // namespace

double frameAt(const Timeline& timeline, std::optional<Joint> joint, double time) {
  const FrameClock* clock = nullptr;
  for (const FrameClock& c : timeline.clocks) {
    if ((!joint || c.joint == *joint) && c.start <= time + kSameTime) clock = &c;
  }
  if (clock) return clock->first_frame + (time - clock->start) * clock->fps;
  double number = 0;
  for (const Curve& curve : timeline.curves) {
    if (!joint || curve.joint == *joint) number = std::max(number, keyReached(curve, time));
  }
  return number;
}

void TimelineBuilder::attempt(const std::function<void()>& read) {
  try {
    read();
  } catch (const InputError& error) {
    addBroken(error.what());
  }
}

void TimelineBuilder::failIfBroken() const {
  if (!timeline_.broken.empty()) throw InputError(timeline_.broken.front());
}

Timeline TimelineBuilder::take() {
  std::stable_sort(timeline_.clocks.begin(), timeline_.clocks.end(),
                   [](const FrameClock& a, const FrameClock& b) { return a.start < b.start; });
  holdUntilEnd();
  return std::move(timeline_);
}

// The joint that moves longest holds until the end, so that whoever plays the curves plays on.
void TimelineBuilder::holdUntilEnd() {
  const auto end_of = [](const Curve& curve) { return curve.keys.back().time; };
  const auto longest =
      std::max_element(timeline_.curves.begin(), timeline_.curves.end(),
                       [&](const Curve& a, const Curve& b) { return end_of(a) < end_of(b); });
  if (longest == timeline_.curves.end()) return;
  if (end_of(*longest) > timeline_.length - kSameTime) return;
  longest->keys.back().after = {Handle::Kind::Linear, 0, 0};
  longest->keys.push_back(holdingKey(timeline_.length, longest->keys.back().angle));
}

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

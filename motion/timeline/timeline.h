#pragma once

#include <string>
#include <vector>

#include "core/robot_model.h"
#include "motion/motion_request.h"

namespace nao::motion {

/// A recorded motion on one time base, ready for Interpolate (with smooth = false): each joint at
/// most once, handles filled in.
struct Timeline {
  std::vector<Curve> curves;
  double length = 0;                  // [s] until everything has ended
  std::vector<std::string> warnings;  // what was left out, one sentence each
};

/// Puts motions that start at different times onto one time base. A joint holds its last key
/// until its next motion begins; where motions overlap the later one has the joint.
class TimelineBuilder {
 public:
  /// `curve` runs from `start` [s] on; its key times count from there.
  void add(double start, const Curve& curve);

  /// Nothing ends before `end` [s].
  void lastUntil(double end);
  void warn(std::string sentence) { timeline_.warnings.push_back(std::move(sentence)); }

  bool isEmpty() const { return timeline_.curves.empty(); }
  Timeline take() { return std::move(timeline_); }

 private:
  Timeline timeline_;
};

}  // namespace nao::motion

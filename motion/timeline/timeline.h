#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "motion/motion_request.h"

namespace nao::motion {

/// How a file counts the frames of one joint from `start` [s] on, until the joint's next clock.
struct FrameClock {
  Joint joint{};
  double start = 0;        // [s] on the time base of the Timeline
  double fps = 25;         // [1/s]
  double first_frame = 0;  // at `start`
};

/// A key that could not be played as it is written, and what was done with it.
struct KeyFault {
  std::optional<Joint> joint;  // none: a row of all joints
  double time = 0;             // [s] where it is played, or would have been
  std::string sentence;        // with file and line
};

/// A recorded motion on one time base, ready for Interpolate (with smooth = false): each joint at
/// most once, handles filled in.
struct Timeline {
  std::vector<Curve> curves;
  double length = 0;                  // [s] until everything has ended
  std::vector<std::string> warnings;  // what was left out, one sentence each
  std::vector<KeyFault> key_faults;
  std::vector<std::string> broken;  // what could not be read; the rest is here
  std::vector<FrameClock> clocks;   // by start; none of a joint whose file does not count frames
};

/// The frame of the file that shows this joint at `time` [s]; of a file without frames the number
/// of the key reached last, from 1 on, 0 before. No joint: whichever joint has come furthest.
double frameAt(const Timeline& timeline, std::optional<Joint> joint, double time);

/// Puts motions that start at different times onto one time base. A joint holds its last key
/// until its next motion begins; where motions overlap the later one has the joint.
class TimelineBuilder {
 public:
  /// `curve` runs from `start` [s] on; its key times count from there.
  void add(double start, const Curve& curve);

  void addClock(const FrameClock& clock) { timeline_.clocks.push_back(clock); }
  /// Reads one part of a file. If `read` throws an InputError the part is left out and the sentence
  /// kept as broken; `read` must not have added anything yet.
  void attempt(const std::function<void()>& read);

  /// What was wrong with the file's form already.
  void addBroken(std::string sentence) { timeline_.broken.push_back(std::move(sentence)); }

  void addFault(KeyFault fault) { timeline_.key_faults.push_back(std::move(fault)); }

  /// Nothing ends before `end` [s].
  void lastUntil(double end);
  void warn(std::string sentence) { timeline_.warnings.push_back(std::move(sentence)); }

  const std::vector<std::string>& warnings() const { return timeline_.warnings; }
  bool isEmpty() const { return timeline_.curves.empty(); }
  Timeline take();

  /// @throws InputError with the first broken part, if there is one: for a file of which nothing is
  /// left to play.
  void failIfBroken() const;

 private:
  void holdUntilEnd();

  Timeline timeline_;
};

}  // namespace nao::motion

#pragma once

#include <vector>

#include "core/archive.h"
#include "core/joint.h"
#include "motion/joint_set.h"
#include "motion/motion_request.h"

namespace nao::motion {

/// The stiffness of every joint: set at once, or along straight lines in time. It books nothing:
/// whoever comes last for a joint has it. All joints start limp.
class Stiffness {
 public:
  explicit Stiffness(std::size_t joints) : value_(joints) {}

  const JointArray<double>& value() const { return value_; }

  void set(Joint joint, double value);

  /// Follows the tracks from the present values on; `id` is reported by advance() when done.
  void run(RequestId id, const InterpolateStiffness& request);

  /// One line to `value` within `seconds` for each of these joints, reported to nobody.
  void ramp(const JointSet& joints, double value, double seconds);

  /// Stops a run where it is; false if there is none of this number.
  bool kill(RequestId id);
  std::vector<RequestId> killAll();

  /// One cycle of `dt` [s]; returns the runs that ended.
  std::vector<RequestId> advance(double dt);

  /// From now on the runs under way are reported to nobody.
  void forgetCallers();

  /// Lists values and runs, not who waits for these.
  void archive(Archive& archive);

 private:
  struct Track {
    Joint joint{};
    double start = 0;
    std::vector<double> stiffness;
    std::vector<double> times;
  };
  struct Run {
    RequestId id = 0;
    std::vector<Track> tracks;
    double elapsed = 0;
    double duration = 0;
  };
  void takeOver(Joint joint);
  static double valueAt(const Track& track, double time);

  JointArray<double> value_;
  std::vector<Run> runs_;
};

}  // namespace nao::motion

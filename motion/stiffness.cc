#include "motion/stiffness.h"

#include <algorithm>

namespace nao::motion {
namespace {

// Half a nanosecond: below any cycle, above the rounding of summed cycles.
constexpr double kTimeRounding = 5e-10;  // [s]

}  // namespace

void Stiffness::set(Joint joint, double value) {
  takeOver(joint);
  value_[joint] = value;
}

void Stiffness::run(RequestId id, const InterpolateStiffness& request) {
  Run run;
  run.id = id;
  for (const auto& wanted : request.tracks) {
    takeOver(wanted.joint);
    run.tracks.push_back(
        {wanted.joint, std::max(value_[wanted.joint], 0.0), wanted.stiffness, wanted.times});
    if (!wanted.times.empty()) run.duration = std::max(run.duration, wanted.times.back());
  }
  runs_.push_back(std::move(run));
}

void Stiffness::ramp(const JointSet& joints, double value, double seconds) {
  InterpolateStiffness request;
  for (std::size_t i = 0; i < value_.size(); ++i) {
    if (joints.test(i)) request.tracks.push_back({toJoint(i), {value}, {seconds}});
  }
  run(0, request);
}

bool Stiffness::kill(RequestId id) {
  if (id == 0) return false;  // nobody's
  const auto found =
      std::find_if(runs_.begin(), runs_.end(), [id](const Run& run) { return run.id == id; });
  if (found == runs_.end()) return false;
  runs_.erase(found);
  return true;
}

std::vector<RequestId> Stiffness::killAll() {
  std::vector<RequestId> killed;
  for (const Run& run : runs_) {
    if (run.id != 0) killed.push_back(run.id);
  }
  runs_.clear();
  return killed;
}

std::vector<RequestId> Stiffness::advance(double dt) {
  std::vector<RequestId> ended;
  for (Run& run : runs_) {
    run.elapsed += dt;
    for (const Track& track : run.tracks) value_[track.joint] = valueAt(track, run.elapsed);
  }
  const auto is_over = [](const Run& run) { return run.elapsed >= run.duration - kTimeRounding; };
  for (const Run& run : runs_) {
    if (is_over(run) && run.id != 0) ended.push_back(run.id);
  }
  runs_.erase(std::remove_if(runs_.begin(), runs_.end(), is_over), runs_.end());
  return ended;
}

void Stiffness::forgetCallers() {
  for (Run& run : runs_) run.id = 0;
}

void Stiffness::archive(Archive& archive) {
  archive.value(value_);
  archive.each(runs_, [&archive](Run& run) {
    archive.value(run.elapsed);
    archive.value(run.duration);
    archive.each(run.tracks, [&archive](Track& track) {
      archive.value(track.joint);
      archive.value(track.start);
      archive.list(track.stiffness);
      archive.list(track.times);
    });
  });
}

void Stiffness::takeOver(Joint joint) {
  for (Run& run : runs_) {
    run.tracks.erase(std::remove_if(run.tracks.begin(), run.tracks.end(),
                                    [joint](const Track& t) { return t.joint == joint; }),
                     run.tracks.end());
  }
}

double Stiffness::valueAt(const Track& track, double time) {
  double t0 = 0;
  double y0 = track.start;
  for (std::size_t i = 0; i < track.times.size(); ++i) {
    if (time < track.times[i] - kTimeRounding) {
      return y0 + (track.stiffness[i] - y0) * (time - t0) / (track.times[i] - t0);
    }
    t0 = track.times[i];
    y0 = track.stiffness[i];
  }
  return y0;
}

}  // namespace nao::motion

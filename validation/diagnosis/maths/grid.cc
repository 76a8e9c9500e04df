#include "validation/diagnosis/maths/grid.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace nao::validation {
namespace {

using Values = std::vector<double>;

bool isUnknown(double x) { return std::isnan(x); }

struct Samples {
  Values t, value;
};

// What a column really holds.
Samples sampled(const LogRun& run, const Column& column) {
  Samples samples;
  for (std::size_t i = 0; i < column.size(); ++i) {
    if (isUnknown(column[i])) continue;
    samples.t.push_back(run.t[i]);
    samples.value.push_back(column[i]);
  }
  return samples;
}

// A time of the grid and of the file are the same if they differ by less than this [s].
constexpr double kSame = 1e-7;

constexpr double kLate = 0.25;     // [s] of a first row from a motion's begin
constexpr double kMostRows = 100;  // of the grid, for one of the file; free choice

// What was sent last at every time of the grid.
Values held(const Samples& from, std::size_t rows, double dt) {
  Values values;
  std::size_t i = 0;
  for (std::size_t k = 0; k < rows; ++k) {
    const double t = static_cast<double>(k) * dt;
    while (i + 1 < from.t.size() && from.t[i + 1] <= t + kSame) ++i;
    values.push_back(from.value[i]);
  }
  return values;
}

Values linear(const Samples& from, std::size_t rows, double dt) {
  Values values;
  std::size_t i = 0;
  for (std::size_t k = 0; k < rows; ++k) {
    const double t = static_cast<double>(k) * dt;
    while (i + 2 < from.t.size() && from.t[i + 1] <= t + kSame) ++i;
    if (i + 1 >= from.t.size() || std::abs(t - from.t[i]) < kSame) {
      values.push_back(from.value[i]);
      continue;
    }
    const double part = std::clamp((t - from.t[i]) / (from.t[i + 1] - from.t[i]), 0.0, 1.0);
    values.push_back(from.value[i] + part * (from.value[i + 1] - from.value[i]));
  }
  return values;
}

class Gridder {
 public:
  Gridder(const LogSet& set, const RobotModel& model) : set_(set) {
    for (const LogJoint& joint : set.joints) {
      const auto found = model.findJoint(joint.name);
      if (!found) {
        throw InputError(set.name + ": expected joints of " + model.name + ", found '" +
                         joint.name + "'");
      }
      joints_.push_back(*found);
    }
  }

  std::vector<GriddedMotion> all() const {
    std::vector<GriddedMotion> motions;
    for (const LogRun& run : set_.runs) {
      checkTimes(run);
      auto at = std::find_if(motions.begin(), motions.end(),
                             [&](const GriddedMotion& m) { return isOf(run, m); });
      if (at == motions.end()) at = motions.insert(motions.end(), started(run));
      checkAlike(*at, run);
      at->rows = std::min(at->rows, rowsOf(run));
    }
    for (GriddedMotion& motion : motions) {
      for (const LogRun& run : set_.runs) {
        if (isOf(run, motion)) motion.runs.push_back(gridded(run, motion));
      }
    }
    return motions;
  }

 private:
  // One motion alone may be split by runs.
  static bool isOf(const LogRun& run, const GriddedMotion& motion) {
    return run.motion == motion.motion && run.split == motion.split;
  }

  void checkTimes(const LogRun& run) const {
    const std::string file = set_.name + ", " + run.file;
    if (run.t.size() < 2) throw InputError(file + ": expected at least two rows");
    if (!(std::abs(run.t.front()) <= kLate)) {
      throw InputError(file + ": expected times from the begin of the motion on, found " +
                       std::to_string(run.t.front()) + " s in its first row");
    }
    if (!(run.t.back() * set_.rate < kMostRows * static_cast<double>(run.t.size()))) {
      throw InputError(file + ": expected about a row every " + std::to_string(1 / set_.rate) +
                       " s, found " + std::to_string(run.t.size()) + " rows in " +
                       std::to_string(run.t.back()) + " s");
    }
  }

  std::size_t rowsOf(const LogRun& run) const {
    return static_cast<std::size_t>(std::floor(run.t.back() * set_.rate + 1e-4)) + 1;
  }

  GriddedMotion started(const LogRun& run) const {
    GriddedMotion motion;
    motion.motion = run.motion;
    motion.split = run.split;
    motion.dt = 1 / set_.rate;
    motion.rows = rowsOf(run);
    motion.kp_scale = run.kp_scale;
    motion.load = run.load;
    motion.start_pose = run.start_pose;
    return motion;
  }

  static void checkAlike(const GriddedMotion& motion, const LogRun& run) {
    const bool loads_alike =
        motion.load.has_value() == run.load.has_value() &&
        (!run.load || (motion.load->mass == run.load->mass && motion.load->link == run.load->link));
    if (motion.kp_scale == run.kp_scale && loads_alike) return;
    throw InputError(run.file + ": expected the gain and load of the other runs of '" + run.motion +
                     "'");
  }

  GriddedMotion::Run gridded(const LogRun& run, const GriddedMotion& motion) const {
    GriddedMotion::Run result;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const LogJoint& joint = set_.joints[i];
      const auto fill = [&](const char* signal, auto resample, std::map<Joint, Values>& into) {
        const Column* column = run.find(std::string(signal) + "." + joint.name);
        if (column == nullptr) return false;
        const Samples samples = sampled(run, *column);
        if (samples.t.empty()) return false;
        into[joints_[i]] = resample(samples, motion.rows, motion.dt);
        return true;
      };
      if (fill("cmd", held, result.command)) undo(joint, result.command[joints_[i]]);
      if (fill("q", linear, result.angle)) undo(joint, result.angle[joints_[i]]);
      fill("cur", linear, result.current);
      if (!fill("cmd_stiffness", held, result.stiffness)) {
        result.stiffness[joints_[i]].assign(motion.rows, joint.stiffness);
      }
    }
    return result;
  }

  static void undo(const LogJoint& joint, Values& angles) {
    for (double& angle : angles) angle = joint.sign * (angle - joint.zero);
  }

  const LogSet& set_;
  std::vector<Joint> joints_;  // of the model, by joint of the set
};

}  // namespace

std::vector<GriddedMotion> griddedMotions(const LogSet& set, const RobotModel& model) {
  if (!(set.rate > 0)) throw InputError(set.name + ": expected a nominal rate above 0");
  return Gridder(set, model).all();
}

}  // namespace nao::validation

#include "validation/diagnosis/replay/whole_run.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "validation/log/series.h"
#include "validation/log/standard_motions.h"

namespace nao::validation {
namespace {

// The columns that a run has of these, on even rows; none if one of them is missing.
class Reader {
 public:
  Reader(const LogRun& run, double dt, Eigen::Index rows) : run_(run), dt_(dt), rows_(rows) {}

  bool has(const std::string& name) const {
    const Column* column = run_.find(name);
    return column && std::any_of(column->begin(), column->end(),
                                 [](double value) { return !std::isnan(value); });
  }

  Eigen::VectorXd column(const std::string& name) const {
    std::vector<double> values = resample(run_.t, *run_.find(name), dt_);
    if (values.empty()) return Eigen::VectorXd::Zero(rows_);
    values.resize(static_cast<std::size_t>(rows_), values.back());
    return Eigen::Map<const Eigen::VectorXd>(values.data(), rows_);
  }

  Eigen::MatrixXd columns(const std::vector<std::string>& names) const {
    Eigen::MatrixXd all(rows_, static_cast<Eigen::Index>(names.size()));
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!has(names[i])) return {};
      all.col(static_cast<Eigen::Index>(i)) = column(names[i]);
    }
    return all;
  }

 private:
  const LogRun& run_;
  double dt_;
  Eigen::Index rows_;
};

// Yaw of a torso of this attitude, without jumps from row to row.
Eigen::VectorXd yawOf(const Eigen::MatrixXd& wxyz) {
  Eigen::VectorXd yaw(wxyz.rows());
  for (Eigen::Index k = 0; k < yaw.size(); ++k) {
    const Eigen::Quaterniond q(wxyz(k, 0), wxyz(k, 1), wxyz(k, 2), wxyz(k, 3));
    const Eigen::Matrix3d R = q.normalized().toRotationMatrix();
    const double angle = std::atan2(R(1, 0), R(0, 0));
    yaw[k] = k == 0 ? angle : yaw[k - 1] + wrapAngle(angle - yaw[k - 1]);
  }
  return yaw;
}

Eigen::MatrixXd placeOf(const Reader& reader) {
  const Eigen::MatrixXd xy = reader.columns({"gt.base.x", "gt.base.y"});
  const Eigen::MatrixXd wxyz =
      reader.columns({"gt.base.qw", "gt.base.qx", "gt.base.qy", "gt.base.qz"});
  if (xy.size() == 0 || wxyz.size() == 0) return {};
  Eigen::MatrixXd place(xy.rows(), 3);
  place << xy, yawOf(wxyz);
  return fromFirstRow(place);
}

Eigen::MatrixXd weightOf(const Reader& reader) {
  Eigen::MatrixXd weight;
  for (const char* foot : {"fsr.L.", "fsr.R."}) {
    const std::string name = foot;
    const Eigen::MatrixXd cells =
        reader.columns({name + "fl", name + "fr", name + "rl", name + "rr"});
    if (cells.size() == 0) return {};
    weight.conservativeResize(cells.rows(), weight.cols() + 1);
    weight.col(weight.cols() - 1) = cells.rowwise().sum();
  }
  return weight;
}

void readJoint(const Reader& reader, const LogJoint& joint, Eigen::Index j, WholeRun& run) {
  const auto undone = [&](const Eigen::VectorXd& angle) {
    return (joint.sign * (angle.array() - joint.zero)).matrix().eval();
  };
  if (reader.has("cmd." + joint.name)) {
    run.command.col(j) = undone(reader.column("cmd." + joint.name));
  }
  if (reader.has("q." + joint.name)) run.angle.col(j) = undone(reader.column("q." + joint.name));
  if (reader.has("cmd_stiffness." + joint.name)) {
    run.stiffness.col(j) = reader.column("cmd_stiffness." + joint.name);
  } else {
    run.stiffness.col(j).setConstant(joint.stiffness);
  }
}

// Joints of which the set says nothing stay in the run's start pose; those of a robot without
// postures at 0.
void rest(const LogRun& run, const LogSet& set, const RobotModel& model, WholeRun& whole) {
  const auto start = startPose(model, run.start_pose);
  for (std::size_t j = 0; j < model.jointCount(); ++j) {
    const bool told = std::any_of(set.joints.begin(), set.joints.end(), [&](const LogJoint& joint) {
      return model.findJoint(joint.name) == toJoint(j);
    });
    const bool rests = !told && !model.actuators[j].coordinates.empty();
    if (rests && !start && !run.start_pose.empty()) {
      rejectStartPose(model, run.file, run.start_pose);
    }
    whole.command.col(static_cast<Eigen::Index>(j)).setConstant(start ? (*start)[j] : 0);
  }
}

}  // namespace

Eigen::MatrixXd fromFirstRow(const Eigen::MatrixXd& place) {
  Eigen::MatrixXd relative = place.rowwise() - place.row(0);
  const Eigen::Rotation2Dd ahead(-place(0, 2));
  relative.leftCols(2) = (ahead.toRotationMatrix() * relative.leftCols(2).transpose()).transpose();
  return relative;
}

WholeRun wholeRunOf(const LogRun& run, const LogSet& set, const RobotModel& model) {
  if (run.t.size() < 2) throw InputError(run.file + ": expected at least two rows");
  WholeRun whole;
  whole.dt = toSeconds(model.cycle);
  const auto rows =
      static_cast<Eigen::Index>(std::floor((run.t.back() - run.t.front()) / whole.dt + 1e-4)) + 1;
  const auto joints = static_cast<Eigen::Index>(model.jointCount());
  const Reader reader(run, whole.dt, rows);
  whole.command.resize(rows, joints);
  whole.angle = Eigen::MatrixXd::Zero(rows, joints);
  whole.stiffness = Eigen::MatrixXd::Ones(rows, joints);
  rest(run, set, model, whole);
  for (const LogJoint& joint : set.joints) {
    const auto found = model.findJoint(joint.name);
    if (!found) {
      throw InputError(set.name + ": expected joints of " + model.name + ", found '" + joint.name +
                       "'");
    }
    readJoint(reader, joint, static_cast<Eigen::Index>(index(*found)), whole);
  }
  whole.tilt = reader.columns({"imu.ang.x", "imu.ang.y"});
  whole.acceleration = reader.columns({"imu.acc.x", "imu.acc.y", "imu.acc.z"});
  whole.turning = reader.columns({"imu.gyr.x", "imu.gyr.y", "imu.gyr.z"});
  if (whole.turning.size() == 0) whole.turning = reader.columns({"imu.gyr.x", "imu.gyr.y"});
  whole.fell = whole.tilt.size() > 0 && whole.tilt.cwiseAbs().maxCoeff() > M_PI / 4;
  whole.weight = weightOf(reader);
  whole.place = placeOf(reader);
  whole.kp_scale = run.kp_scale;
  whole.load = run.load;
  return whole;
}

std::vector<Joint> jointsMeasured(const LogSet& set, const RobotModel& model) {
  std::vector<Joint> joints;
  for (const LogJoint& joint : set.joints) {
    const auto found = model.findJoint(joint.name);
    if (!found || model.actuators[index(*found)].coordinates.empty()) continue;
    const auto complete = [&](const LogRun& run) {
      return run.find("cmd." + joint.name) && run.find("q." + joint.name);
    };
    if (std::all_of(set.runs.begin(), set.runs.end(), complete)) joints.push_back(*found);
  }
  return joints;
}

}  // namespace nao::validation

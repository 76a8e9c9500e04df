#include "tests/hidden/mujoco/recording.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "tests/hidden/mujoco/mjcf.h"
#include "tests/hidden/mujoco/motor.h"

namespace nao::hidden {
namespace {

using validation::LogRun;
using validation::LogSet;
using validation::RecordedMotion;
using validation::RecordingPlan;

// [s] Free choice: gears of 0.007 kg m^2 that answer within two of these are as stiff as 7 kN
// m/rad.
constexpr double kStep = 5e-4;
constexpr double kRest = 0.5;  // [s] before a run, in its first pose

mjModel* compile(const std::string& xml) {
  mjVFS files;
  mj_defaultVFS(&files);
  NAO_CHECK(mj_makeEmptyFileVFS(&files, "robot.xml", static_cast<int>(xml.size())) == 0);
  const int i = mj_findFileVFS(&files, "robot.xml");
  std::copy(xml.begin(), xml.end(), static_cast<char*>(files.filedata[i]));
  char error[500] = "";
  mjModel* model = mj_loadXML("robot.xml", &files, error, sizeof error);
  mj_deleteVFS(&files);
  if (!model) throw InputError(std::string("MuJoCo: ") + error);
  return model;
}

std::vector<Joint> writtenJoints(const RecordingPlan& plan) {
  std::vector<Joint> joints;
  for (std::size_t j = 0; j < plan.model->jointCount(); ++j) {
    const Actuator& motor = plan.model->actuators[j];
    const auto& asked = plan.joints;
    if (motor.coordinates.empty()) continue;
    if (!asked.empty() && std::find(asked.begin(), asked.end(), motor.name) == asked.end()) {
      continue;
    }
    joints.push_back(toJoint(j));
  }
  return joints;
}

class Reality {
 public:
  explicit Reality(const RecordingPlan& plan)
      : plan_(plan),
        robot_(makeMujocoRobot(*plan.model, plan.extra)),
        written_(writtenJoints(plan)),
        model_(compile(writeMjcf(robot_, written_, kStep))),
        data_(mj_makeData(model_)) {
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      if (robot_.joints[j].coordinates.empty()) continue;
      const int c = robot_.joints[j].coordinates.front();
      places_.push_back({j, find("rotor" + std::to_string(c)), find("play" + std::to_string(c))});
    }
  }
  ~Reality() {
    mj_deleteData(data_);
    mj_deleteModel(model_);
  }
  Reality(const Reality&) = delete;
  Reality& operator=(const Reality&) = delete;

  LogRun record(const RecordedMotion& motion, int repeat) {
    LogRun run;
    const std::string name = motion.name + "_" + std::to_string(repeat);
    run.file = "run_" + name + ".csv";
    run.motion = motion.name;
    run.repeat = repeat;
    run.robot_id = plan_.model->name;
    run.split = motion.split;
    run.start_pose = motion.start_pose.empty() ? plan_.model->start_posture : motion.start_pose;
    Random random(plan_.seed, "mujoco/" + name);
    const double late = plan_.start_sd * random.normal();
    reset(motion.angles(0), random);
    play(motion, late, run);
    return run;
  }

 private:
  struct Place {  // of a motor
    std::size_t joint;
    int rotor, play;  // of its hinges in MuJoCo's vectors; play: -1 if there is none
  };

  int find(const std::string& hinge) const {
    const int id = mj_name2id(model_, mjOBJ_JOINT, hinge.c_str());
    return id < 0 ? -1 : model_->jnt_dofadr[id];  // hinges alone: the same in q and in its rate
  }

  void reset(const JointArray<double>& pose, Random& random) {
    mj_resetData(model_, data_);
    motors_.clear();
    for (const Place& place : places_) {
      const auto seed = static_cast<std::uint64_t>(random.uniform() * 1e15);
      motors_.emplace_back(robot_.joints[place.joint], kStep, Random(seed, "torque"));
      motors_.back().reset(pose[place.joint]);
      for (const int c : robot_.joints[place.joint].coordinates) {
        data_->qpos[find("rotor" + std::to_string(c))] = pose[place.joint];
      }
    }
  }

  void observe() {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      motors_[i].observe(data_->qpos[places_[i].rotor]);
    }
  }

  void step() {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Place& place = places_[i];
      const double rotor = data_->qpos[place.rotor];
      const double play = place.play < 0 ? 0 : data_->qpos[place.play];
      const auto torques = motors_[i].step(data_->qvel[place.rotor], rotor + play);
      data_->qfrc_applied[place.rotor] = torques.rotor + torques.link;
      if (place.play >= 0) data_->qfrc_applied[place.play] = torques.link;
    }
    mj_step(model_, data_);
  }

  void send(const RecordedMotion& motion, long row) {
    const double t = static_cast<double>(std::max(0L, row)) * toSeconds(plan_.model->cycle);
    const JointArray<double> orders = motion.angles(t);
    for (std::size_t i = 0; i < places_.size(); ++i) motors_[i].order(orders[places_[i].joint]);
  }

  // At each row angles are read first, then its orders are sent; they are late by `late`.
  void play(const RecordedMotion& motion, double late, LogRun& run) {
    const double row = toSeconds(plan_.model->cycle);
    const long row_steps = std::lround(row / kStep);
    const long late_steps = std::lround(late / kStep);
    const long rest = std::lround(kRest / row);
    const long rows = std::lround(motion.duration / row) + 1;
    long sent = -rest;
    for (long k = -rest * row_steps; k <= (rows - 1) * row_steps; ++k) {
      observe();
      if (k % row_steps == 0 && k >= 0) write(motion, k / row_steps, run);
      for (; sent * row_steps + late_steps <= k && sent < rows; ++sent) send(motion, sent);
      step();
    }
  }

  void write(const RecordedMotion& motion, long row, LogRun& run) const {
    const double t = static_cast<double>(row) * toSeconds(plan_.model->cycle);
    const JointArray<double> orders = motion.angles(t);
    run.t.push_back(t);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Joint joint = toJoint(places_[i].joint);
      if (std::find(written_.begin(), written_.end(), joint) == written_.end()) continue;
      const std::string& name = plan_.model->actuators[places_[i].joint].name;
      run.columns["cmd." + name].push_back(orders[joint]);
      run.columns["q." + name].push_back(motors_[i].report());
    }
  }

  const RecordingPlan& plan_;
  MujocoRobot robot_;
  std::vector<Joint> written_;
  mjModel* model_;
  mjData* data_;
  std::vector<Place> places_;
  std::vector<MujocoMotor> motors_;  // by place
};

}  // namespace

bool hasMujoco() { return true; }

LogSet recordMujoco(const RecordingPlan& plan) {
  LogSet set;
  set.name = plan.name;
  set.source = "simulated";
  set.licence = "as the project";
  set.robot = plan.model->name;
  set.version = plan.model->version;
  set.environment.suspended = true;
  set.clock = {"simulated", "issued", "measured"};
  set.rate = 1 / toSeconds(plan.model->cycle);
  for (const Joint joint : writtenJoints(plan)) {
    validation::LogJoint one;
    one.name = plan.model->actuators[index(joint)].name;
    set.joints.push_back(one);
  }
  Reality reality(plan);
  for (const RecordedMotion& motion : plan.motions) {
    for (int repeat = 0; repeat < plan.repeats; ++repeat) {
      set.runs.push_back(reality.record(motion, repeat));
    }
  }
  return set;
}

}  // namespace nao::hidden

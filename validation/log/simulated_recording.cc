#include "validation/log/simulated_recording.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "core/world_model.h"
#include "validation/log/simulated_rows.h"
#include "validation/log/standard_motions.h"

namespace nao::validation {
namespace {

constexpr double kRest = 0.5;  // [s] before a run: ten times what a Nao's joint takes to settle

class Recorder {
 public:
  Recorder(const RecordingPlan& plan, std::shared_ptr<const RobotModel> robot,
           std::vector<std::size_t> written)
      : plan_(plan), robot_(std::move(robot)), written_(std::move(written)) {}

  LogRun record(const RecordedMotion& motion, int repeat) {
    if (repeat == 0) tabulate(motion);
    const std::string name = motion.name + "_" + std::to_string(repeat);
    Random random(plan_.seed, "run/" + name);
    LogRun run;
    run.file = "run_" + name + ".csv";
    run.motion = motion.name;
    run.repeat = repeat;
    run.robot_id = robot_->name;
    run.split = motion.split;
    run.start_pose = motion.start_pose.empty() ? robot_->start_posture : motion.start_pose;
    sim::World world = makeWorld(random);
    world.placeRobot(0, {}, &orders_.front());
    play(plan_.start_sd * random.normal(), world, run);
    return run;
  }

 private:
  // The same for all repeats.
  void tabulate(const RecordedMotion& motion) {
    orders_.clear();
    const double row = toSeconds(robot_->cycle);
    const long rows = std::lround(motion.duration / row) + 1;
    for (long k = 0; k < rows; ++k) orders_.push_back(motion.angles(static_cast<double>(k) * row));
  }

  sim::World makeWorld(Random& random) const {
    sim::WorldOptions options(plan_.step);
    options.mode = plan_.mode;
    options.any_step = true;
    options.effects = plan_.effects;
    options.seed = 1 + static_cast<std::uint64_t>(random.uniform() * 1e15);
    return sim::World(std::make_shared<WorldModel>(), {{robot_->name, robot_, {}}}, options);
  }

  // Orders of row k act from the step nearest to `late` after the row.
  void play(double late, sim::World& world, LogRun& run) const {
    const double row = toSeconds(robot_->cycle);
    const long row_steps = robot_->cycle / plan_.step;
    const long late_steps = std::lround(late / toSeconds(plan_.step));
    const long rest = std::lround(kRest / row);
    const auto rows = static_cast<long>(orders_.size());
    long sent = -rest;
    const auto send = [&](long k) {
      world.setCommand(0, {orders_[static_cast<std::size_t>(std::max(0L, k))],
                           JointArray<double>(robot_->jointCount(), 1.0)});
    };
    send(sent++);
    for (long step = -rest * row_steps; step <= (rows - 1) * row_steps; ++step) {
      if (step % row_steps == 0) {
        const SensorFrame frame = world.readSensors(0);
        if (step >= 0) write(frame, step / row_steps, run);
      }
      for (; sent * row_steps + late_steps <= step && sent < rows; ++sent) send(sent);
      world.step();
    }
  }

  void write(const SensorFrame& frame, long row, LogRun& run) const {
    run.t.push_back(static_cast<double>(row) * toSeconds(robot_->cycle));
    const JointArray<double>& command = orders_[static_cast<std::size_t>(row)];
    for (const std::size_t j : written_) {
      const std::string& name = robot_->actuators[j].name;
      run.columns["cmd." + name].push_back(command[j]);
      run.columns["q." + name].push_back(frame.angle[j]);
      if (plan_.current) run.columns["cur." + name].push_back(frame.current[j]);
    }
    if (plan_.inertial_unit) writeInertia(frame, run);
  }

  static void writeInertia(const SensorFrame& frame, LogRun& run) {
    const char* const axes[] = {"x", "y", "z"};
    const double angles[] = {frame.angle_x, frame.angle_y, frame.angle_z};
    for (int i = 0; i < 3; ++i) {
      run.columns[std::string("imu.acc.") + axes[i]].push_back(frame.accelerometer[i]);
      run.columns[std::string("imu.gyr.") + axes[i]].push_back(frame.gyroscope[i]);
      run.columns[std::string("imu.ang.") + axes[i]].push_back(angles[i]);
    }
  }

  const RecordingPlan& plan_;
  std::shared_ptr<const RobotModel> robot_;
  std::vector<std::size_t> written_;
  std::vector<JointArray<double>> orders_;  // of the motion at hand, by row
};

std::vector<std::size_t> writtenJoints(const RecordingPlan& plan) {
  std::vector<std::size_t> written;
  for (std::size_t j = 0; j < plan.model->jointCount(); ++j) {
    const Actuator& motor = plan.model->actuators[j];
    const bool asked = plan.joints.empty() || std::find(plan.joints.begin(), plan.joints.end(),
                                                        motor.name) != plan.joints.end();
    if (asked && !motor.coordinates.empty()) written.push_back(j);
  }
  return written;
}

}  // namespace

std::vector<RecordedMotion> standardRecording(const std::shared_ptr<const RobotModel>& model) {
  std::vector<RecordedMotion> motions;
  for (std::size_t m = 0; m < standardMotions().size(); ++m) {
    const StandardMotion& standard = standardMotions()[m];
    motions.push_back({standard.name, standard.split, kStandardMotionTime,
                       [model, m](double t) { return standardAngles(*model, m, t); },
                       kStandardRestPose});
  }
  return motions;
}

void moveOnly(const std::vector<std::string>& joints,
              const std::shared_ptr<const RobotModel>& model,
              std::vector<RecordedMotion>& motions) {
  std::vector<Joint> moving;
  for (const std::string& name : joints) {
    const auto joint = model->findJoint(name);
    if (!joint) throw InputError(model->name + " has no joint " + name);
    moving.push_back(*joint);
  }
  for (RecordedMotion& motion : motions) {
    motion.angles = [model, moving, all = std::move(motion.angles)](double t) {
      const JointArray<double> wanted = all(t);
      JointArray<double> angle = standardRest(*model);
      for (const Joint joint : moving) angle[joint] = wanted[joint];
      for (const CoupledLimit& limit : model->coupled_limits) {
        if (std::find(moving.begin(), moving.end(), limit.limited) == moving.end()) continue;
        const auto [low, high] = limit.rangeAt(angle[limit.driver]);
        angle[limit.limited] = std::clamp(angle[limit.limited], low, high);
      }
      return angle;
    };
    motion.start_pose = kStandardRestPose;
  }
}

LogSet recordSimulated(const RecordingPlan& plan) {
  const auto robot = withEffects(*plan.model, plan.extra, plan.effects);
  LogSet set;
  set.name = plan.name;
  set.source = "simulated";
  set.licence = "as the project";
  set.robot = plan.model->name;
  set.version = plan.model->version;
  set.environment.suspended = plan.model->fixed_base;
  set.clock = {"simulated", "issued", "measured"};
  set.rate = 1 / toSeconds(plan.model->cycle);
  const std::vector<std::size_t> written = writtenJoints(plan);
  for (const std::size_t j : written) {
    LogJoint joint;
    joint.name = robot->actuators[j].name;
    set.joints.push_back(joint);
  }
  Recorder recorder(plan, robot, written);
  for (const RecordedMotion& motion : plan.motions) {
    for (int repeat = 0; repeat < plan.repeats; ++repeat) {
      set.runs.push_back(recorder.record(motion, repeat));
    }
  }
  return set;
}

}  // namespace nao::validation

// Thesis section 5.3.1, figures 16 to 21, and 5.3.2, figure 22: a kick, a slow dance on one leg and
// a single step, repeated. How well do the joints follow, how alike are the runs, does the robot
// stay on its feet? Then the ankle: its roll can not go as far as it is told where its pitch leaves
// no room, which the thesis' simulator ignored.
#include <cmath>

#include "motion/timeline/motion_file.h"
#include "motion/trajectory.h"
#include "validation/motion_trial.h"
#include "validation/trial.h"

namespace nao::validation {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kRest = 1.0;        // [s] watched after the motion has ended
constexpr std::size_t kCurves = 10;  // runs that are drawn, as many as the thesis had

/// What is repeated, and what is shown of it.
struct Subject {
  const char* name;
  const char* title;
  motion::MotionAction action;
  double seconds = 0;
  std::vector<std::string> shown;  // joints
  std::optional<Foot> foot{};      // that steps, in a step
};

/// One roll command on the right ankle while that foot is in the air.
struct AnkleTest {
  double begin, look, end;  // [s] in the motion
  double command_deg;
};

/// What came of it [deg].
struct AnkleResult {
  double pitch = 0;  // commanded
  double lower = 0;  // of the table, there
  double upper = 0;
  double command = 0;  // after clipping
  double sensor = 0;
  double hinge = 0;
  double stop = 0;  // the upper limit where the limb's own pitch is
};

Joint jointOf(const RobotModel& model, const std::string& name) {
  const auto joint = model.findJoint(name);
  if (!joint) throw InputError("robot " + model.name + ": expected a joint " + name);
  return *joint;
}

motion::Timeline loadShipped(const ExperimentSettings& settings, const std::string& file,
                             const RobotModel& model) {
  return motion::loadMotion(settings.motions_dir + "/" + file, model);
}

/// The same subject again and again.
class Repetition {
 public:
  Repetition(const ExperimentSettings& settings, Subject subject)
      : settings_(settings),
        subject_(std::move(subject)),
        model_(loadRobot(settings)),
        tracking_(model_->jointCount()) {
    const auto spread = withSpread(*model_, {});
    for (int i = 0; i < settings.runs; ++i) {
      add(runMotion(settings, spread, seedOf(settings, i), subject_.action, subject_.seconds));
    }
  }

  Outcome take() {
    Outcome outcome;
    fillReport(outcome.report);
    outcome.picture = plot();
    return outcome;
  }

 private:
  void add(MotionRecord record) {
    if (record.fell) ++falls_;
    tilts_.push_back(record.max_tilt / kDegree);
    const Pose2 moved = relativeTo(record.start, record.end);
    distances_.push_back(std::hypot(moved.x, moved.y));
    forward_.push_back(moved.x);
    if (subject_.foot) {
      const std::size_t foot = *subject_.foot == Foot::Left ? 0 : 1;
      steps_.push_back(record.foot_moved.at(foot));
      stance_moved_.push_back(std::abs(record.foot_moved.at(1 - foot)));
    }
    hash_ = combineHash(hash_, record.hash);
    tracking_.add(record);
    if (draw_.empty()) draw_ = record.draw;
    if (drawn_.size() < kCurves) drawn_.push_back(std::move(record));
  }

  void fillReport(Report& report) const {
    report = startReport(subject_.name, settings_);
    report.hash = hash_;
    report.draw = draw_;
    const std::vector<double> rms = tracking_.calcRms();
    const std::vector<double> sd = tracking_.calcSd();
    TextTable table{std::string(subject_.title) + ", " + std::to_string(settings_.runs) +
                        " runs: sensor against command, and how alike the runs were",
                    {"joint", "rms [deg]", "sd [deg]"},
                    {}};
    Row rms_row;
    Row sd_row;
    for (std::size_t j = 0; j < model_->jointCount(); ++j) {
      const std::string& joint = model_->actuators[j].name;
      rms_row.emplace_back(joint, rms[j]);
      sd_row.emplace_back(joint, sd[j]);
      table.lines.push_back({joint, fixed(rms[j], 2), fixed(sd[j], 2)});
    }
    report.figures = {
        {"falls", static_cast<double>(falls_)},   {"runs", static_cast<double>(settings_.runs)},
        {"rms_tracking_deg", std::move(rms_row)}, {"sd_deg", std::move(sd_row)},
        {"max_tilt_deg", calcStatistics(tilts_)}, {"forward_distance_m", calcStatistics(forward_)},
        {"moved_m", calcStatistics(distances_)}};
    report.tables.push_back(std::move(table));
    if (subject_.foot) addStep(report);
    report.remarks.push_back("Falls: " + std::to_string(falls_) + " of " +
                             std::to_string(settings_.runs) + ".");
  }

  void addStep(Report& report) const {
    const Statistics step = calcStatistics(steps_);
    const Statistics stance = calcStatistics(stance_moved_);
    report.figures.push_back({"step_m", step});
    report.figures.push_back({"stance_foot_moved_m", stance});
    report.remarks.push_back(std::string(subject_.title) + ": the foot went " +
                             fixed(step.mean, 4) + " m forward (sd " + fixed(step.sd, 4) +
                             "), the other one " + fixed(stance.mean, 4) + " m.");
  }

  Picture plot() const {
    Picture picture;
    picture.title = subject_.title;
    for (const std::string& name : subject_.shown) {
      Panel panel = makePanel(name, "time [s]", name + " [deg]");
      const Joint joint = jointOf(*model_, name);
      for (const MotionRecord& run : drawn_) {
        panel.series.push_back(curveOf(run.t, run.sensor, joint, Ink::Vermilion));
      }
      panel.series.front().label = "sensor, " + std::to_string(drawn_.size()) + " runs";
      panel.series.push_back(curveOf(drawn_[0].t, drawn_[0].command, joint, Ink::Sky));
      panel.series.back().label = "command";
      picture.panels.push_back(std::move(panel));
    }
    picture.height = 300 * static_cast<int>(subject_.shown.size());
    return picture;
  }

  static Series curveOf(const std::vector<double>& t, const std::vector<JointArray<double>>& angles,
                        Joint joint, Ink ink) {
    Series series;
    series.x = t;
    series.ink = ink;
    for (const JointArray<double>& angle : angles) series.y.push_back(angle[joint] / kDegree);
    return series;
  }

  ExperimentSettings settings_;
  Subject subject_;
  std::shared_ptr<const RobotModel> model_;
  Tracking tracking_;
  std::vector<MotionRecord> drawn_;
  std::vector<double> tilts_, distances_, forward_;
  std::vector<double> steps_, stance_moved_;  // [m] of either foot, in a step
  int falls_ = 0;
  std::uint64_t hash_ = 0;
  std::map<std::string, double> draw_;
};

// The keys of RAnkleRoll within the test give way to the command.
motion::Timeline withRollCommand(motion::Timeline timeline, Joint roll, const AnkleTest& test) {
  for (motion::Curve& curve : timeline.curves) {
    if (curve.joint != roll) continue;
    std::vector<motion::Key> keys;
    const auto hold = [&](double time) {
      motion::Key key;
      key.time = time;
      key.angle = test.command_deg * kDegree;
      keys.push_back(key);
    };
    for (const motion::Key& key : curve.keys) {
      if (key.time < test.begin) keys.push_back(key);
    }
    hold(test.begin + 0.4);  // [s] slow enough not to shake the robot
    hold(test.end);
    for (const motion::Key& key : curve.keys) {
      if (key.time > test.end + 0.4) keys.push_back(key);
    }
    motion::setAutoHandles(0, keys);
    curve.keys = std::move(keys);
  }
  return timeline;
}

// Without the clipping of commands only the joint's mechanical stop is left.
std::shared_ptr<const RobotModel> withoutClipping(const RobotModel& model) {
  auto copy = std::make_shared<RobotModel>(model);
  for (CoupledLimit& limit : copy->coupled_limits) limit.clip = false;
  return copy;
}

AnkleResult testAnkle(const ExperimentSettings& settings,
                      const std::shared_ptr<const RobotModel>& model,
                      const motion::Timeline& timeline, const AnkleTest& test) {
  const Joint roll = jointOf(*model, "RAnkleRoll");
  const Joint pitch = jointOf(*model, "RAnklePitch");
  const motion::Timeline changed = withRollCommand(timeline, roll, test);
  const MotionRecord record = runMotion(settings, model, 0, playing(changed), test.look);
  AnkleResult result;
  result.pitch = record.command.back()[pitch] / kDegree;
  result.command = record.command.back()[roll] / kDegree;
  result.sensor = record.sensor.back()[roll] / kDegree;
  result.hinge = record.hinge.back()[roll] / kDegree;
  for (const CoupledLimit& limit : model->coupled_limits) {
    if (limit.limited != roll) continue;
    const auto [low, high] = limit.rangeAt(record.command.back()[pitch]);
    result.lower = low / kDegree;
    result.upper = high / kDegree;
    result.stop = limit.rangeAt(record.hinge.back()[pitch]).second / kDegree;
  }
  return result;
}

void addLine(TextTable& table, const std::string& what, double told, const AnkleResult& r) {
  table.lines.push_back({what, fixed(told, 0), fixed(r.pitch, 1), fixed(r.lower, 2),
                         fixed(r.upper, 2), fixed(r.command, 2), fixed(r.sensor, 2),
                         fixed(r.hinge, 2), fixed(r.stop, 2)});
}

// Up and down with commands clipped as NAOqi does, and up against the stop alone.
void addAnkle(const ExperimentSettings& settings, const motion::Timeline& timeline,
              const AnkleTest& test, Report& report) {
  const auto model = loadRobot(settings);
  AnkleTest down = test;
  down.command_deg = -test.command_deg;
  const AnkleResult up = testAnkle(settings, model, timeline, test);
  const AnkleResult low = testAnkle(settings, model, timeline, down);
  const AnkleResult stop = testAnkle(settings, withoutClipping(*model), timeline, test);
  TextTable table{
      "Right ankle in the air, told to roll further than its pitch allows [deg]",
      {"", "told", "pitch", "table min", "table max", "command", "sensor", "hinge", "at its pitch"},
      {}};
  addLine(table, "commands clipped", test.command_deg, up);
  addLine(table, "commands clipped", down.command_deg, low);
  addLine(table, "stop alone", test.command_deg, stop);
  report.tables.push_back(std::move(table));
  report.figures.push_back({"ankle_roll_at_limit_deg", up.sensor});
  report.figures.push_back({"ankle_roll_at_lower_limit_deg", low.sensor});
  report.figures.push_back({"ankle_roll_at_limit_hinge_deg", up.hinge});
  report.figures.push_back({"ankle_roll_at_lower_limit_hinge_deg", low.hinge});
  report.figures.push_back({"ankle_roll_at_stop_deg", stop.hinge});
  report.figures.push_back({"ankle_roll_stop_table_max_deg", stop.stop});
  report.figures.push_back({"ankle_roll_table_max_deg", up.upper});
  report.figures.push_back({"ankle_roll_table_min_deg", low.lower});
  report.figures.push_back({"ankle_pitch_at_limit_deg", up.pitch});
}

Outcome repeatFile(const ExperimentSettings& settings, Subject subject, const std::string& file,
                   const std::optional<AnkleTest>& test) {
  const motion::Timeline timeline = loadShipped(settings, file, *loadRobot(settings));
  subject.action = playing(timeline);
  subject.seconds = timeline.length + kRest;
  Outcome outcome = Repetition(settings, std::move(subject)).take();
  if (test) addAnkle(settings, timeline, *test, outcome.report);
  return outcome;
}

Outcome repeatKick(const ExperimentSettings& settings, const std::string& side) {
  Subject kick{"kick",
               side == "R" ? "Kick with the right foot" : "Kick with the left foot",
               {},
               0,
               {side + "KneePitch", side + "AnklePitch", side + "AnkleRoll"}};
  // At the end of the back swing the ankle's pitch is -60 degrees.
  if (side == "R")
    return repeatFile(settings, kick, "kick_right.xar", AnkleTest{2.6, 3.6, 3.7, 10});
  return repeatFile(settings, kick, "kick_left.xar", {});
}

// The thesis has the right foot; of the left one only falls are told.
Outcome runKick(const ExperimentSettings& settings) {
  Outcome right = repeatKick(settings, "R");
  const Report left = repeatKick(settings, "L").report;
  for (const Figure& figure : left.figures) {
    if (figure.name == "falls") right.report.figures.push_back({"left_foot_falls", figure.value});
  }
  right.report.remarks.push_back("With the left foot: " + left.remarks.back());
  right.report.hash = combineHash(right.report.hash, left.hash);
  return right;
}

Outcome runTaichi(const ExperimentSettings& settings) {
  Subject dance{"taichi",
                "Balance on one leg, both sides",
                {},
                0,
                {"LHipRoll", "RHipRoll", "LHipYawPitch", "RAnkleRoll"}};
  // While the right leg is held to the side; the thesis' dance tells its ankle 45 degrees.
  return repeatFile(settings, std::move(dance), "balance.xar", AnkleTest{14.1, 15.2, 15.3, 45});
}

// One full step of the default gait with one leg; the other foot stays.
Outcome repeatStep(const ExperimentSettings& settings, Foot foot) {
  constexpr double kStep = 0.04;    // [m] the default gait's longest
  constexpr double kBeside = 0.10;  // [m] between the feet of a standing Nao
  constexpr double kPeriod = 0.42;  // [s] of a step at full frequency
  constexpr double kSeconds = 3.0;  // [s] from standing to standing
  const bool left = foot == Foot::Left;
  motion::WalkSteps steps;
  steps.steps = {{foot, {kStep, left ? kBeside : -kBeside, 0}, kPeriod}};
  const std::string side = left ? "L" : "R";
  Subject subject{"singlestep",
                  left ? "A single step with the left leg" : "A single step with the right leg",
                  std::move(steps),
                  kSeconds,
                  {side + "KneePitch", side + "HipRoll", side + "AnkleRoll"},
                  foot};
  return Repetition(settings, std::move(subject)).take();
}

// The thesis has the left leg; what the right one does stands in figures of its own.
Outcome runSinglestep(const ExperimentSettings& settings) {
  Outcome left = repeatStep(settings, Foot::Left);
  Outcome right = repeatStep(settings, Foot::Right);
  for (Figure& figure : right.report.figures) {
    left.report.figures.push_back({"right_leg_" + figure.name, std::move(figure.value)});
  }
  for (TextTable& table : right.report.tables) left.report.tables.push_back(std::move(table));
  for (std::string& remark : right.report.remarks) left.report.remarks.push_back(std::move(remark));
  for (Panel& panel : right.picture.panels) left.picture.panels.push_back(std::move(panel));
  left.picture.height += right.picture.height;
  left.picture.title = "A single step with the left leg, and one with the right";
  left.report.hash = combineHash(left.report.hash, right.report.hash);
  return left;
}

}  // namespace

Experiment kickExperiment() {
  return makeTrialExperiment(
      "kick", "A kick with either foot: balance, joints, ankle (thesis figure 16).", runKick);
}

Experiment taichiExperiment() {
  return makeTrialExperiment(
      "taichi", "A slow dance on one leg, on both sides (thesis figures 19 to 21).", runTaichi);
}

Experiment singlestepExperiment() {
  return makeTrialExperiment("singlestep",
                             "One step of the walk engine, with each leg (thesis figure 22).",
                             runSinglestep);
}

}  // namespace nao::validation

#include "validation/diagnosis/extend/next_experiment.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "core/config.h"
#include "validation/diagnosis/extend/next_whole_experiment.h"
#include "validation/diagnosis/jobs/team.h"
#include "validation/diagnosis/joint/prepared_set.h"
#include "validation/diagnosis/replay/replay.h"
#include "validation/diagnosis/report/report_file.h"
#include "validation/suspended.h"

namespace nao::validation {
namespace {

constexpr double kDuration = 6;   // [s] as the standard motions
constexpr double kMargin = 0.05;  // [rad] from the ends of the range
constexpr int kRuns = 8;          // simulated per cause and motion
constexpr double kTold = 3;       // [SD of the mean] apart
constexpr double kPose = 0.04;    // [s] between the poses of a file

double triangle(double phase) { return 2 / M_PI * std::asin(std::sin(phase)); }

// Of a joint: from the middle of its range by `reach` [rad] to each side.
struct Way {
  double middle = 0, reach = 0;
};

Way wayOf(const RobotModel& model, Joint joint) {
  const Actuator& actuator = model.actuators[index(joint)];
  const Posture* rest = model.findPosture(model.start_posture);
  const double most = (actuator.upper - actuator.lower) / 2 - kMargin;
  Way way{(actuator.lower + actuator.upper) / 2, std::clamp(most, 0.05, 1.2)};
  if (rest == nullptr) return way;
  way.middle = std::clamp(
      rest->angle[joint], actuator.lower + way.reach + kMargin,
      std::max(actuator.lower + way.reach + kMargin, actuator.upper - way.reach - kMargin));
  return way;
}

double separationOf(const JointSimulator& joint, std::size_t motion, const JointNoise& noise,
                    const Ambiguity& ambiguous, int repeats) {
  std::vector<RunSpread> spreads;
  for (const EffectSetting& setting : ambiguous.settings) {
    std::vector<Eigen::MatrixXd> runs;
    for (int r = 0; r < kRuns; ++r) {
      runs.push_back(joint.run({setting}, motion, static_cast<std::uint64_t>(r) + 1, noise));
    }
    spreads.push_back(spreadOf(runs, 0));
  }
  double least = 1e9;
  for (std::size_t a = 0; a < spreads.size(); ++a) {
    for (std::size_t b = a + 1; b < spreads.size(); ++b) {
      const double square = (spreads[a].mean - spreads[b].mean).squaredNorm();
      const double variance = (spreads[a].variance + spreads[b].variance).sum() / 2 / repeats;
      least = std::min(least, std::sqrt(square / std::max(variance, 1e-12)));
    }
  }
  return least;
}

}  // namespace

std::vector<RecordedMotion> candidateMotions(const std::shared_ptr<const RobotModel>& model,
                                             Joint joint) {
  const Way way = wayOf(*model, joint);
  const double top = model->actuators[index(joint)].max_velocity;
  const auto motion = [&](const std::string& name, std::function<double(double)> part) {
    return RecordedMotion{
        name, Split::Fit, kDuration, [model, joint, way, part](double t) {
          const Posture* rest = model->findPosture(model->start_posture);
          JointArray<double> angle =
              rest != nullptr ? rest->angle : JointArray<double>(model->jointCount());
          angle[joint] = way.middle + way.reach * part(std::clamp(t, 0.0, kDuration));
          return angle;
        }};
  };
  // Of a sine that stays below 70 % of the top speed.
  const double fast = std::min(2 * M_PI * 3, 0.7 * top / std::max(way.reach, 0.05));
  return {
      motion("slow triangle, large", [](double t) { return triangle(2 * M_PI * t / 6); }),
      motion("slow triangle, small", [](double t) { return 0.15 * triangle(2 * M_PI * t / 6); }),
      motion("fast sine, large", [fast](double t) { return std::sin(fast * t); }),
      motion("fast sine, small", [fast](double t) { return 0.2 * std::sin(2 * fast * t); }),
      motion("sweep", [fast](double t) { return 0.6 * std::sin(fast * t * t / kDuration); }),
      motion("two amplitudes",
             [](double t) { return (t < 3 ? 0.2 : 0.9) * std::sin(2 * M_PI * t / 1.5); }),
      motion("stairs with holds",
             [](double t) {
               const double steps[] = {0, 0.5, 1, 0.5, 0, -0.5, -1, -0.5};
               const double place = std::fmod(t / 0.75, 8), part = place - std::floor(place);
               const auto i = static_cast<std::size_t>(place);
               return steps[i] + (steps[(i + 1) % 8] - steps[i]) * std::min(1.0, 4 * part);
             }),
  };
}

std::vector<PlannedMotion> planExperiments(const std::shared_ptr<const RobotModel>& model,
                                           const Ambiguity& ambiguous, int repeats, int jobs) {
  if (ambiguous.level != "joint") return planWholeExperiments(model, ambiguous, repeats, jobs);
  const auto hung =
      std::make_shared<RobotModel>(stripped(model->fixed_base ? *model : suspend(*model)));
  RecordingPlan plan;
  plan.model = hung;
  const Joint joint = *model->findJoint(ReportedPlace(ambiguous.place).name);
  plan.motions = candidateMotions(model, joint);
  plan.repeats = 1;
  plan.step = std::chrono::milliseconds(1);
  const LogSet set = recordSimulated(plan);
  const auto rigs = std::make_shared<RigSet>(set, hung);
  const RigSimulator simulator(rigs, joint);
  const JointNoise noise = nominalNoise(rigs->model(), joint);
  std::vector<PlannedMotion> experiments(plan.motions.size());
  inParallel(experiments.size(), jobs, [&](std::size_t m) {
    experiments[m] = {plan.motions[m], separationOf(simulator, m, noise, ambiguous, repeats)};
  });
  std::stable_sort(experiments.begin(), experiments.end(), separatesMore);
  return experiments;
}

Report reportPlan(const Ambiguity& ambiguous, const std::vector<PlannedMotion>& experiments,
                  const RobotModel& model, int repeats) {
  Report report;
  report.command = "plan";
  report.robot = model.name;
  report.runs = repeats;
  std::string causes;
  for (const std::string& one : ambiguous.causes) causes += (causes.empty() ? "" : " or ") + one;
  TextTable table{ambiguous.place + ": " + causes, {"motion", "separation [SD of the mean]"}, {}};
  std::vector<Row> rows;
  for (const PlannedMotion& one : experiments) {
    rows.push_back({{"motion", one.motion.name}, {"separation_sd", one.separation}});
    table.lines.push_back({one.motion.name, fixed(one.separation, 2)});
  }
  report.figures = {{"rows", std::move(rows)},
                    {"separation_sd", experiments.empty() ? 0 : experiments.front().separation}};
  report.tables.push_back(std::move(table));
  report.remarks.push_back("Next: " + std::to_string(repeats) + " runs of '" +
                           experiments.front().motion.name + "'" +
                           (ambiguous.level == "joint" ? " with " + ambiguous.place : "") + ".");
  if (experiments.front().separation < kTold) {
    report.remarks.push_back("No motion here tells them apart by so few runs: that takes " +
                             fixed(kTold, 0) + " SD.");
  }
  if (!ambiguous.advice.empty()) {
    report.remarks.push_back("Beyond motions alone: " + ambiguous.advice + ".");
  }
  return report;
}

void writeMotion(const RecordedMotion& motion, const RobotModel& model, const std::string& file) {
  std::ofstream out(file);
  out << "#WEBOTS_MOTION,V1.0";
  for (const Actuator& actuator : model.actuators) {
    if (!actuator.coordinates.empty()) out << "," << actuator.name;
  }
  out << "\n";
  const auto poses = std::lround(motion.duration / kPose);
  for (long i = 0; i <= poses; ++i) {
    const long ms = std::lround(1e3 * kPose * static_cast<double>(i));
    char clock[64];
    std::snprintf(clock, sizeof clock, "%02ld:%02ld:%03ld,Pose%ld", ms / 60000, ms / 1000 % 60,
                  ms % 1000, i + 1);
    out << clock;
    const JointArray<double> angle = motion.angles(1e-3 * static_cast<double>(ms));
    for (std::size_t j = 0; j < model.jointCount(); ++j) {
      if (!model.actuators[j].coordinates.empty()) out << "," << angle[j];
    }
    out << "\n";
  }
  if (!out.flush()) throw InputError(file + ": can not be written");
}

}  // namespace nao::validation

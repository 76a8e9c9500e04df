#include "validation/diagnosis/report/diagnosis_plots.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "sim/effects/catalogue.h"
#include "validation/merge_effects.h"

namespace nao::validation {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr std::size_t kMostBars = 10;
constexpr Eigen::Index kEveryPoint = 3;  // of a cloud's

EffectSetting settingOf(const std::string& effect, const std::vector<FoundNumber>& numbers) {
  EffectSetting setting = neutralSetting(effect, sim::standardEffects());
  for (const FoundNumber& number : numbers) setting.parameters[number.parameter] = number.value;
  return setting;
}

EffectSetting settingOf(const Finding& finding) {
  return settingOf(finding.effect, finding.numbers);
}

// The rival of a finding that may stand in its place; null: none has a name, or all are elsewhere.
const Rival* rivalOf(const Finding& finding) {
  for (const Rival& rival : finding.rivals) {
    if (rival.hasName() && rival.place.empty()) return &rival;
  }
  return nullptr;
}

Series curve(const std::string& label, double dt, const Eigen::VectorXd& angle, Ink ink,
             Stroke stroke = Stroke::Line) {
  Series series{label, {}, {}, stroke, ink};
  for (Eigen::Index i = 0; i < angle.size(); ++i) {
    series.x.push_back(static_cast<double>(i) * dt);
    series.y.push_back(angle[i] / kDegree);
  }
  return series;
}

std::size_t worstMotion(const JointSimulator& joint, const ReplayedRuns& nominal) {
  std::size_t worst = nominal.noisy.size();
  double largest = -1;
  for (std::size_t m = 0; m < nominal.noisy.size(); ++m) {
    if (nominal.noisy[m].empty()) continue;
    const Eigen::VectorXd measured = spreadOf(joint.measured()[m].repeats, 0).mean;
    const double error = (measured - spreadOf(nominal.noisy[m], 0).mean).squaredNorm();
    if (error > largest) largest = error, worst = m;
  }
  NAO_CHECK(largest >= 0);
  return worst;
}

}  // namespace

std::vector<EffectSetting> foundEffects(const SetDiagnosis& diagnosis, const JointVerdict& joint,
                                        const std::vector<Joint>& place) {
  std::vector<EffectSetting> effects;
  for (const SharedFinding& one : diagnosis.shared) effects.push_back(settingOf(one.finding));
  for (const Finding& finding : joint.findings) {
    effects.push_back(settingOf(finding));
    effects.back().joints = place;
  }
  for (const Adjustment& one : joint.adjustments) {
    effects.push_back(settingOf(one.effect, {one.number}));
    effects.back().joints = place;
  }
  return effects;
}

std::pair<std::string, std::vector<EffectSetting>> rivalEffects(const SetDiagnosis& diagnosis,
                                                                const JointVerdict& joint,
                                                                const std::vector<Joint>& place) {
  std::vector<EffectSetting> effects = foundEffects(diagnosis, joint, place);
  for (std::size_t i = 0; i < joint.findings.size(); ++i) {
    const Rival* rival = rivalOf(joint.findings[i]);
    if (rival == nullptr) continue;
    EffectSetting& setting = effects[diagnosis.shared.size() + i];
    setting = settingOf(rival->effect, rival->numbers);
    setting.joints = place;
    return {rival->cause, effects};
  }
  return {};
}

void addRival(JointCourse& course, const JointTask& task, const std::string& rival,
              const std::vector<EffectSetting>& effects, int runs) {
  for (std::size_t m = 0; m < task.joint->measured().size(); ++m) {
    if (task.joint->measured()[m].motion != course.motion) continue;
    std::vector<Eigen::MatrixXd> all;
    for (int r = 0; r < runs; ++r) {
      const std::uint64_t stream = streamOf(StreamUse::Replay, m, r);
      all.push_back(task.joint->exact().run(effects, m, stream, task.noise));
    }
    course.rival = rival;
    course.with_rival = spreadOf(all, 0).mean;
  }
}

JointCourse worstCourse(const JointSimulator& joint, const ReplayedRuns& nominal,
                        const ReplayedRuns& extended) {
  const std::size_t at = worstMotion(joint, nominal);
  const JointMotion& motion = joint.measured()[at];
  const RunSpread measured = spreadOf(motion.repeats, 0);
  const RunSpread without = spreadOfPairs(nominal.noisy[at], 0);
  JointCourse course{motion.motion, motion.dt, measured.mean,
                     without.mean,  {},        measured.of_mean.cwiseSqrt()};
  course.extended = spreadOf(extended.noisy[at], 0).mean;
  if (motion.repeats.size() > 1) {
    course.measured_sd = measured.variance.cwiseSqrt();
    course.simulated_sd = without.variance.cwiseSqrt();
  }
  return course;
}

Picture drawCourse(const JointCourse& course) {
  Panel angle = makePanel("Motion " + course.motion, "time [s]", "angle [deg]");
  angle.key = "outside";
  angle.series = {curve("measured", course.dt, course.measured, Ink::Black),
                  curve("nominal model", course.dt, course.nominal, Ink::Orange, Stroke::Dashed),
                  curve("extended model", course.dt, course.extended, Ink::Blue)};
  Panel error = makePanel("Measured less simulated", "time [s]", "error [deg]");
  error.key = "outside";
  error.series = {curve("nominal model", course.dt, course.measured - course.nominal, Ink::Orange,
                        Stroke::Dashed),
                  curve("extended model", course.dt, course.measured - course.extended, Ink::Blue),
                  curve("noise of the mean, 2 SD", course.dt, 2 * course.floor, Ink::Thesis),
                  curve("", course.dt, -2 * course.floor, Ink::Thesis)};
  if (!course.rival.empty()) {
    error.series.push_back(curve("with " + course.rival + " instead", course.dt,
                                 course.measured - course.with_rival, Ink::Black, Stroke::Dashed));
  }
  if (course.measured_sd.size() == 0) return {"", {angle, error}, 1, 900, 520};
  Panel spread = makePanel("Spread of runs (SD)", "time [s]", "SD [deg]");
  spread.key = "outside";
  spread.series = {curve("measured", course.dt, course.measured_sd, Ink::Black),
                   curve("nominal model", course.dt, course.simulated_sd, Ink::Orange)};
  return {"", {angle, error, spread}, 1, 900, 780};
}

Picture drawSignature(const JointCourse& course) {
  const Eigen::Index n = course.measured.size();
  const Eigen::VectorXd speed =
      (course.measured.tail(n - 1) - course.measured.head(n - 1)) / course.dt;
  const auto cloud = [&](const std::string& label, const Eigen::VectorXd& at,
                         const Eigen::VectorXd& simulated, Ink ink) {
    Series series{label, {}, {}, Stroke::Points, ink};
    for (Eigen::Index i = 0; i < at.size(); i += kEveryPoint) {
      series.x.push_back(at[i] / kDegree);
      series.y.push_back((course.measured[i] - simulated[i]) / kDegree);
    }
    return series;
  };
  Panel by_speed = makePanel("Error by speed", "speed [deg/s]", "error [deg]");
  Panel by_angle = makePanel("Error by angle", "angle [deg]", "error [deg]");
  by_speed.key = by_angle.key = "outside";
  by_speed.series = {cloud("nominal model", speed, course.nominal, Ink::Orange),
                     cloud("extended model", speed, course.extended, Ink::Blue)};
  by_angle.series = {cloud("nominal model", course.measured, course.nominal, Ink::Orange),
                     cloud("extended model", course.measured, course.extended, Ink::Blue)};
  return {"", {by_speed, by_angle}, 2, 1200, 340};
}

Picture drawProfile(const Finding& finding) {
  const FoundNumber& number = finding.numbers.front();
  std::vector<ProfilePoint> points = finding.profile;
  points.push_back({number.deviation, 0});
  std::sort(points.begin(), points.end(),
            [](const ProfilePoint& a, const ProfilePoint& b) { return a.deviation < b.deviation; });
  Series curve{"by rough runs", {}, {}, Stroke::LinePoints, Ink::Blue};
  double most = 1;
  for (const ProfilePoint& point : points) {
    curve.x.push_back(point.deviation);
    curve.y.push_back(point.lost);
    most = std::max(most, point.lost);
  }
  const auto upright = [&](double x, const std::string& label) {
    return Series{label, {x, x}, {0, most}, Stroke::Dashed, Ink::Black};
  };
  const std::string unit = number.unit.empty() ? "of nominal" : number.unit;
  const std::string axis = number.form == Form::Inverse
                               ? "1 / " + number.parameter + " [1 / (" + unit + ")]"
                               : number.parameter + ", deviation [" + unit + "]";
  Panel panel =
      makePanel("How much worse other values fit: " + finding.cause, axis, "gain lost [nats]");
  panel.key = "outside";
  panel.series = {curve, upright(number.low, "90 % interval"), upright(number.high, "")};
  return {"", {panel}, 1, 900, 300};
}

Picture drawRanking(const JointVerdict& joint) {
  std::vector<std::pair<double, std::string>> gains;
  for (const Finding& finding : joint.findings) gains.push_back({finding.gain, finding.cause});
  for (const Rejected& one : joint.rejected) gains.push_back({one.gain, one.cause});
  std::stable_sort(gains.begin(), gains.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  if (gains.size() > kMostBars) gains.resize(kMostBars);
  Panel panel = makePanel("What each cause explains", "", "gain [nats]");
  Series bars{"", {}, {}, Stroke::Bars, Ink::Blue},
      line{"threshold", {}, {}, Stroke::Dashed, Ink::Black};
  for (std::size_t i = 0; i < gains.size(); ++i) {
    bars.x.push_back(static_cast<double>(i));
    bars.y.push_back(std::max(gains[i].first, 0.0));
    line.x.push_back(static_cast<double>(i));
    line.y.push_back(joint.critical_gain);
    panel.categories.push_back(gains[i].second);
  }
  panel.series = {bars, line};
  return {"", {panel}, 1, 900, 340};
}

}  // namespace nao::validation

#include "validation/diagnosis/diagnosis_plots.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "sim/effects/catalogue.h"
#include "validation/diagnosis/merge_effects.h"

namespace nao::validation {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr std::size_t kMostBars = 10;

EffectSetting settingOf(const Finding& finding) {
  EffectSetting setting = neutralSetting(finding.effect, sim::standardEffects());
  for (const FoundNumber& number : finding.numbers) {
    setting.parameters[number.parameter] = number.value;
  }
  return setting;
}

Eigen::VectorXd meanOf(const JointTask& task, const std::vector<EffectSetting>& causes,
                       std::size_t motion, int runs) {
  std::vector<Eigen::MatrixXd> all;
  for (int r = 0; r < runs; ++r) {
    all.push_back(task.joint->run(causes, motion, static_cast<std::uint64_t>(r) + 1, task.noise));
  }
  return spreadOf(all, 0).mean;
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

}  // namespace

std::vector<EffectSetting> foundEffects(const SetDiagnosis& diagnosis, const JointVerdict& joint,
                                        const std::vector<Joint>& place) {
  std::vector<EffectSetting> effects;
  for (const SharedFinding& one : diagnosis.shared) effects.push_back(settingOf(one.finding));
  for (const Finding& finding : joint.findings) {
    effects.push_back(settingOf(finding));
    effects.back().joints = place;
  }
  return effects;
}

JointCourse worstCourse(const JointTask& task, const std::vector<EffectSetting>& found, int runs) {
  JointCourse worst;
  double largest = -1;
  std::size_t at = 0;
  for (std::size_t m = 0; m < task.joint->measured().size(); ++m) {
    const JointMotion& motion = task.joint->measured()[m];
    if (motion.split == Split::Test) continue;
    const RunSpread measured = spreadOf(motion.repeats, 0);
    const Eigen::VectorXd nominal = meanOf(task, {}, m, runs);
    const double error = (measured.mean - nominal).squaredNorm();
    if (error <= largest) continue;
    largest = error;
    at = m;
    const auto repeats = static_cast<double>(motion.repeats.size());
    worst = {motion.motion, motion.dt, measured.mean,
             nominal,       {},        (measured.variance / repeats).cwiseSqrt()};
  }
  NAO_CHECK(largest >= 0);
  worst.extended = meanOf(task, found, at, runs);
  return worst;
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
  return {"", {angle, error}, 1, 900, 520};
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

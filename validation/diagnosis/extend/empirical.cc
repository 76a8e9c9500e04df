#include "validation/diagnosis/extend/empirical.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/config.h"
#include "validation/diagnosis/causes/causes.h"
#include "validation/diagnosis/folds/diagnose_folds.h"
#include "validation/diagnosis/folds/motion_fit.h"
#include "validation/diagnosis/joint/joint_search.h"
#include "validation/diagnosis/report/report_file.h"

namespace nao::validation {
namespace {

constexpr int kRuns = 8;         // simulated per motion, where there are repeats
constexpr double kAround = 0.6;  // [1/rad] that a ripple may be from the whole number it is told by
constexpr double kAroundHz = 0.1;
constexpr double kAroundSpot = 0.1;                    // [rad]
constexpr double kAroundBand = 0.3, kBandWidth = 0.3;  // of a speed

// "q sgn v (62 %), then v|v| (5 %)" -> "q sgn v", "v|v|"
std::vector<std::string> featuresIn(std::string text) {
  std::vector<std::string> features;
  for (std::size_t end; (end = text.find(" (")) != std::string::npos;) {
    features.push_back(text.substr(0, end));
    const std::size_t next = text.find(", then ", end);
    text = next == std::string::npos ? "" : text.substr(next + 7);
  }
  return features;
}

// "LHipRoll, torso roll" of a limb or a robot, each once.
void addSignals(const std::string& text, std::vector<UnknownJoint>& all) {
  std::stringstream words(text);
  for (std::string name; std::getline(words >> std::ws, name, ',');) {
    const bool known = std::any_of(all.begin(), all.end(),
                                   [&](const UnknownJoint& one) { return one.joint == name; });
    if (!known) all.push_back({name, {}});
  }
}

FreeNumber number(const std::string& parameter, double start, double around = 0) {
  FreeNumber free{parameter, {start}, Form::Offset, "", 0, 0, 0, 0};
  if (around > 0) free.lower = start - around, free.upper = start + around;
  return free;
}

// The numbers of the effect that stand for a feature; empty: it has none.
std::vector<FreeNumber> numbersFor(const std::string& feature, const sim::EffectType& type) {
  const auto neutralOf = [&](const char* name) {
    return std::find_if(type.parameters.begin(), type.parameters.end(),
                        [&](const sim::Parameter& p) { return p.name == name; })
        ->neutral;
  };
  double at = 0;
  const bool in_time = feature.find("Hz") != std::string::npos;
  if (in_time && std::sscanf(feature.c_str(), "sin and cos of %lf Hz", &at) == 1) {
    return {number("hum_sin", 0), number("hum_cos", 0),
            number("hum", at - neutralOf("hum"), kAroundHz)};
  }
  if (in_time && std::sscanf(feature.c_str(), "sgn v with sin and cos of %lf Hz", &at) == 1) {
    return {number("sign", 0), number("sign_hum_sin", 0), number("sign_hum_cos", 0),
            number("hum", at - neutralOf("hum"), kAroundHz)};
  }
  if (std::sscanf(feature.c_str(), "sgn v with sin and cos of %lf q", &at) == 1) {
    return {number("sign", 0), number("sign_sin", 0), number("sign_cos", 0),
            number("ripple", at - neutralOf("ripple"), kAround)};
  }
  if (std::sscanf(feature.c_str(), "sgn v near q = %lf", &at) == 1) {
    return {number("spot", 0), number("spot_angle", at - neutralOf("spot_angle"), kAroundSpot),
            number("spot_width", 0)};
  }
  if (std::sscanf(feature.c_str(), "sgn v near |v| = %lf", &at) == 1) {
    return {number("band", 0), number("band_speed", at - neutralOf("band_speed"), kAroundBand * at),
            number("band_width", kBandWidth * at - neutralOf("band_width"))};
  }
  if (std::sscanf(feature.c_str(), "sin and cos of %lf q", &at) == 1) {
    return {number("ripple_sin", 0), number("ripple_cos", 0),
            number("ripple", at - neutralOf("ripple"), kAround)};
  }
  const std::vector<std::pair<std::string, std::vector<std::string>>> words{
      {"1", {"constant"}},
      {"sgn v", {"sign"}},
      {"v", {"v"}},
      {"v|v|", {"v_square"}},
      {"q", {"q"}},
      {"q sgn v", {"q_sign"}},
      {"t", {"t"}},
      {"e", {"e"}},
      {"|e|", {"abs_e"}},
      {"t e", {"t_e"}},
      {"sin and cos of q", {"sin_q", "cos_q"}}};
  for (const auto& [word, parameters] : words) {
    if (word != feature) continue;
    std::vector<FreeNumber> numbers;
    for (const std::string& parameter : parameters) numbers.push_back(number(parameter, 0));
    return numbers;
  }
  return {};
}

// The effect has one ripple, one hum, one spot and one band: of features that ask for two only the
// first has its place. What they are a factor of, such as sgn v, they share. False: it has nothing
// for these.
bool addNumbers(const std::vector<FreeNumber>& numbers, Cause& cause) {
  const auto isTaken = [&](const FreeNumber& one) {
    return std::any_of(cause.free.begin(), cause.free.end(),
                       [&](const FreeNumber& other) { return other.parameter == one.parameter; });
  };
  const auto isTakenPlace = [&](const FreeNumber& one) {
    return one.lower < one.upper && isTaken(one);
  };
  if (std::any_of(numbers.begin(), numbers.end(), isTakenPlace)) return false;
  const std::size_t before = cause.free.size();
  for (const FreeNumber& one : numbers) {
    if (!isTaken(one)) cause.free.push_back(one);
  }
  return cause.free.size() > before;
}

// Bounds of the catalogue where a feature brings none of its own.
void complete(Cause& cause, const JointSimulator& joint) {
  const Cause bounded = boundedAt(cause, joint, sim::standardEffects());
  for (std::size_t i = 0; i < cause.free.size(); ++i) {
    FreeNumber& free = cause.free[i];
    const bool own = free.lower < free.upper;
    const double lower = own ? free.lower : bounded.free[i].lower;
    const double upper = own ? free.upper : bounded.free[i].upper;
    free = bounded.free[i];
    free.lower = std::max(lower, free.lower);
    free.upper = std::min(upper, free.upper);
  }
}

}  // namespace

std::vector<UnknownJoint> unknownJoints(const std::string& report_file,
                                        const std::string& robot_id) {
  std::vector<UnknownJoint> found;
  readReport(report_file, [&](const nlohmann::json& report) {
    const bool of_joints = report.value("level", "joint") == "joint";
    for (const nlohmann::json& joint : report.at("joints")) {
      const ReportedPlace place(joint.at("joint"));
      if (place.robot_id != robot_id) continue;
      const std::string text = joint.at("signature");
      if (!of_joints) {
        addSignals(text, found);
      } else if (const auto features = featuresIn(text); !features.empty()) {
        found.push_back({place.name, features});
      }
    }
  });
  if (found.empty()) throw InputError(report_file + ": no joint has a remainder with a signature");
  return found;
}

const PreparedJoint& jointOf(const PreparedSet& set, const std::string& joint) {
  for (const PreparedJoint& one : set.joints) {
    if (one.simulator->joint() == joint) return one;
  }
  throw InputError("the set has no joint " + joint + " that was measured in all runs");
}

std::vector<std::string> remainingFeatures(const PreparedJoint& joint) {
  std::vector<std::string> features;
  if (isWithoutRepeats(*joint.simulator)) return features;
  const DiagnosisOptions usual;
  JointSearch search(*joint.simulator, joint.noise, jointCauses(), usual.effort,
                     usual.runs_per_joint);
  search.begin();
  for (const SignatureTerm& term :
       signatureOf(*joint.simulator, search.data(), search.stage(), {}).terms) {
    features.push_back(term.feature);
  }
  return features;
}

EmpiricalFit fitEmpirical(const PreparedJoint& joint, const std::vector<std::string>& features) {
  const sim::EffectType& type = *sim::standardEffects().find("empirical_torque");
  Cause cause;
  cause.id = cause.effect = type.name;
  EmpiricalFit found;
  for (const std::string& feature : features) {
    if (!addNumbers(numbersFor(feature, type), cause)) found.left_out.push_back(feature);
  }
  if (cause.free.empty()) {
    throw InputError(joint.simulator->joint() + ": no feature of its signature can be a torque");
  }
  complete(cause, *joint.simulator);
  MotionFitOptions options;
  options.runs = isWithoutRepeats(*joint.simulator) ? 1 : kRuns;
  const std::vector<Cause> causes{cause};
  const MotionFit fit(*joint.simulator, joint.noise, causes, options);
  std::vector<std::size_t> motions;
  for (std::size_t m = 0; m < joint.simulator->measured().size(); ++m) {
    if (joint.simulator->measured()[m].split == Split::Fit) motions.push_back(m);
  }
  std::vector<double> start;
  for (const FreeNumber& free : cause.free) start.push_back(free.starts.front());
  const MotionFit::Result best = fit.fit({{0, start}}, motions);
  found.before = fit.meanError({}, motions);
  found.after = best.residual.cwiseAbs().mean();
  found.setting = settingOf(cause, best.model.front().x);
  return found;
}

}  // namespace nao::validation

#include "validation/diagnosis/whole/whole_diagnosis.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "validation/diagnosis/jobs/packed.h"
#include "validation/diagnosis/jobs/search_progress.h"
#include "validation/diagnosis/replay/gait_numbers.h"
#include "validation/diagnosis/whole/touching_stops.h"
#include "validation/log/log_robots.h"

namespace nao::validation {
namespace {

struct Moments {
  double sum = 0, squares = 0, count = 0;
  void add(double x) {
    sum += x;
    squares += x * x;
    count += 1;
  }
  double mean() const { return count > 0 ? sum / count : 0; }
  double sd() const {
    return count > 1 ? std::sqrt(std::max(0.0, (squares - sum * sum / count) / (count - 1))) : 0;
  }
};

// One robot of a set.
class RobotCase {
 public:
  RobotCase(const LogSet& set, std::string robot, bool alone,
            const std::shared_ptr<const RobotModel>& model, const WholeDiagnosisOptions& options,
            WholeDiagnosis& into)
      : robot_(std::move(robot)),
        prefix_(alone ? "" : robot_ + "/"),
        options_(options),
        simulator_(runsOf(set, robot_), model),
        kept_(options.kept.part(robot_)),
        handed_on_(handedOnTo(robot_, options.handed_on)),
        into_(into) {}

  // `false_alarms`: of this robot, one of so many.
  void diagnose(double false_alarms, std::size_t at, std::size_t robots) {
    begun_ = static_cast<double>(at) / static_cast<double>(robots);
    share_ = 1.0 / static_cast<double>(robots);
    WholeData data(simulator_, simulator_.judged(), options_.level == Level::Robot);
    data.keepIn(KeptRuns(kept_.part("robot")));
    tell("comparing the scatter of the repeats", begun_);
    spread_ = fitSpread(data, {}, options_.effort.base_runs, options_.jobs);
    data.learnStepErrors({}, options_.effort.step_runs, spread_.noise, options_.jobs);
    into_.spreads.push_back({robot_, spread_, spread_});
    const bool whole = options_.level == Level::Robot;
    add(notTriedAmong(handed_on_, whole, simulator_.model(), simulator_.judged()));
    progress_ = SearchProgress(begun_, share_);
    if (whole) {
      search(data, robotCauses(simulator_.model(), simulator_.joints()), "robot", {}, false_alarms);
      listGait();
      return;
    }
    searchLimbs(false_alarms);
  }

 private:
  // A motor that two legs share belongs to both, and the ground joins them: the limb with most to
  // explain comes first, and what is found in it acts when the others are searched. One of which
  // nothing else was measured is none to be searched.
  void searchLimbs(double false_alarms) {
    struct Part {
      std::string limb;
      std::vector<Joint> joints;
      std::unique_ptr<WholeData> data;
      double off = 0;
    };
    std::vector<Part> parts;
    for (const std::string& limb : limbsOf(simulator_.model(), simulator_.joints())) {
      const std::vector<Joint> joints = jointsOf(simulator_.model(), limb, simulator_.judged());
      if (isOfAnother(limb, joints)) {
        left_out_.push_back(limb);
        continue;
      }
      parts.push_back({limb, joints, std::make_unique<WholeData>(simulator_, joints, false), 0});
      parts.back().data->keepIn(KeptRuns(kept_.part(limb)));
      parts.back().off = calcOff(*parts.back().data);
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Part& a, const Part& b) { return a.off > b.off; });
    const double share = share_ / static_cast<double>(parts.size());
    for (const Part& part : parts) {
      progress_ = SearchProgress(begun_ + share * static_cast<double>(&part - parts.data()), share);
      part.data->give(found_);
      part.data->learnStepErrors({}, options_.effort.step_runs, spread_.noise, options_.jobs);
      search(*part.data, limbCauses(simulator_.model(), part.limb, simulator_.joints()), part.limb,
             part.joints, false_alarms / static_cast<double>(parts.size()));
    }
  }

  // Whether another limb has all of these joints, and more.
  bool isOfAnother(const std::string& limb, const std::vector<Joint>& joints) const {
    const auto limbs = limbsOf(simulator_.model(), simulator_.joints());
    return std::any_of(limbs.begin(), limbs.end(), [&](const std::string& other) {
      const auto theirs = jointsOf(simulator_.model(), other, simulator_.judged());
      return other != limb && theirs.size() > joints.size() &&
             std::all_of(joints.begin(), joints.end(), [&](Joint joint) {
               return std::find(theirs.begin(), theirs.end(), joint) != theirs.end();
             });
    });
  }

  // Square of measured minus simulated means [rad^2].
  double calcOff(const WholeData& data) const {
    return (measuredMeans(data) - simulatedMeans(data, {}, spread_.noise)).squaredNorm();
  }

  static Eigen::VectorXd measuredMeans(const WholeData& data) {
    std::vector<Eigen::VectorXd> runs;
    for (std::size_t run = 0; run < data.runs(); ++run) runs.push_back(data.measured(run));
    return data.stackMeans(runs);
  }

  Eigen::VectorXd simulatedMeans(const WholeData& data, const std::vector<EffectSetting>& effects,
                                 const NoiseParts& noise) const {
    constexpr std::size_t kAll = 1000000;
    return data.stackMeans(
        meansOf(data.simulate(effects, 1, kAll, Blocks::All, 1, noise, options_.jobs)));
  }

  bool isJudged(Joint joint) const {
    const std::vector<Joint> judged = simulator_.judged();
    return std::find(judged.begin(), judged.end(), joint) != judged.end();
  }

  // `joints`: of a limb; none: of the robot.
  void search(WholeData& data, std::vector<PlacedCause> causes, const std::string& whole,
              const std::vector<Joint>& joints, double false_alarms) {
    const auto unwanted = [&](const PlacedCause& one) {
      if (!one.isTried()) return false;
      const auto& only = options_.only;
      const std::string placed = one.cause.id + " at " + one.place;
      const auto asked = [&](const std::string& id) { return id == one.cause.id || id == placed; };
      return (!only.empty() && std::none_of(only.begin(), only.end(), asked)) ||
             (one.joints.size() == 1 && !isJudged(one.joints.front()));
    };
    causes.erase(std::remove_if(causes.begin(), causes.end(), unwanted), causes.end());
    for (PlacedCause& one : causes) {
      if (one.cause.coupled) startWhereTouched(one, simulator_);
    }
    auto provisional =
        provisionalAmong(causes, handed_on_, joints, simulator_.model(), simulator_.judged());
    const WholeTask task{&data,         &causes,       options_.effort,
                         spread_.noise, options_.jobs, grantedRuns(data, whole)};
    WholeSearch search(
        task, spread_,
        [&](const std::string& what) { tell(whole + ": " + what, progress_.nextPhase()); },
        false_alarms, std::move(provisional));
    const WholeVerdict found = search.run();
    const std::vector<EffectSetting> effects = settingsOf(causes, found.model);
    found_.insert(found_.end(), effects.begin(), effects.end());
    left_noise_ = found.spread.noise;
    if (options_.level == Level::Robot) into_.spreads.back().found = found.spread;
    addVerdict(found, whole);
    add(found.handed_on);
    addCourse(data, effects, whole);
    into_.set.runs += data.used();
  }

  void add(const std::vector<HandedOnFate>& fates) {
    for (HandedOnFate fate : fates) {
      fate.was.place = prefix_ + fate.was.place;
      into_.handed_on.push_back(std::move(fate));
    }
  }

  // How many runs the time pays for; one that goes on was told so before.
  long grantedRuns(const WholeData& data, const std::string& whole) const {
    if (options_.seconds <= 0) return kNoLimit;
    const double seconds = options_.seconds * progress_.share();
    const auto count = [&] { return pack(data.used() + runsWithin(seconds, data)); };
    return unpack<long>(kept_.part(whole).remember("budget", count));
  }

  // From what some cost here and now.
  long runsWithin(double seconds, const WholeData& data) const {
    const auto begin = std::chrono::steady_clock::now();
    constexpr int kRuns = 3;
    for (int i = 0; i < kRuns; ++i) data.replay({}, 0, 1u + i, spread_.noise, Pace::Coarse);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    return std::lround(seconds * options_.jobs / (taken.count() / kRuns));
  }

  void addVerdict(const WholeVerdict& found, const std::string& whole) {
    JointVerdict all;
    all.joint = prefix_ + whole;
    all.verdict = found.verdict;
    all.rejected = found.rejected;
    for (const Joint joint : simulator_.joints()) {
      if (isJudged(joint)) continue;
      const std::string& name = simulator_.model().actuators[index(joint)].name;
      all.rejected.push_back({name, 0, "not judged: the ground holds its two hinges together"});
    }
    for (const std::string& limb : left_out_) {
      all.rejected.push_back(
          {limb, 0, "not searched: nothing but a motor that it shares was seen"});
    }
    left_out_.clear();
    all.critical_gain = found.critical_gain;
    all.misfit_before = found.misfit_before;
    all.misfit_after = found.misfit_after;
    all.remainder_score = found.remainder;
    all.remainder_critical = found.remainder_critical;
    all.signature = found.signature;
    all.not_tried = found.not_tried;
    const std::size_t first = into_.set.joints.size();
    into_.set.joints.push_back(all);
    for (const PlacedFinding& one : found.findings) {
      if (one.place == "robot" || one.place == whole) {
        into_.set.joints[first].findings.push_back(one.finding);
      } else {
        placeOf(one.place, first).findings.push_back(one.finding);
      }
    }
    for (std::size_t i = first; i < into_.set.joints.size(); ++i)
      settle(into_.set.joints[i], found);
    into_.set.critical_gain = std::max(into_.set.critical_gain, found.critical_gain);
  }

  JointVerdict& placeOf(const std::string& place, std::size_t first) {
    auto& joints = into_.set.joints;
    for (std::size_t i = first; i < joints.size(); ++i) {
      if (joints[i].joint == prefix_ + place) return joints[i];
    }
    joints.emplace_back();
    joints.back().joint = prefix_ + place;
    joints.back().critical_gain = joints[first].critical_gain;
    joints.back().misfit_before = joints[first].misfit_before;
    joints.back().misfit_after = joints[first].misfit_after;
    return joints.back();
  }

  // A place's own word: what remains is the whole's.
  static void settle(JointVerdict& joint, const WholeVerdict& found) {
    const auto named = joint.named();
    const bool whole = !joint.rejected.empty() || joint.remainder_critical > 0;
    const bool remains = whole && found.remainder > found.remainder_critical;
    const bool rivals = std::any_of(named.begin(), named.end(),
                                    [](const Finding* one) { return !one->rivals.empty(); });
    joint.verdict =
        named.empty() ? Verdict::NoDiscrepancy : (rivals ? Verdict::Ambiguous : Verdict::Named);
    if (whole && !found.not_tried.empty()) joint.verdict = Verdict::Unfinished;
    if (!remains || !found.not_tried.empty()) return;
    const bool any = std::any_of(found.findings.begin(), found.findings.end(),
                                 [](const PlacedFinding& one) { return !one.finding.small; });
    joint.verdict = any ? Verdict::PartlyExplained : Verdict::Unknown;
  }

  void listGait() {
    for (const WholeBlock& block : simulator_.blocks()) {
      std::map<std::string, Moments> measured, nominal, extended;
      for (const std::size_t run : block.runs) {
        addTo(measured, simulator_.measured()[run]);
        addTo(nominal, simulator_.simulate({}, run, run + 1, spread_.noise));
        addTo(extended, simulator_.simulate(found_, run, run + 1, left_noise_));
      }
      for (const GaitNumber& number : calcGait(simulator_.measured()[block.runs.front()])) {
        const std::string& name = number.name;
        into_.gait.push_back({robot_, block.motion, nameOf(block.split), name, number.unit,
                              measured[name].mean(), measured[name].sd(), nominal[name].mean(),
                              nominal[name].sd(), extended[name].mean()});
      }
    }
  }

  // Of the joint and the motion in which the nominal model is furthest off.
  void addCourse(const WholeData& data, const std::vector<EffectSetting>& found,
                 const std::string& whole) {
    const Eigen::VectorXd measured = measuredMeans(data);
    const Eigen::VectorXd nominal = simulatedMeans(data, {}, spread_.noise);
    const Eigen::VectorXd extended =
        found.empty() ? nominal : simulatedMeans(data, found, left_noise_);
    WholeDiagnosis::Course worst;
    double most = -1;
    for (std::size_t block = 0; block < data.spaces().size(); ++block) {
      for (std::size_t g = 0; g < data.joints(); ++g) {
        const FeatureGroup& group = data.spaces()[block].groups()[g];
        const Eigen::Index at = data.offsets()[block] + group.offset;
        const double off = (measured - nominal).segment(at, group.size).squaredNorm();
        if (off <= most) continue;
        most = off;
        worst = {prefix_ + whole,
                 group.name,
                 {simulator_.blocks()[block].motion, group.dt, measured.segment(at, group.size),
                  nominal.segment(at, group.size), extended.segment(at, group.size),
                  Eigen::VectorXd::Constant(group.size, spread_.measured_sd)}};
      }
    }
    into_.courses.push_back(worst);
  }

  static void addTo(std::map<std::string, Moments>& moments, const WholeRun& run) {
    for (const GaitNumber& number : calcGait(run)) moments[number.name].add(number.value);
  }

  void tell(const std::string& what, double part) const {
    if (options_.progress) options_.progress(prefix_ + what, part);
  }

  std::string robot_, prefix_;
  const WholeDiagnosisOptions& options_;
  WholeSimulator simulator_;
  KeptWork kept_;
  std::vector<HandedOn> handed_on_;
  WholeDiagnosis& into_;
  WholeSpread spread_;
  NoiseParts left_noise_;         // with what was found last
  double begun_ = 0, share_ = 1;  // of all robots' work
  SearchProgress progress_;       // of the present search
  std::vector<EffectSetting> found_;
  std::vector<std::string> left_out_;  // limbs, until a verdict says so
};

}  // namespace

WholeDiagnosis diagnoseWhole(const LogSet& set, const std::shared_ptr<const RobotModel>& model,
                             const WholeDiagnosisOptions& options) {
  constexpr double kFalseAlarms = 0.01;  // per whole data set
  WholeDiagnosis diagnosis;
  const std::vector<std::string> robots = robotsOf(set);
  requireRobots(options.handed_on, robots);
  for (std::size_t i = 0; i < robots.size(); ++i) {
    RobotCase one(set, robots[i], robots.size() == 1, model, options, diagnosis);
    one.diagnose(kFalseAlarms / static_cast<double>(robots.size()), i, robots.size());
  }
  diagnosis.set.null_sets = options.effort.null_sets;
  diagnosis.set.verdict = overall(diagnosis.set.joints);
  return diagnosis;
}

}  // namespace nao::validation

#include "validation/diagnosis/joint/joint_crowd.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include "validation/diagnosis/ensemble/ensemble_tape.h"
#include "validation/diagnosis/jobs/packed.h"

namespace nao::validation {
namespace {

// Runs per motion of a joint in which nothing is wrong, measured in 2026-11: for the progress bar.
constexpr double kLookRuns = 4000, kRestRuns = 4000;

// Times the noise of the robot's file, of a search that may have taken a law's scatter for it; and
// what a law that makes that scatter leaves of it.
constexpr double kLoud = 4, kQuieter = 0.5;

bool isStart(const Cause& cause, double x) {
  const std::vector<double>& starts = cause.free[0].starts;
  return std::find(starts.begin(), starts.end(), x) != starts.end();
}

// Of each cause of the joint's own link.
std::vector<LinkLook> linkLooksOf(const JointSearch& search, const Eigen::VectorXd& white) {
  std::map<std::size_t, LinkLook> best;
  for (const Look& look : search.stage().looks()) {
    if (!search.causes()[look.cause].of_link) continue;
    double scale = 0;
    const double gain = Stage::gain(look, white, &scale);
    if (gain <= best[look.cause].gain) continue;
    best[look.cause] = {look.cause, look.x, gain};
    best[look.cause].x[0] *= scale;
  }
  std::vector<LinkLook> looks;
  for (const auto& [cause, look] : best) {
    if (look.gain > 0) looks.push_back(look);
  }
  return looks;
}

JointLooks looksOf(const JointSearch& search) {
  const Stage& stage = search.stage();
  const Eigen::VectorXd white = stage.white(stage.raw());
  JointLooks looks{search.nulls(),
                   stage.largestGain(white),
                   white.squaredNorm(),
                   {},
                   linkLooksOf(search, white)};
  for (const Look& look : stage.looks()) {
    const Cause& cause = search.causes()[look.cause];
    if (cause.scope != Scope::Robot || look.x.size() != 1) continue;
    const Explained explained(look.white, white);
    looks.shared.push_back({look.cause, look.x[0],
                            !cause.scan.empty() && !isStart(cause, look.x[0]), explained.along(),
                            explained.square(), explained.gain(), look.lower, look.upper});
  }
  return looks;
}

// Of an unknown number of runs, when about `usual` are to be expected.
double partOf(double runs, double usual) {
  return runs < usual ? 0.9 * runs / usual : 1 - 0.1 * usual / runs;
}

}  // namespace

JointCrowd::JointCrowd(const std::vector<JointTask>& tasks, const std::vector<Cause>& causes,
                       const DiagnosisOptions& options)
    : tasks_(tasks), causes_(causes), options_(options), done_(tasks.size()) {
  for (const JointTask& task : tasks) {
    searches_.push_back(std::make_unique<JointSearch>(*task.joint, task.noise, causes,
                                                      options.effort, options.runs_per_joint));
  }
}

JointCrowd::~JointCrowd() = default;

std::string JointCrowd::questionOf(const std::string& what, std::size_t cause,
                                   const std::vector<double>& x) {
  std::string question = what + '-' + std::to_string(cause);
  for (const double number : x) {
    char text[32];
    std::snprintf(text, sizeof text, "-%a", number);
    question += text;
  }
  return question;
}

std::string JointCrowd::unitOf(std::size_t joint, const std::string& question) const {
  return searches_[joint]->name() + "." + question;
}

std::vector<std::string> JointCrowd::ask(const std::string& question,
                                         const std::function<std::string(std::size_t)>& work) {
  return askAll(*options_.team, question, size(), options_.jobs, work);
}

// Where the same was simulated before it is not simulated again.
void JointCrowd::taped(std::size_t joint, const std::string& question,
                       const std::function<void()>& work) {
  if (!options_.kept.keeps()) return work();
  const std::string unit = unitOf(joint, question);
  const std::optional<std::string> before = options_.kept.find(unit);
  EnsembleTape tape = before ? EnsembleTape(*before) : EnsembleTape();
  searches_[joint]->ensemble().setTape(&tape);
  work();
  searches_[joint]->ensemble().setTape(nullptr);
  if (!before) options_.kept.keep(unit, tape.bytes());
}

void JointCrowd::tell() const {
  if (!options_.progress) return;
  double done = 0;
  std::size_t mine = 0;
  for (std::size_t j = 0; j < size(); ++j) {
    if (!options_.team->owns(j)) continue;
    done += (done_[j].look + done_[j].rest) / 2;
    ++mine;
  }
  options_.progress(step_, mine == 0 ? 1 : done / static_cast<double>(mine));
}

// `part` is what of the progress the work fills up.
void JointCrowd::watched(std::size_t joint, double usual, std::atomic<double>& part,
                         const std::function<void()>& work) {
  Ensemble& ensemble = searches_[joint]->ensemble();
  const double all = usual * static_cast<double>(data(joint).spans().size());
  const long before = ensemble.used();
  ensemble.setWatch([&, all, before](long runs) {
    part = partOf(static_cast<double>(runs - before), all);
    tell();
  });
  work();
  ensemble.setWatch({});
  part = 1;
  tell();
}

void JointCrowd::lookAnew(const std::string& question,
                          const std::function<void(std::size_t)>& work) {
  const auto answers = ask(question, [&](std::size_t j) {
    taped(j, question, [&] { work(j); });
    return pack(looksOf(*searches_[j]));
  });
  looks_.clear();
  for (const std::string& answer : answers) looks_.push_back(unpack<JointLooks>(answer));
}

void JointCrowd::begin() {
  step_ = "looking at every cause";
  tell();
  lookAnew("look", [&](std::size_t j) {
    watched(j, kLookRuns, done_[j].look, [&] { searches_[j]->begin(); });
  });
}

OtherJoints JointCrowd::allBut(std::size_t joint) const {
  OtherJoints all;
  for (std::size_t j = 0; j < looks_.size(); ++j) {
    if (j == joint) continue;
    all.shared.push_back(looks_[j].shared);
    const NullRecord& one = looks_[j].nulls;
    all.nulls.gains.resize(std::max(all.nulls.gains.size(), one.gains.size()), 0);
    all.nulls.remainders.resize(std::max(all.nulls.remainders.size(), one.remainders.size()), -1e9);
    for (std::size_t n = 0; n < one.gains.size(); ++n) {
      all.nulls.gains[n] = std::max(all.nulls.gains[n], one.gains[n]);
      all.nulls.remainders[n] = std::max(all.nulls.remainders[n], one.remainders[n]);
    }
  }
  return all;
}

std::vector<double> JointCrowd::gainsAt(std::size_t cause, double x) {
  return answersOf(questionOf("cost", cause, {x}),
                   [&](std::size_t j) { return -searches_[j]->costOf(cause, {x}); });
}

std::vector<double> JointCrowd::leftAt(std::size_t cause, double x) {
  return answersOf(questionOf("left", cause, {x}),
                   [&](std::size_t j) { return searches_[j]->leftBy(cause, x); });
}

std::vector<double> JointCrowd::gainsAt(std::size_t cause, const std::vector<double>& x,
                                        std::size_t link) {
  const std::vector<Joint> place = tasks_[link].joint->place();
  return answersOf(questionOf("link" + std::to_string(link), cause, x), [&](std::size_t j) {
    return j == link || carries(j, link) ? -searches_[j]->costOf(cause, x, place) : 0;
  });
}

std::vector<double> JointCrowd::answersOf(const std::string& question,
                                          const std::function<double(std::size_t)>& work) {
  step_ = "trying causes that several joints share";
  const auto answers = ask(question, [&](std::size_t j) {
    double number = 0;
    taped(j, question, [&] { number = work(j); });
    tell();
    return pack(number);
  });
  std::vector<double> numbers;
  for (const std::string& answer : answers) numbers.push_back(unpack<double>(answer));
  return numbers;
}

std::vector<SharedStep> JointCrowd::stepsFrom(std::size_t cause, double x) {
  const std::string question = questionOf("step", cause, {x});
  const auto answers = ask(question, [&](std::size_t j) {
    SharedStep step;
    taped(j, question, [&] { step = searches_[j]->stepFrom(cause, x); });
    tell();
    return pack(step);
  });
  std::vector<SharedStep> steps;
  for (const std::string& answer : answers) steps.push_back(unpack<SharedStep>(answer));
  return steps;
}

std::vector<double> JointCrowd::beatingSizesOf(std::size_t joint, std::size_t cause) {
  const std::string question = questionOf("beat", cause, {});
  const auto answers = ask(question, [&](std::size_t j) {
    std::vector<double> sizes;
    if (j == joint) taped(j, question, [&] { sizes = searches_[j]->beatingSizesOf(cause); });
    return pack(sizes);
  });
  return unpack<std::vector<double>>(answers[joint]);
}

void JointCrowd::give(std::size_t cause, double x) {
  given_ = true;
  lookAnew(questionOf("given", cause, {x}), [&](std::size_t j) { searches_[j]->give(cause, x); });
}

bool isLoud(const JointVerdict& verdict, double fitted, double usual) {
  if (usual <= 0 || fitted < kLoud * usual) return false;
  const Verdict said = verdict.verdict;
  const bool nothing = said == Verdict::NoDiscrepancy && verdict.findings.empty();
  if (nothing || said == Verdict::Unfinished) return false;
  const bool in_part = said == Verdict::Unknown || said == Verdict::PartlyExplained;
  return in_part || verdict.noise > kLoud * usual;
}

// Of little chance some laws make much: a joint that sticks and slips seems to have noise that, if
// it had it, would shake it loose. If such a law, by the noise of the robot's file, explains all or
// leaves less, and explains how the repeats scatter too, it is what is wrong.
JointVerdict JointCrowd::searchedQuietly(std::size_t joint, JointVerdict loud) const {
  const JointTask& task = tasks_[joint];
  JointNoise noise = task.noise;
  noise.torque_sd = task.nominal.torque_sd;
  noise.torque_time = task.nominal.torque_time;
  JointSearch search(*task.joint, noise, causes_, options_.effort, options_.runs_per_joint);
  search.begin();
  JointVerdict quiet = search.conclude(allBut(joint));
  quiet.runs = loud.runs += quiet.runs;
  const bool all = quiet.verdict == Verdict::Named || quiet.verdict == Verdict::Ambiguous;
  const bool more = !quiet.named().empty() && quiet.misfit_after < loud.misfit_after;
  return (all || more) && quiet.noise < kQuieter * task.noise.torque_sd ? quiet : loud;
}

std::vector<JointVerdict> JointCrowd::conclude() {
  step_ = "searching every joint";
  tell();
  const auto answers = ask("verdict", [&](std::size_t j) {
    return options_.kept.remember(unitOf(j, "verdict"), [&] {
      JointVerdict verdict;
      watched(j, kRestRuns, done_[j].rest, [&] { verdict = searches_[j]->conclude(allBut(j)); });
      const JointTask& task = tasks_[j];
      const bool loud = isLoud(verdict, task.noise.torque_sd, task.nominal.torque_sd);
      if (loud && !given_) verdict = searchedQuietly(j, std::move(verdict));
      return pack(verdict);
    });
  });
  std::vector<JointVerdict> verdicts;
  for (const std::string& answer : answers) verdicts.push_back(unpack<JointVerdict>(answer));
  searchAbove(verdicts);
  return verdicts;
}

}  // namespace nao::validation

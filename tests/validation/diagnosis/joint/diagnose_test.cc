#include "validation/diagnosis/joint/diagnose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <stdexcept>

#include "tests/core/temporary_folder.h"
#include "tests/validation/diagnosis/thread_team.h"
#include "tests/validation/diagnosis/toy_search.h"
#include "validation/diagnosis/report/diagnosis_json.h"

namespace nao::validation {
namespace {

using test::ToyJoint;
using test::ToyLaws;

DiagnosisOptions quick(int jobs) {
  DiagnosisOptions options;
  options.jobs = jobs;
  options.effort = {4, 8, 24, 40, 4, 1, 1};
  return options;
}

SetDiagnosis diagnose(const std::vector<ToyLaws>& truths, DiagnosisOptions options = quick(2)) {
  std::vector<ToyJoint> joints;
  for (std::size_t j = 0; j < truths.size(); ++j) {
    joints.emplace_back(truths[j], j + 1, test::kToyNoise, 6, 3, "Toy" + std::to_string(j));
  }
  std::vector<JointTask> tasks;
  for (const ToyJoint& joint : joints) tasks.push_back({&joint, test::kToyNoise});
  return diagnoseJoints(tasks, test::toyCauses(), options);
}

ToyLaws late() {
  ToyLaws laws;
  laws.latency += 0.012;
  return laws;
}

// To a heavy joint seen by its angle alone a hold is late by half of itself: either may come first.
TEST(Diagnose, SaysOnceWhatAllJointsShare) {
  const SetDiagnosis found = diagnose({late(), late()});
  ASSERT_EQ(found.shared.size(), 1u);
  const Finding& finding = found.shared[0].finding;
  std::map<std::string, double> numbers{{finding.cause, finding.numbers[0].deviation}};
  for (const Rival& rival : finding.rivals) numbers[rival.cause] = rival.numbers[0].deviation;
  ASSERT_EQ(numbers.size(), 2u);
  ASSERT_EQ(numbers.count("command_latency") + numbers.count("sensor_delay"), 1u);
  ASSERT_EQ(numbers.count("command_hold"), 1u);
  EXPECT_NEAR(numbers["command_hold"], 2 * 0.012, 0.003);
  EXPECT_NEAR(numbers["command_latency"] + numbers["sensor_delay"], 0.012, 0.001);
  for (const JointVerdict& joint : found.joints) EXPECT_TRUE(joint.named().empty());
}

// A battery was named alone that two ankles were to share, which left 39 SD of null sets at one.
TEST(Diagnose, WhatJointsShareIsNotNamedAloneBesideARemainder) {
  ToyLaws odd = late();
  odd.cogging = 0.1;
  const SetDiagnosis found = diagnose({odd, late()});
  ASSERT_EQ(found.shared.size(), 1u);
  ASSERT_FALSE(found.shared[0].finding.rivals.empty());
  EXPECT_EQ(found.shared[0].finding.rivals.back().cause, "unknown");
  EXPECT_EQ(found.verdict, Verdict::PartlyExplained);
}

TEST(Diagnose, NamesAJointsOwnFaultThereAlone) {
  ToyLaws weak;
  weak.kp *= 0.7;
  const SetDiagnosis found = diagnose({weak, {}});
  EXPECT_TRUE(found.shared.empty());
  ASSERT_EQ(found.joints[0].named().size(), 1u);
  EXPECT_EQ(found.joints[0].named()[0]->cause, "kp_error");
  EXPECT_TRUE(found.joints[1].named().empty());
}

// A link that is heavier by a third was told as gravity, of which its neighbour shows nothing.
TEST(Diagnose, NamesNoGravityThatOneJointAloneFeels) {
  ToyLaws heavy;
  heavy.gravity *= 1.3;
  const auto rejected = [](const SetDiagnosis& found) {
    const std::vector<Rejected>& all = found.joints[0].rejected;
    return std::any_of(all.begin(), all.end(), [](const Rejected& one) {
      return one.cause == "gravity_scale" &&
             one.reason == "there is one for all joints, and others speak against it";
    });
  };
  EXPECT_FALSE(rejected(diagnose({heavy})));
  const SetDiagnosis found = diagnose({heavy, {}});
  EXPECT_TRUE(rejected(found));
  for (const Finding* one : found.joints[0].named()) EXPECT_NE(one->cause, "gravity_scale");
}

TEST(Diagnose, SaysTheSameWithAnyNumberOfThreads) {
  ToyLaws weak;
  weak.kp *= 0.8;
  DiagnosisOptions one = quick(1), two = quick(2);
  one.effort = two.effort = {2, 4, 8, 12, 2, 1, 1};
  EXPECT_EQ(toJson(diagnose({weak, {}}, one), {}), toJson(diagnose({weak, {}}, two), {}));
}

TEST(Diagnose, TellsThatRepeatsScatterOtherwiseThanTheRobotsFileSays) {
  const ToyJoint toy({}, 1, test::kToyNoise, 3, 2);
  DiagnosisOptions options;
  options.effort = {2, 4, 8, 12, 2, 1, 1};
  const auto said = [&](double nominal) {
    JointTask task{&toy, test::kToyNoise, test::kToyNoise};
    task.nominal.torque_sd *= nominal;
    return toText(diagnoseJoints({task}, test::toyCauses(), options));
  };
  EXPECT_NE(said(0.5).find("process_noise: its repeats scatter"), std::string::npos);
  EXPECT_NE(said(0.5).find("2.0 times those of the robot's file"), std::string::npos);
  EXPECT_EQ(said(1).find("process_noise"), std::string::npos);
}

TEST(Diagnose, TellsARemainderFromACauseTooSmallToExplainOne) {
  SetDiagnosis diagnosis;
  JointVerdict joint;
  joint.verdict = Verdict::PartlyExplained;
  joint.remainder_critical = 2.5;
  for (const double score : {9.0, 0.2}) {
    joint.remainder_score = score;
    diagnosis.joints = {joint};
    const std::string said = toText(diagnosis);
    EXPECT_EQ(said.find("something remains") != std::string::npos, score > 2.5) << said;
    EXPECT_EQ(said.find("too small to be of interest") != std::string::npos, score < 2.5) << said;
  }
}

// An elbow stuck with 1.5 N m and slipped by chance: as noise of 0.5 N m, under which it would not
// stick, so that nothing was found to be like it.
TEST(Diagnose, ALawThatMakesMuchOfLittleChanceIsNoNoise) {
  ToyLaws laws;
  laws.stribeck = 0.4;
  const ToyJoint toy(laws, 1, test::kToyNoise, 6, 3);
  DiagnosisOptions options;
  options.effort = test::quick();
  JointTask task{&toy, test::kToyNoise, {}};
  task.noise.torque_sd *= 16;  // as if fitted to such repeats
  EXPECT_EQ(diagnoseJoints({task}, test::toyCauses(), options).verdict, Verdict::PartlyExplained);
  task.nominal = test::kToyNoise;
  const SetDiagnosis found = diagnoseJoints({task}, test::toyCauses(), options);
  EXPECT_EQ(found.verdict, Verdict::Named);
  ASSERT_EQ(found.joints[0].findings.size(), 1u);
  EXPECT_EQ(found.joints[0].findings[0].cause, "stribeck_friction");
  EXPECT_LE(found.joints[0].findings[0].numbers[0].low, 0.4);
  EXPECT_GE(found.joints[0].findings[0].numbers[0].high, 0.4);
}

// A joint that counts what is simulated.
class CountedJoint final : public JointSimulator {
 public:
  CountedJoint(const ToyJoint& joint, std::atomic<long>& runs) : joint_(joint), runs_(runs) {}
  std::string joint() const override { return joint_.joint(); }
  const std::vector<JointMotion>& measured() const override { return joint_.measured(); }
  Eigen::MatrixXd run(const std::vector<EffectSetting>& causes, std::size_t motion,
                      std::uint64_t stream, const JointNoise& noise) const override {
    ++runs_;
    return joint_.run(causes, motion, stream, noise);
  }
  double present(const std::string& effect, const std::string& parameter) const override {
    return joint_.present(effect, parameter);
  }

 private:
  const ToyJoint& joint_;
  std::atomic<long>& runs_;
};

// Two joints that are late, one of them weak as well, searched with little effort.
class CutOff : public testing::Test {
 protected:
  CutOff() {
    ToyLaws weak = late();
    weak.kp *= 0.7;
    for (const ToyLaws& truth : {late(), weak}) {
      toys_.emplace_back(truth, 1 + toys_.size(), test::kToyNoise, 3, 2,
                         "Toy" + std::to_string(toys_.size()));
    }
    for (const ToyJoint& toy : toys_) joints_.emplace_back(toy, runs_);
    for (const CountedJoint& joint : joints_) tasks_.push_back({&joint, test::kToyNoise});
    options_.effort = {2, 4, 8, 12, 2, 1, 1};
  }

  std::string diagnosed(const DiagnosisOptions& options) const {
    return toJson(diagnoseJoints(tasks_, test::toyCauses(), options), {});
  }
  DiagnosisOptions keeping() const {
    DiagnosisOptions options = options_;
    options.kept = KeptWork(folder_.path() + "/kept", "key");
    return options;
  }

  std::vector<ToyJoint> toys_;
  std::vector<CountedJoint> joints_;
  std::vector<JointTask> tasks_;
  std::atomic<long> runs_{0};
  DiagnosisOptions options_;
  TemporaryFolder folder_;
};

TEST_F(CutOff, ADiagnosisThatIsTakenUpAgainSaysTheSame) {
  const std::string whole = diagnosed(options_);
  const long all = runs_;
  for (const double part : {0.2, 0.4}) {  // of what was to be simulated
    DiagnosisOptions options = keeping();
    runs_ = 0;
    options.progress = [&](const std::string&, double) {
      if (static_cast<double>(runs_) > part * static_cast<double>(all)) {
        throw std::runtime_error("cut off");
      }
    };
    EXPECT_THROW(diagnosed(options), std::runtime_error);
  }
  runs_ = 0;
  EXPECT_EQ(diagnosed(keeping()), whole);
  EXPECT_LT(runs_, 0.9 * static_cast<double>(all));
}

TEST_F(CutOff, WhatIsFinishedIsNotSimulatedAgain) {
  const std::string whole = diagnosed(keeping());
  runs_ = 0;
  EXPECT_EQ(diagnosed(keeping()), whole);
  EXPECT_EQ(runs_, 0);
}

TEST_F(CutOff, ProcessesTogetherSayTheSameAsOne) {
  const std::string whole = diagnosed(options_);
  const long all = runs_;
  for (const std::size_t size : {2u, 3u}) {  // of three one has nothing to do
    runs_ = 0;
    std::vector<std::string> said(size);
    test::ThreadTeam::run(size, [&](const Team& team) {
      DiagnosisOptions options = options_;
      options.team = std::shared_ptr<const Team>(&team, [](const Team*) {});
      said[team.rank()] = diagnosed(options);
    });
    EXPECT_EQ(said, std::vector<std::string>(size, whole));
    EXPECT_EQ(runs_, all);  // nobody did what another did
  }
}

}  // namespace
}  // namespace nao::validation

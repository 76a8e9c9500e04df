// What a diagnosis says when the truth is not in its catalogue, or is there twice.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "tests/hidden/hidden_set.h"
#include "tests/support/models.h"
#include "validation/diagnosis/joint/diagnose.h"
#include "validation/diagnosis/joint/prepared_set.h"

namespace nao::hidden {
namespace {

using validation::Cause;
using validation::JointVerdict;
using validation::Verdict;

// One set for all: something pushes the head to one side.
class Mutation : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    HiddenCase hidden;
    hidden.kind = Kind::Single;
    hidden.seed = 4;
    hidden.joints = {"HeadYaw"};
    hidden.seconds = 3;
    hidden.repeats = 4;
    hidden.limbs = true;
    for (const Hideout& hideout : catalogueHideouts()) {
      if (hideout.cause == kHidden) hidden.wishes = {{hideout, 14}};
    }
    const auto model = test::robot("nao_h21_v33");
    made().emplace(makeHiddenSet(hidden, model));
    prepared().emplace(validation::prepareSet(made()->set, model, 1));
  }
  static void TearDownTestSuite() {
    prepared().reset();
    made().reset();
  }

  // With a tenth of a diagnosis' usual effort: the effect is far from small.
  static JointVerdict diagnose(const std::vector<Cause>& causes) {
    validation::DiagnosisOptions options;
    options.effort = {4, 8, 24, 40, 5, 2, 1};
    const validation::PreparedJoint& joint = prepared()->joints.front();
    return diagnoseJoints({{joint.simulator.get(), joint.noise}}, causes, options).joints.front();
  }

  // A part of the catalogue, so that it is quick; nothing in it but the truth has a side.
  static std::vector<Cause> catalogue() {
    static const std::vector<std::string> kSome{
        "coulomb_friction", "viscous_friction", "kp_error", "kd_error",       kHidden,
        "motor_inertia",    "command_latency",  "backlash", "command_filter", "servo_deadband"};
    std::vector<Cause> some;
    for (const Cause& cause : validation::jointCauses()) {
      if (std::find(kSome.begin(), kSome.end(), cause.id) != kSome.end()) some.push_back(cause);
    }
    return some;
  }

  static constexpr char kHidden[] = "torque_bias";

 private:
  static std::optional<HiddenSet>& made() {
    static std::optional<HiddenSet> made;
    return made;
  }
  static std::optional<validation::PreparedSet>& prepared() {
    static std::optional<validation::PreparedSet> prepared;
    return prepared;
  }
};

TEST_F(Mutation, ACauseThatIsThereIsNamed) {
  const JointVerdict verdict = diagnose(catalogue());
  ASSERT_FALSE(verdict.named().empty());
  EXPECT_EQ(verdict.named().front()->cause, kHidden);
  EXPECT_TRUE(verdict.named().front()->rivals.empty());
}

TEST_F(Mutation, ACauseThatIsNotThereIsUnknown) {
  std::vector<Cause> causes = catalogue();
  causes.erase(std::remove_if(causes.begin(), causes.end(),
                              [](const Cause& cause) { return cause.id == kHidden; }),
               causes.end());
  const JointVerdict verdict = diagnose(causes);
  EXPECT_TRUE(verdict.verdict == Verdict::Unknown || verdict.verdict == Verdict::PartlyExplained)
      << wordOf(verdict.verdict);
}

TEST_F(Mutation, ACauseThatIsThereTwiceIsAmbiguous) {
  std::vector<Cause> causes = catalogue();
  Cause twin = *std::find_if(causes.begin(), causes.end(),
                             [](const Cause& cause) { return cause.id == kHidden; });
  twin.id = "its_twin";
  causes.push_back(twin);
  const JointVerdict verdict = diagnose(causes);
  EXPECT_EQ(verdict.verdict, Verdict::Ambiguous) << wordOf(verdict.verdict);
  ASSERT_FALSE(verdict.named().empty());
  ASSERT_EQ(verdict.named().front()->rivals.size(), 1u);
}

}  // namespace
}  // namespace nao::hidden

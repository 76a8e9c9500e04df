#include "validation/diagnosis/folds/fold_search.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/check.h"
#include "tests/validation/diagnosis/toy_joint.h"

namespace nao::validation {
namespace {

using test::ToyJoint;
using test::ToyLaws;

// One run per motion.
ToyJoint onceMeasured(const ToyLaws& truth, std::size_t motions = 4) {
  return ToyJoint(truth, 3, test::kToyNoise, 1, motions);
}

std::vector<Cause> searchedFor() {
  std::vector<Cause> few;
  for (const Cause& cause : test::toyCauses()) {
    for (const char* id : {"coulomb_friction", "kp_error", "link_mass", "torque_bias"}) {
      if (cause.id == id) few.push_back(cause);
    }
  }
  return few;
}

FoldDiagnosis search(const ToyJoint& joint, long granted = 1000000) {
  FoldSearchOptions options;
  options.sets = 100;
  options.granted = granted;
  return searchByFolds(joint, searchedFor(), options);
}

TEST(FoldSearch, NamesWhatPredictsMotionsThatItWasNotFittedTo) {
  ToyLaws truth;
  truth.coulomb += 0.3;
  const FoldDiagnosis found = search(onceMeasured(truth));
  ASSERT_FALSE(found.verdict.findings.empty());
  const Finding& first = found.verdict.findings.front();
  EXPECT_EQ(first.cause, "coulomb_friction");
  EXPECT_NEAR(first.numbers[0].deviation, 0.3, 0.05);
  EXPECT_LT(first.numbers[0].low, first.numbers[0].high);
  EXPECT_LT(found.after.mean(), 0.7 * found.before.mean());
  EXPECT_FALSE(found.verdict.with_repeats);
}

TEST(FoldSearch, LeavesASoundJointAlone) {
  const FoldDiagnosis found = search(onceMeasured({}));
  for (const Finding& one : found.verdict.findings) EXPECT_TRUE(one.small) << one.cause;
}

TEST(FoldSearch, SaysUnfinishedOutOfBudgetNeverUnknown) {
  ToyLaws truth;
  truth.coulomb += 0.3;
  const FoldDiagnosis found = search(onceMeasured(truth), 1);
  EXPECT_EQ(found.verdict.verdict, Verdict::Unfinished);
  EXPECT_EQ(found.verdict.not_tried.size(), searchedFor().size());
  EXPECT_TRUE(found.verdict.rejected.empty());
}

TEST(FoldSearch, NeedsTwoFolds) {
  const ToyJoint joint = onceMeasured({}, 1);
  EXPECT_THROW(search(joint), InputError);
}

}  // namespace
}  // namespace nao::validation

// The preset "quick" as a test: counts that a change of the diagnosis must not make worse. Seeds
// are fixed; sets are recorded from limbs alone, those in which something is hidden from heads and
// arms, which take a third of a leg's time: the thesis' cases have legs and whole robots. Weak
// effects, pairs, strangers and the sets of limbs and of robots on their feet are left to
// `usarnaoqi bench diagnosis`: a single one can take minutes.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <future>

#include "tests/core/temporary_folder.h"
#include "tests/hidden/figures.h"
#include "tests/hidden/preset.h"
#include "tests/hidden/trial.h"

namespace nao::hidden {
namespace {

constexpr std::uint64_t kSeed = 2026;  // free choice, made once

struct Trials {
  Figures figures;
  std::string wrong;
};

// What is hidden in one joint moves to one that is quickly simulated.
void lighten(HiddenCase& hidden, std::size_t which) {
  static const std::vector<std::string> kLight{"HeadYaw", "LElbowRoll", "RElbowYaw", "HeadPitch",
                                               "LShoulderPitch"};
  if (hidden.wishes.empty() || hidden.joints.size() > 1) return;
  hidden.joints = {kLight[which % kLight.size()]};
  hidden.other_places.clear();
  for (std::size_t i = 1; i < kLight.size(); ++i) {
    hidden.other_places.push_back(kLight[(which + i) % kLight.size()]);
  }
}

// Two at a time, whoever is free takes the next: a child diagnoses each, and CI has two cores.
Trials tryCases(const std::function<bool(const HiddenCase&)>& chosen) {
  const TemporaryFolder folder;
  TrialPlace place;
  place.program = NAO_PROGRAM;
  place.robots_dir = NAO_SOURCE_DIR "/robots";
  place.folder = folder.path();
  std::vector<HiddenCase> cases = makeCases(countsOf("quick"), kSeed);
  const auto left_out = [&](const HiddenCase& hidden) { return !chosen(hidden); };
  cases.erase(std::remove_if(cases.begin(), cases.end(), left_out), cases.end());
  std::vector<std::string> lines(cases.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < cases.size(); i = next++) {
      cases[i].limbs = true;
      lighten(cases[i], i);
      lines[i] = runTrial(cases[i], place);
    }
  };
  std::future<void> other = std::async(std::launch::async, work);
  work();
  other.get();
  return {figuresOf(lines), listWrong(lines)};
}

bool isNull(const HiddenCase& hidden) {
  return hidden.wishes.empty() && hidden.spoil == Spoil::None;
}

TEST(QuickTrials, NothingIsNamedInNulls) {
  const Trials trials = tryCases(isNull);
  const Figures& f = trials.figures;
  EXPECT_GE(f.exact_nulls + f.near_nulls + f.mujoco_nulls, 2);
  EXPECT_EQ(f.exact_null_false_alarms, 0) << trials.wrong;
  EXPECT_EQ(f.near_null_false_alarms, 0) << trials.wrong;
  EXPECT_EQ(f.mujoco_null_false_alarms, 0) << trials.wrong;
}

TEST(QuickTrials, SinglesAreNamed) {
  const Trials trials = tryCases([](const HiddenCase& hidden) {
    const bool single = hidden.kind == Kind::Single || hidden.kind == Kind::MujocoSingle;
    return single && hidden.level == "joint";
  });
  const Figures& f = trials.figures;
  EXPECT_GE(f.singles + f.mujoco_singles, 4);
  EXPECT_GE(f.singles_exact + f.mujoco_singles_exact, f.singles + f.mujoco_singles - 1)
      << trials.wrong;
  EXPECT_EQ(f.singles_named_wrong + f.mujoco_singles_named_wrong, 0) << trials.wrong;
}

TEST(QuickTrials, DataFaultsAreCalledByTheirKind) {
  const Trials trials =
      tryCases([](const HiddenCase& hidden) { return hidden.kind == Kind::DataFault; });
  EXPECT_GE(trials.figures.data_fault_sets, 5);
  EXPECT_EQ(trials.figures.data_faults_named, trials.figures.data_fault_sets) << trials.wrong;
}

}  // namespace
}  // namespace nao::hidden

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/check.h"
#include "tests/core/temporary_folder.h"
#include "tests/hidden/laws/laws.h"
#include "tests/hidden/trial.h"

namespace nao::hidden {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

HiddenCase smallCase(Kind kind) {
  HiddenCase hidden;
  hidden.kind = kind;
  hidden.seed = 700123;
  hidden.joints = {"HeadYaw"};
  hidden.repeats = 3;
  hidden.seconds = 1;
  hidden.limbs = true;
  return hidden;
}

class Sealed : public testing::Test {
 protected:
  TrialPlace place() const {
    TrialPlace place;
    place.program = NAO_PROGRAM;
    place.robots_dir = NAO_SOURCE_DIR "/robots";
    place.folder = folder_.path();
    return place;
  }
  TemporaryFolder folder_;
};

TEST_F(Sealed, NothingInASetSaysWhatItHoldsOrHowItWasMade) {
  HiddenCase hidden = smallCase(Kind::Single);
  hidden.wishes = {{likenessHideouts().front(), 8}};
  const SealedSet sealed = sealSet(hidden, place());
  ASSERT_TRUE(sealed.truth.shortfall.empty()) << sealed.truth.shortfall;
  EXPECT_TRUE(fs::exists(sealed.truth_file));
  std::vector<std::string> secrets{"700123", "seed",      "hidden",   "truth",
                                   "single", "null",      "stranger", "process_n",
                                   "limbs",  "reference", "effect",   "undeclared"};
  for (const sim::EffectType& type : hiddenEffects().types()) {
    if (type.name != "start_pose") secrets.push_back(type.name);  // a key of the format too
  }
  secrets.push_back(std::to_string(sealed.truth.torque_sd));
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(sealed.folder)) {
    if (!entry.is_regular_file()) continue;
    ++files;
    const std::string text = read(entry.path()) + entry.path().filename().string();
    for (const std::string& secret : secrets) {
      EXPECT_EQ(text.find(secret), std::string::npos) << secret << " in " << entry.path();
    }
  }
  EXPECT_EQ(files, 22);  // meta.json and three repeats of seven motions
}

TEST_F(Sealed, TheReportIsTheSameToTheByteWithoutTheTruth) {
  HiddenCase hidden = smallCase(Kind::Single);
  hidden.wishes = {{likenessHideouts().front(), 12}};
  const SealedSet sealed = sealSet(hidden, place());
  ASSERT_TRUE(sealed.truth.shortfall.empty()) << sealed.truth.shortfall;
  const std::string out = folder_.path() + "/report";
  const Diagnosed with = diagnoseSealed(sealed.folder, hidden.robot(), out, place());
  fs::remove_all(out);
  ASSERT_TRUE(fs::remove(sealed.truth_file));
  const Diagnosed without = diagnoseSealed(sealed.folder, hidden.robot(), out, place());
  EXPECT_FALSE(with.report.empty());
  EXPECT_EQ(with.report, without.report);
  EXPECT_EQ(with.exit_code, without.exit_code);
}

TEST_F(Sealed, SwappedJointsAreADataFaultNotACause) {
  HiddenCase hidden = smallCase(Kind::DataFault);
  hidden.joints = {"HeadYaw", "HeadPitch"};
  hidden.seconds = 6;
  hidden.spoil = Spoil::SwapJoints;
  const SealedSet sealed = sealSet(hidden, place());
  const Diagnosed said =
      diagnoseSealed(sealed.folder, hidden.robot(), folder_.path() + "/report", place());
  EXPECT_EQ(said.exit_code, 20);
  GivenReport report;
  report.verdict = "data_fault";
  report.faults = readFaults(said.printed);
  EXPECT_TRUE(score(sealed.truth, report).fault_named) << said.printed;
}

Wish wishFor(const std::string& cause, double size) {
  for (const Hideout& hideout : catalogueHideouts()) {
    if (hideout.cause == cause) return {hideout, size};
  }
  ADD_FAILURE() << "no hideout of " << cause;
  return {};
}

// A diagnosis stopped at the coarse encoder: what else was wrong with the joint was not looked for.
TEST_F(Sealed, ACoarseEncoderIsOneCauseBesideOthers) {
  HiddenCase hidden = smallCase(Kind::Pair);
  hidden.wishes = {wishFor("encoder_quantum", 12), wishFor("command_filter", 14)};
  const SealedSet sealed = sealSet(hidden, place());
  ASSERT_TRUE(sealed.truth.shortfall.empty()) << sealed.truth.shortfall;
  const Diagnosed said =
      diagnoseSealed(sealed.folder, hidden.robot(), folder_.path() + "/report", place());
  ASSERT_FALSE(said.report.empty()) << said.printed;
  EXPECT_EQ(score(sealed.truth, readReport(said.report)).found, 2) << said.printed;
}

}  // namespace
}  // namespace nao::hidden

#include "validation/diagnosis/report/verdict_record.h"

#include <gtest/gtest.h>

#include "core/check.h"
#include "tests/core/temporary_folder.h"
#include "validation/diagnosis/report/diagnosis_json.h"

namespace nao::validation {
namespace {

const StatementKind kNamed{"joint", "named", "large", "angle", "5 or more"};

TEST(VerdictRecords, CountByKindAndEngine) {
  VerdictRecords records;
  for (int i = 0; i < 5; ++i) records.add(kNamed, "own", {i < 3, i == 4, 1});
  records.add(kNamed, "MuJoCo", {1, 0, 1});
  EXPECT_EQ(records.textOf(kNamed), "named: right 3 of 5, wrong 1 (sets of MuJoCo: right 1 of 1)");
  StatementKind other = kNamed;
  other.size = "clear";
  EXPECT_EQ(records.textOf(other), "no hidden sets of this kind on record");
}

TEST(VerdictRecords, AreReadAsTheyWereWritten) {
  const TemporaryFolder folder;
  VerdictRecords records;
  records.add(kNamed, "own", {93, 2, 100});
  records.add({"joint", "no_discrepancy", "any", "angle and current", "1"}, "MuJoCo", {7, 0, 9});
  const VerdictRecords again = VerdictRecords::read(folder.write("record.yaml", records.yaml()));
  EXPECT_EQ(again.yaml(), records.yaml());
  EXPECT_EQ(again.textOf(kNamed), "named: right 93 of 100, wrong 2");
  const std::string none = folder.write("none.yaml", VerdictRecords().yaml());
  EXPECT_EQ(VerdictRecords::read(none).yaml(), VerdictRecords().yaml());
}

TEST(VerdictRecords, OfTheRepositoryCanBeRead) {
  EXPECT_NO_THROW(VerdictRecords::read(NAO_SOURCE_DIR "/validation/record/diagnosis.yaml"));
}

TEST(VerdictRecords, RefuseMoreRightThanThereWere) {
  const TemporaryFolder folder;
  std::string yaml = [] {
    VerdictRecords records;
    records.add(kNamed, "own", {1, 0, 1});
    return records.yaml();
  }();
  yaml.replace(yaml.find("right: 1"), 8, "right: 2");
  EXPECT_THROW(VerdictRecords::read(folder.write("record.yaml", yaml)), InputError);
}

TEST(VerdictRecords, EveryFindingOfInterestShowsItsOwn) {
  SetDiagnosis diagnosis;
  diagnosis.joints.resize(2);
  JointVerdict& joint = diagnosis.joints[0];
  joint.verdict = Verdict::PartlyExplained;
  joint.critical_gain = 10;
  joint.findings.resize(4);
  for (Finding& finding : joint.findings) finding.gain = 1000;
  joint.findings[0].small = true;
  joint.findings[1].rivals = {{"another", "another", "", {}, 1}};
  joint.findings[2].rivals = {whatHasNoName()};
  joint.findings[3].gain = 12;
  VerdictRecords records;
  records.add({"joint", "ambiguous", "large", "angle", "5 or more"}, "own", {4, 0, 5});
  addRecords(diagnosis, records, "joint", "angle", 6);
  EXPECT_EQ(joint.findings[0].record, "");
  EXPECT_EQ(joint.findings[1].record, "ambiguous: right 4 of 5");
  EXPECT_EQ(joint.findings[2].kind.verdict, "partly_explained");
  EXPECT_EQ(joint.findings[3].kind.verdict, "named");
  EXPECT_EQ(joint.findings[3].kind.size, "near the threshold");
  EXPECT_EQ(joint.record, "");
  EXPECT_EQ(diagnosis.joints[1].kind.verdict, "no_discrepancy");
  EXPECT_EQ(diagnosis.joints[1].record, "no hidden sets of this kind on record");
  EXPECT_NE(toJson(diagnosis, {}).find("ambiguous: right 4 of 5"), std::string::npos);
  EXPECT_NE(toText(diagnosis).find("ambiguous: right 4 of 5"), std::string::npos);
}

}  // namespace
}  // namespace nao::validation

#include "tests/hidden/track_record.h"

#include <gtest/gtest.h>

#include "tests/core/temporary_folder.h"

namespace nao::hidden {
namespace {

std::string line(const std::string& kind, const std::string& outcome) {
  return R"({"name":"0123456789abcdef","truth":{"kind":")" + kind +
         R"("},"statements":[{"level":"joint","verdict":"named","size":"large",)"
         R"("signals":"angle","repeats":"5 or more",)" +
         outcome + "}]}";
}

const std::string kRight = R"("right":true,"wrong":false)";
const std::string kWrong = R"("right":false,"wrong":true)";
const std::string kNeither = R"("right":false,"wrong":false)";

TEST(TrackRecord, CountsStatementsByTheEngineOfTheirSet) {
  const validation::VerdictRecords records =
      trackRecord({line("single", kRight), line("exact_null", kWrong), line("pair", kNeither),
                   line("mujoco_single", kRight), line("data_fault", kWrong),
                   R"({"name":"skipped","truth":{"kind":"single"},"skipped":"too weak"})"});
  EXPECT_EQ(records.textOf({"joint", "named", "large", "angle", "5 or more"}),
            "named: right 1 of 3, wrong 1 (sets of MuJoCo: right 1 of 1)");
}

TEST(TrackRecord, ItsFileIsReadByTheDiagnosis) {
  const TemporaryFolder folder;
  const std::vector<std::string> lines{line("single", kRight), line("single", kWrong)};
  const std::string file = folder.write("record.yaml", toYaml(trackRecord(lines)));
  EXPECT_EQ(validation::VerdictRecords::read(file).yaml(), trackRecord(lines).yaml());
  EXPECT_EQ(validation::VerdictRecords::read(file).sets(), 2);
}

TEST(TrackRecord, LaterSetsAreAddedToEarlierOnes) {
  const std::vector<std::string> early{line("single", kRight)},
      late{line("single", kWrong), line("data_fault", kWrong)};
  std::vector<std::string> all = early;
  all.insert(all.end(), late.begin(), late.end());
  EXPECT_EQ(trackRecord(late, trackRecord(early)).yaml(), trackRecord(all).yaml());
}

// The file of the repository is what no sets give until hidden sets are judged with this program.
TEST(TrackRecord, OfNoSetsIsEmpty) {
  EXPECT_NE(toYaml({}).find("hidden_sets: 0\ndiagnosis_record: []"), std::string::npos);
}

}  // namespace
}  // namespace nao::hidden

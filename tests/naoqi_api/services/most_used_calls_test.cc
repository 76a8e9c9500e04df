#include <sstream>

#include "tests/naoqi_api/services/services_bench.h"

namespace nao::services {
namespace {

constexpr const char* kTable =
#include "tests/naoqi_api/services/most_used_calls.inc"
    ;

struct Row {
  int rank = 0;
  std::string method;
  std::vector<std::string> services;
};

std::vector<Row> readTable() {
  std::vector<Row> rows;
  std::istringstream lines(kTable);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    std::istringstream words(line);
    Row row;
    words >> row.rank >> row.method;
    for (std::string service; words >> service;) row.services.push_back(service);
    rows.push_back(row);
  }
  return rows;
}

class MostUsedCalls : public ServicesBench {
 protected:
  // The least that any form of a method does.
  std::optional<rpc::Answer> answerOf(const std::string& service, const std::string& method) {
    const auto found = hub_.findService(service);
    std::optional<rpc::Answer> worst;
    if (!found) return worst;
    for (const auto& [uid, declared] : found->methods()) {
      if (declared.name != method) continue;
      worst = worst ? std::max(*worst, declared.answer) : declared.answer;
    }
    return worst;
  }
};

TEST_F(MostUsedCalls, AreDoneOrAsDoneAsAWorldWithoutPeopleAndSoundAllows) {
  const auto rows = readTable();
  ASSERT_EQ(rows.size(), 92U);
  for (const Row& row : rows) {
    for (std::string service : row.services) {
      const bool is_simplified = service.back() == '~';
      if (is_simplified) service.pop_back();
      const auto answer = answerOf(service, row.method);
      ASSERT_TRUE(answer) << row.rank << " " << service << "." << row.method;
      EXPECT_EQ(*answer, is_simplified ? rpc::Answer::Simplified : rpc::Answer::Done)
          << row.rank << " " << service << "." << row.method;
    }
  }
}

}  // namespace
}  // namespace nao::services

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "tests/naoqi_api/services/services_bench.h"

namespace nao::services {
namespace {

namespace fs = std::filesystem;

using AlMemoryIds = ServicesBench;

// Name and parameters of each method by number, as a real robot has them.
std::map<std::uint32_t, std::pair<std::string, std::string>> robotsMethods(const fs::path& table) {
  std::map<std::uint32_t, std::pair<std::string, std::string>> methods;
  std::ifstream file(table);
  for (std::string line; std::getline(file, line);) {
    std::istringstream row(line);
    std::string service, uid, kind, name, parameters;
    std::getline(row, service, ',');
    std::getline(row, uid, ',');
    std::getline(row, kind, ',');
    std::getline(row, name, ',');
    std::getline(row, parameters, ',');
    if (service == "ALMemory" && kind == "fn") {
      methods[static_cast<std::uint32_t>(std::stoul(uid))] = {name, parameters};
    }
  }
  return methods;
}

TEST_F(AlMemoryIds, AreThoseOfARealRobot) {
  const fs::path table =
      fs::path(NAO_SOURCE_DIR) / ".." / "shared/data/api/wire_uids_qiloop_idl_v5.csv";
  if (!fs::exists(table)) GTEST_SKIP() << "needs " << table;
  const auto methods = robotsMethods(table);
  ASSERT_EQ(methods.size(), 68U);
  const auto service = hub_.findService("ALMemory");
  for (const auto& [uid, method] : methods) {
    if (uid < rpc::Service::kFirstUid) continue;
    const rpc::Method* ours = service->findMethod(uid);
    ASSERT_NE(ours, nullptr) << uid << " " << method.first;
    EXPECT_EQ(ours->name, method.first) << uid;
    EXPECT_EQ(ours->parameters_signature, method.second) << uid << " " << method.first;
  }
  // What a V5 does not list comes after its last one.
  for (const auto& [uid, method] : service->methods()) {
    EXPECT_TRUE(methods.count(uid) == 1 || uid > methods.rbegin()->first) << uid << method.name;
  }
}

}  // namespace
}  // namespace nao::services

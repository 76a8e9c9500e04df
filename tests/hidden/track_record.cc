#include "tests/hidden/track_record.h"

#include <nlohmann/json.hpp>
#include <set>

#include "core/check.h"

namespace nao::hidden {
namespace {

using Json = nlohmann::json;

Json parse(const std::string& line) {
  try {
    return Json::parse(line);
  } catch (const Json::exception& error) {
    throw InputError(std::string("results: expected a line of JSON: ") + error.what());
  }
}

std::string engineOf(const std::string& kind) {
  return kind.rfind("mujoco", 0) == 0 ? "MuJoCo" : "own";
}

bool isCounted(const Json& line) {
  return line.contains("statements") && line.at("truth").at("kind") != "data_fault";
}

}  // namespace

validation::VerdictRecords trackRecord(const std::vector<std::string>& lines,
                                       const validation::VerdictRecords& before) {
  validation::VerdictRecords records = before;
  for (const std::string& one : lines) {
    const Json line = parse(one);
    if (!isCounted(line)) continue;
    records.addSets(1);
    const std::string engine = engineOf(line.at("truth").at("kind"));
    for (const Json& said : line.at("statements")) {
      const validation::StatementKind kind{said.at("level"), said.at("verdict"), said.at("size"),
                                           said.at("signals"), said.at("repeats")};
      records.add(kind, engine,
                  {said.at("right").get<bool>() ? 1 : 0, said.at("wrong").get<bool>() ? 1 : 0, 1});
    }
  }
  return records;
}

std::string toYaml(const validation::VerdictRecords& records) {
  return "# How statements of `usarnaoqi diagnose` turned out where the truth was known.\n"
         "# Made by: usarnaoqi bench diagnosis --results ... --record validation/record/"
         "diagnosis.yaml\n" +
         records.yaml();
}

}  // namespace nao::hidden

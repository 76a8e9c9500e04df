#include "tests/hidden/result_line.h"

#include "core/check.h"

namespace nao::hidden {

nlohmann::ordered_json parseResult(const std::string& line) {
  try {
    return nlohmann::ordered_json::parse(line);
  } catch (const nlohmann::ordered_json::exception& error) {
    throw InputError(std::string("results: expected a line of JSON: ") + error.what());
  }
}

}  // namespace nao::hidden

#include "naoqi_api/services/version_newer.h"

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/check.h"

namespace nao::services {
namespace {

constexpr char kTable[] =
#include "naoqi_api/services/version_newer.inc"
    ;

/// What a release was the first to have.
struct Newer {
  int release = 0;
  std::string service;
  std::set<std::string> methods;  // none: the whole service
};

// A line that begins with a space goes on with the one before.
std::vector<Newer> readTable() {
  std::vector<Newer> table;
  std::istringstream lines(kTable);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    std::istringstream words(line);
    if (line[0] != ' ') {
      Newer newer;
      NAO_CHECK(words >> newer.release >> newer.service);
      table.push_back(std::move(newer));
    }
    for (std::string method; words >> method;) table.back().methods.insert(method);
  }
  return table;
}

}  // namespace

void removeNewer(rpc::ServiceHub& hub, int release) {
  for (const Newer& newer : readTable()) {
    if (release >= newer.release) continue;
    const auto* entry = hub.find(newer.service);
    if (!entry) continue;
    if (newer.methods.empty()) {
      hub.remove(entry->id);
    } else {
      entry->service->removeMethods(newer.methods);
    }
  }
}

}  // namespace nao::services

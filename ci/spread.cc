#include "ci/spread.h"

#include <cstdio>
#include <set>

#include "core/check.h"
#include "core/config.h"
#include "core/random.h"

namespace nao::ci {
namespace {

std::string exactly(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", number);
  return text;
}

// What the map at `spread` draws; the key is taken out.
std::map<std::string, double> take(ConfigNode& scenario, std::uint64_t seed) {
  std::map<std::string, double> drawn;
  for (std::size_t i = 0; i < scenario.keys.size(); ++i) {
    if (scenario.keys[i] != "spread") continue;
    Config::read(scenario.children[i], [&](Config& spread) {
      for (const std::string& name : spread.keys()) {
        const auto range = spread.numbers(name, 2);
        if (range[0] > range[1]) spread.fail("`" + name + "`: expected [low, high]");
        drawn[name] = Random(seed, name).uniform(range[0], range[1]);
      }
    });
    scenario.keys.erase(scenario.keys.begin() + static_cast<std::ptrdiff_t>(i));
    scenario.children.erase(scenario.children.begin() + static_cast<std::ptrdiff_t>(i));
    break;
  }
  return drawn;
}

void putIn(ConfigNode& node, const std::map<std::string, double>& drawn,
           std::set<std::string>& used) {
  for (ConfigNode& child : node.children) putIn(child, drawn, used);
  if (node.kind != ConfigNode::Kind::Scalar || node.text.empty() || node.text[0] != '$') return;
  const auto found = drawn.find(node.text.substr(1));
  if (found == drawn.end()) {
    throw InputError(complaint(node, "there is no '" + node.text.substr(1) + "' in `spread`"));
  }
  used.insert(found->first);
  node.text = exactly(found->second);
}

}  // namespace

std::map<std::string, double> drawSpread(ConfigNode& scenario, std::uint64_t seed) {
  if (scenario.kind != ConfigNode::Kind::Map) return {};  // told by who reads it
  const auto drawn = take(scenario, seed);
  std::set<std::string> used;
  putIn(scenario, drawn, used);
  for (const auto& [name, number] : drawn) {
    if (used.count(name)) continue;
    throw InputError(complaint(scenario, "`spread`: nothing uses $" + name));
  }
  return drawn;
}

}  // namespace nao::ci

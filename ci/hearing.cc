#include "ci/hearing.h"

#include <set>
#include <utility>

#include "core/overloaded.h"

namespace nao::ci {
namespace {

HeardValue heard(const rpc::Value& value) {
  const std::string* text = value.findText();
  return {text ? *text : value.print(), value.findNumber()};
}

}  // namespace

Hearing::Hearing(const Scenario& scenario, std::vector<memory::RobotMemory*> memories)
    : memories_(std::move(memories)) {
  std::set<std::pair<std::size_t, std::string>> events, keys;
  for (const Expectation& expectation : scenario.expectations) {
    std::visit(Overloaded{[&](const EventRaised& c) {
                            events.insert({c.robot, c.key});
                          },
                          [&](const TextSaid& c) {
                            events.insert({c.robot, "ALTextToSpeech/CurrentSentence"});
                          },
                          [&](const MemoryIs& c) {
                            keys.insert({c.robot, c.key});
                          },
                          [](const auto&) {}},
               expectation.condition);
  }
  for (const auto& [robot, key] : events) listen(robot, key);
  keys_.assign(keys.begin(), keys.end());
}

void Hearing::listen(std::size_t robot, const std::string& key) {
  listeners_.push_back(memories_[robot]->store().listen(
      key, [this, robot](const std::string& name, const rpc::Value& value) {
        events_.push_back({robot, name, heard(value)});
      }));
}

Heard Hearing::take() {
  Heard all;
  all.events = std::exchange(events_, {});
  for (const auto& [robot, key] : keys_) {
    const auto value = memories_[robot]->read(key);
    if (value) all.memory[{robot, key}] = heard(value->value);
  }
  return all;
}

}  // namespace nao::ci

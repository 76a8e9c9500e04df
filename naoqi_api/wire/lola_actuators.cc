#include "naoqi_api/wire/lola_actuators.h"

#include <algorithm>
#include <cmath>

#include "core/lola_joints.h"
#include "naoqi_api/call_error.h"
#include "naoqi_api/wire/lola_leds.h"

namespace nao::wire {
namespace {

using rpc::CallError;
using rpc::Value;

std::string shortly(std::string text) {
  constexpr std::size_t kLongest = 40;
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
  return text;
}

std::string keyOf(const Value& key) {
  if (const std::string* text = key.findText()) return *text;
  const rpc::SharedBytes bytes = key.findBytes();
  if (!bytes) throw CallError("expected texts as keys, found " + shortly(key.print()));
  return {bytes->begin(), bytes->end()};
}

const std::vector<Value>& itemsOf(const std::string& key, const Value& value, std::size_t count) {
  const std::vector<Value>* items = value.findItems();
  if (items && items->size() == count) return *items;
  throw CallError(key + ": expected a list of " + std::to_string(count) + " numbers, found " +
                  (items ? std::to_string(items->size()) + " items" : shortly(value.print())));
}

std::vector<double> numbersOf(const std::string& key, const Value& value, std::size_t count) {
  std::vector<double> numbers;
  for (const Value& item : itemsOf(key, value, count)) {
    const auto number = item.isNumber() ? item.findNumber() : std::nullopt;
    if (!number || !std::isfinite(*number)) {
      throw CallError(key + "[" + std::to_string(numbers.size()) + "]: expected a number, found " +
                      shortly(item.print()));
    }
    numbers.push_back(*number);
  }
  return numbers;
}

// Sonars always measure here; what clients say of them is only checked.
void checkSonar(const std::string& key, const Value& value) {
  for (const Value& item : itemsOf(key, value, 2)) {
    if (!item.find<bool>() && !item.isNumber()) {
      throw CallError(key + ": expected two times true or false, found " + shortly(value.print()));
    }
  }
}

void readEntry(LolaActuators& read, const std::string& key, const Value& value) {
  if (key == "Position") {
    read.position = numbersOf(key, value, kLolaJoints.size());
  } else if (key == "Stiffness") {
    read.stiffness = numbersOf(key, value, kLolaJoints.size());
  } else if (key == "Sonar") {
    checkSonar(key, value);
  } else {
    const auto leds = std::find_if(lolaLeds().begin(), lolaLeds().end(),
                                   [&](const LolaLeds& some) { return some.key == key; });
    if (leds == lolaLeds().end()) return read.unknown.push_back(shortly(key));
    const auto numbers = numbersOf(key, value, leds->names.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      read.leds.emplace_back(leds->names[i], std::clamp(numbers[i], 0.0, 1.0));
    }
  }
}

}  // namespace

LolaActuators readLolaActuators(const Value& frame) {
  const auto* map = frame.find<Value::Map>();
  if (!map) throw CallError("expected a map of lists, found " + shortly(frame.print()));
  LolaActuators read;
  for (const auto& [key, value] : map->entries) readEntry(read, keyOf(key), value);
  return read;
}

}  // namespace nao::wire

#include "naoqi_api/services/dcm_commands.h"

#include <cmath>
#include <utility>

#include "naoqi_api/call_error.h"
#include "naoqi_api/convert.h"
#include "naoqi_api/services/finite.h"

namespace nao::services {
namespace {

using motion::DirectCommands;
using rpc::CallError;
using rpc::Value;
using Items = std::vector<Value>;

const Items& itemsOf(const Value& value, const char* expected) {
  const Items* items = value.findItems();
  if (!items) throw CallError(std::string("expected ") + expected + ", got " + value.print());
  return *items;
}

DirectCommands::Merge readMerge(const Value& value) {
  const std::string name = value.to<std::string>();
  if (name == "ClearAll") return DirectCommands::Merge::ClearAll;
  if (name == "Merge") return DirectCommands::Merge::Merge;
  if (name == "ClearAfter") return DirectCommands::Merge::ClearAfter;
  if (name == "ClearBefore") return DirectCommands::Merge::ClearBefore;
  throw CallError("unknown update type: " + name +
                  ", expected ClearAll, Merge, ClearAfter or ClearBefore");
}

float readNumber(const Value& value) { return static_cast<float>(finite(value.to<float>())); }

DcmCommand readCommand(const Value& value) {
  const Items& items = itemsOf(value, "[value, time]");
  if (items.size() < 2 || items.size() > 3) throw CallError("expected [value, time]");
  return {readNumber(items[0]), items[1].to<std::int32_t>()};
}

std::vector<DcmCommand> readTrack(const Value& value) {
  std::vector<DcmCommand> track;
  for (const Value& item : itemsOf(value, "[[value, time], ...]")) {
    track.push_back(readCommand(item));
  }
  return track;
}

std::vector<std::vector<DcmCommand>> readSeparate(const Value& times, const Value& values) {
  const auto moments = times.to<std::vector<std::int32_t>>();
  std::vector<std::vector<DcmCommand>> tracks;
  for (const Value& of_one : itemsOf(values, "[[value, ...] of each actuator]")) {
    const Items& list = itemsOf(of_one, "[value, ...]");
    if (list.size() != moments.size()) throw CallError("expected as many values as times");
    std::vector<DcmCommand> track;
    for (std::size_t i = 0; i < list.size(); ++i) {
      track.push_back({readNumber(list[i]), moments[i]});
    }
    tracks.push_back(std::move(track));
  }
  return tracks;
}

}  // namespace

DcmCommands readDcmSet(const Value& commands) {
  const Items& items = itemsOf(commands, "[name, update type, [[value, time], ...]]");
  if (items.size() != 3) throw CallError("expected [name, update type, [[value, time], ...]]");
  return {items[0].to<std::string>(), readMerge(items[1]), {readTrack(items[2])}};
}

DcmCommands readDcmSetAlias(const Value& commands) {
  const char* expected = "[alias, update type, time-separate or time-mixed, ...]";
  const Items& items = itemsOf(commands, expected);
  if (items.size() < 4) throw CallError(std::string("expected ") + expected);
  DcmCommands read{items[0].to<std::string>(), readMerge(items[1]), {}};
  const std::string kind = items[2].to<std::string>();
  if (kind == "time-separate" && items.size() == 6) {
    read.tracks = readSeparate(items[4], items[5]);
  } else if (kind == "time-mixed" && items.size() == 4) {
    for (const Value& track : itemsOf(items[3], "a list of each actuator's commands")) {
      read.tracks.push_back(readTrack(track));
    }
  } else {
    throw CallError(std::string("expected ") + expected + ", got " + kind + " with " +
                    std::to_string(items.size()) + " items");
  }
  return read;
}

}  // namespace nao::services

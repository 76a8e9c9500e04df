#include "naoqi_api/services/kept_lines.h"

#include <fstream>
#include <utility>

#include "naoqi_api/call_error.h"
#include "naoqi_api/convert.h"
#include "naoqi_api/services/data_files.h"
#include "naoqi_api/wire/json_codec.h"

namespace nao::services {
namespace {

using rpc::CallError;
using rpc::Value;

constexpr int kVersion = 1;
constexpr char kBroken[] = ".broken";
constexpr char kNew[] = ".new";

std::string asJson(const KeptLines::Line& line) {
  Value::Map map{"s", "m", {}};
  for (const auto& [name, value] : line) map.entries.emplace_back(name, value);
  const wire::NameOf refuse = [](const rpc::ObjectRef&) -> std::string {
    throw CallError("an object can not be kept");
  };
  wire::JsonWriter writer(refuse);
  writer.write(Value(std::move(map)));
  return writer.json();
}

std::optional<KeptLines::Line> readLine(const std::string& text) {
  const auto value = wire::readJson(text);
  const auto* map = value ? value->find<Value::Map>() : nullptr;
  if (!map) return std::nullopt;
  KeptLines::Line line;
  for (const auto& [key, item] : map->entries) line.emplace_back(key.to<std::string>(), item);
  return line;
}

bool hasAll(const KeptLines::Line& line, const std::vector<std::string>& wanted) {
  for (const std::string& name : wanted) {
    if (!KeptLines::find(line, name)) return false;
  }
  return true;
}

}  // namespace

KeptLines::KeptLines(std::filesystem::path data_dir, std::string name, std::string kind)
    : data_dir_(std::move(data_dir)), name_(std::move(name)), kind_("usarnaoqi " + kind) {}

std::optional<std::vector<KeptLines::Line>> KeptLines::read(
    const std::vector<std::string>& wanted) const {
  const auto path = findDataFile(data_dir_, name_);
  if (!path) return std::nullopt;
  std::ifstream stream(*path);
  std::vector<Line> lines;
  std::string text;
  for (int number = 1; std::getline(stream, text); ++number) {
    const auto line = readLine(text);
    const std::string place = name_ + ":" + std::to_string(number) + ": ";
    if (number == 1) {
      const Value* format = line ? find(*line, "format") : nullptr;
      const Value* version = line ? find(*line, "version") : nullptr;
      if (!format || *format != Value(kind_) || !version || *version != Value(kVersion)) {
        throw CallError(place + "expected {\"format\": \"" + kind_ + "\", \"version\": 1}");
      }
    } else if (!line || !hasAll(*line, wanted)) {
      throw CallError(place + "expected an object with " + rpc::toValue(wanted).print());
    } else {
      lines.push_back(*line);
    }
  }
  return lines;
}

void KeptLines::write(const std::vector<Line>& lines) const {
  std::string text = asJson({{"format", kind_}, {"version", kVersion}}) + "\n";
  for (const Line& line : lines) text += asJson(line) + "\n";
  writeDataFile(data_dir_, name_ + kNew, text);
  std::error_code failed;
  std::filesystem::rename(dataPath(data_dir_, name_ + kNew), dataPath(data_dir_, name_), failed);
  if (failed) throw CallError("the file can not be written: " + name_);
}

std::string KeptLines::putAside() const {
  try {
    std::error_code failed;
    std::filesystem::rename(dataPath(data_dir_, name_), dataPath(data_dir_, name_ + kBroken),
                            failed);
    return failed ? name_ : name_ + kBroken;
  } catch (const CallError&) {
    return name_;  // behind a link
  }
}

void KeptLines::check(const Line& line) {
  if (!readLine(asJson(line))) throw CallError("the value is too deep or too large to be kept");
}

const Value* KeptLines::find(const Line& line, const std::string& name) {
  for (const auto& [known, value] : line) {
    if (known == name) return &value;
  }
  return nullptr;
}

}  // namespace nao::services

#include "core/config_node.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include "core/check.h"

namespace nao {
namespace {

using FileName = std::shared_ptr<const std::string>;

int lineOf(const YAML::Mark& mark) { return mark.is_null() ? 1 : mark.line + 1; }

ConfigNode convert(const YAML::Node& yaml, const FileName& file);

void convertMap(const YAML::Node& yaml, const FileName& file, ConfigNode& node) {
  node.kind = ConfigNode::Kind::Map;
  for (const auto& entry : yaml) {
    const int line = lineOf(entry.first.Mark());
    if (!entry.first.IsScalar()) {
      throw InputError(complaint(*file, line, "expected a word as key, found a list or map"));
    }
    const std::string key = entry.first.Scalar();
    if (std::count(node.keys.begin(), node.keys.end(), key) > 0) {
      throw InputError(complaint(*file, line, "`" + key + "`: given twice"));
    }
    node.keys.push_back(key);
    node.children.push_back(convert(entry.second, file));
    node.children.back().line = line;  // of the key: an empty value has no place of its own
  }
}

ConfigNode convert(const YAML::Node& yaml, const FileName& file) {
  ConfigNode node;
  node.file = file;
  node.line = lineOf(yaml.Mark());
  if (yaml.IsScalar()) {
    node.kind = ConfigNode::Kind::Scalar;
    node.text = yaml.Scalar();
  } else if (yaml.IsSequence()) {
    node.kind = ConfigNode::Kind::List;
    for (const YAML::Node& child : yaml) node.children.push_back(convert(child, file));
  } else if (yaml.IsMap()) {
    convertMap(yaml, file, node);
  }
  return node;
}

}  // namespace

std::string ConfigNode::described() const {
  switch (kind) {
    case Kind::Empty:
      return "nothing";
    case Kind::Scalar:
      return "'" + text + "'";
    case Kind::List:
      return "a list";
    case Kind::Map:
      return "a map";
  }
  return {};
}

const ConfigNode* ConfigNode::find(const std::string& key) const {
  const auto found = std::find(keys.begin(), keys.end(), key);
  if (found == keys.end()) return nullptr;
  return &children[static_cast<std::size_t>(found - keys.begin())];
}

ConfigNode parseConfigFile(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file + ": can not be read");
  try {
    return convert(YAML::Load(stream), std::make_shared<const std::string>(file));
  } catch (const YAML::Exception& problem) {
    throw InputError(complaint(file, lineOf(problem.mark), "not YAML: " + problem.msg));
  }
}

std::optional<double> parseNumber(const std::string& text) {
  const char* begin = text.data();
  const char* end = begin + text.size();
  if (begin != end && *begin == '+') ++begin;
  double value = 0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string complaint(const std::string& file, int line, const std::string& sentence) {
  return file + ":" + std::to_string(line) + ": " + sentence;
}

std::string complaint(const ConfigNode& node, const std::string& sentence) {
  return complaint(*node.file, node.line, sentence);
}

}  // namespace nao

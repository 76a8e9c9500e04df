#include "core/config.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/check.h"
#include "core/config_node.h"

namespace nao {
namespace {

using Kind = ConfigNode::Kind;

[[noreturn]] void throwAt(const ConfigNode& node, const std::string& key,
                          const std::string& expected, const std::string& found) {
  throw InputError(complaint(node, "`" + key + "`: expected " + expected + ", found " + found));
}

std::string expectedNumber(Interval accepted) {
  std::ostringstream text;
  if (accepted.low == kPositive.low && std::isinf(accepted.high)) return "a number above 0";
  if (std::isinf(accepted.low) && std::isinf(accepted.high)) return "a number";
  if (std::isinf(accepted.high)) {
    text << "a number from " << accepted.low << " up";
  } else {
    text << "a number in [" << accepted.low << ", " << accepted.high << "]";
  }
  return text.str();
}

double toNumber(const std::string& key, const ConfigNode& node, Interval accepted) {
  const auto value = node.kind == Kind::Scalar ? parseNumber(node.text) : std::nullopt;
  if (!value || *value < accepted.low || *value > accepted.high) {
    throwAt(node, key, expectedNumber(accepted), node.described());
  }
  return *value;
}

std::string toText(const std::string& key, const ConfigNode& node) {
  if (node.kind != Kind::Scalar || node.text.empty()) {
    throwAt(node, key, "a word", node.described());
  }
  return node.text;
}

std::vector<double> toNumbers(const std::string& key, const ConfigNode& node, std::size_t count,
                              Interval accepted) {
  const std::string expected =
      count == 0 ? "a list of numbers" : "a list of " + std::to_string(count) + " numbers";
  if (node.kind != Kind::List) throwAt(node, key, expected, node.described());
  if (count != 0 && node.children.size() != count) {
    throwAt(node, key, expected, std::to_string(node.children.size()));
  }
  std::vector<double> values;
  for (const ConfigNode& child : node.children) {
    values.push_back(toNumber(key, child, accepted));
  }
  return values;
}

const std::vector<ConfigNode>& toList(const std::string& key, const ConfigNode& node) {
  if (node.kind != Kind::List) throwAt(node, key, "a list", node.described());
  return node.children;
}

}  // namespace

void Config::read(const std::string& file, const Visitor& visit) {
  read(parseConfigFile(file), visit);
}

void Config::read(const ConfigNode& root, const Visitor& visit) {
  if (root.kind != Kind::Map) {
    throw InputError(complaint(root, "expected keys, found " + root.described()));
  }
  visitMap(root, "", visit);
}

void Config::visitMap(const ConfigNode& node, const std::string& key, const Visitor& visit) {
  if (node.kind != Kind::Map) throwAt(node, key, "a map of keys", node.described());
  Config config(node);
  visit(config);
  config.rejectUnknownKeys();
}

const ConfigNode* Config::find(const std::string& key) {
  asked_.insert(key);
  return node_.find(key);
}

const ConfigNode& Config::need(const std::string& key, const std::string& expected) {
  const ConfigNode* node = find(key);
  if (node == nullptr) fail("`" + key + "`: missing, expected " + expected);
  return *node;
}

void Config::rejectUnknownKeys() const {
  for (std::size_t i = 0; i < node_.keys.size(); ++i) {
    if (asked_.count(node_.keys[i])) continue;
    std::string known;
    for (const std::string& key : asked_) known += (known.empty() ? "" : ", ") + key;
    throw InputError(complaint(node_.children[i],
                               "`" + node_.keys[i] + "`: unknown key, expected one of " + known));
  }
}

const std::string& Config::file() const { return *node_.file; }

bool Config::has(const std::string& key) { return find(key) != nullptr; }

bool Config::isList(const std::string& key) {
  const ConfigNode* node = find(key);
  return node && node->kind == Kind::List;
}

std::vector<std::string> Config::keys() const { return node_.keys; }

double Config::number(const std::string& key, Interval accepted) {
  return toNumber(key, need(key, expectedNumber(accepted)), accepted);
}

double Config::number(const std::string& key, Interval accepted, double otherwise) {
  return has(key) ? number(key, accepted) : otherwise;
}

int Config::integer(const std::string& key, int low, int high) {
  const std::string expected =
      "a whole number in [" + std::to_string(low) + ", " + std::to_string(high) + "]";
  const ConfigNode& node = need(key, expected);
  const auto value = node.kind == Kind::Scalar ? parseNumber(node.text) : std::nullopt;
  if (!value || *value < low || *value > high || *value != std::floor(*value)) {
    throwAt(node, key, expected, node.described());
  }
  return static_cast<int>(*value);
}

int Config::integer(const std::string& key, int low, int high, int otherwise) {
  return has(key) ? integer(key, low, high) : otherwise;
}

bool Config::flag(const std::string& key, bool otherwise) {
  const ConfigNode* node = find(key);
  if (node == nullptr) return otherwise;
  if (node->kind != Kind::Scalar || (node->text != "true" && node->text != "false")) {
    throwAt(*node, key, "true or false", node->described());
  }
  return node->text == "true";
}

std::string Config::text(const std::string& key) { return toText(key, need(key, "a word")); }

std::string Config::text(const std::string& key, const std::string& otherwise) {
  return has(key) ? text(key) : otherwise;
}

std::vector<std::string> Config::texts(const std::string& key) {
  std::vector<std::string> values;
  for (const ConfigNode& child : toList(key, need(key, "a list of words"))) {
    values.push_back(toText(key, child));
  }
  return values;
}

std::vector<std::pair<std::string, std::string>> Config::pairs(const std::string& key) {
  std::vector<std::pair<std::string, std::string>> values;
  for (const ConfigNode& child : toList(key, need(key, "a list of pairs"))) {
    const auto& words = toList(key, child);
    if (words.size() != 2) throwAt(child, key, "pairs of words", std::to_string(words.size()));
    values.emplace_back(toText(key, words[0]), toText(key, words[1]));
  }
  return values;
}

std::vector<double> Config::numbers(const std::string& key, std::size_t count, Interval accepted) {
  return toNumbers(key, need(key, "a list of numbers"), count, accepted);
}

std::vector<std::vector<double>> Config::rows(const std::string& key, std::size_t width) {
  std::vector<std::vector<double>> values;
  for (const ConfigNode& child : toList(key, need(key, "a list of rows"))) {
    values.push_back(toNumbers(key, child, width, {}));
  }
  return values;
}

Vec3 Config::vector(const std::string& key) {
  const auto values = numbers(key, 3);
  return {values[0], values[1], values[2]};
}

Vec3 Config::vector(const std::string& key, const Vec3& otherwise) {
  return has(key) ? vector(key) : otherwise;
}

Color Config::color(const std::string& key, const Color& otherwise) {
  if (!has(key)) return otherwise;
  const auto values = numbers(key, 3, {0, 255});
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(values[i]); };
  return {byte(0), byte(1), byte(2)};
}

Pose Config::pose() {
  Pose pose = translation(vector("position", Vec3::Zero()));
  const Vec3 rpy = vector("rpy", Vec3::Zero());
  pose.linear() = rotationFromRpy(rpy.x(), rpy.y(), rpy.z());
  return pose;
}

void Config::map(const std::string& key, Presence presence, const Visitor& visit) {
  const ConfigNode* node = presence == Presence::Required ? &need(key, "a map of keys") : find(key);
  if (node != nullptr) visitMap(*node, key, visit);
}

void Config::list(const std::string& key, Presence presence, const Visitor& visit) {
  const ConfigNode* node = presence == Presence::Required ? &need(key, "a list") : find(key);
  if (node == nullptr) return;
  for (const ConfigNode& child : toList(key, *node)) visitMap(child, key, visit);
}

void Config::reject(const std::string& key, const std::string& expected) {
  const ConfigNode& node = need(key, expected);
  throwAt(node, key, expected, node.described());
}

int Config::line() const { return node_.line; }

std::string Config::place() const { return file() + ":" + std::to_string(node_.line); }

void Config::fail(const std::string& sentence) const {
  throw InputError(complaint(node_, sentence));
}

}  // namespace nao

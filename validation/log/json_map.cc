#include "validation/log/json_map.h"

#include <cmath>

#include "core/check.h"

namespace nao::validation {
namespace {

constexpr std::size_t kShown = 40;  // characters of a wrong value; free choice

std::string show(const nlohmann::json& node) {
  std::string text = node.dump();
  if (text.size() > kShown) text = text.substr(0, kShown) + " ...";
  return text;
}

}  // namespace

JsonMap::JsonMap(const nlohmann::json& node, std::string place)
    : node_(node), place_(std::move(place)) {
  if (!node_.is_object()) {
    throw InputError(place_ + ": expected an object {...}, found " + show(node_));
  }
}

void JsonMap::reject(const std::string& key, const std::string& expected) const {
  const std::string found = node_.contains(key) ? show(node_[key]) : "nothing";
  throw InputError(place_ + "." + key + ": expected " + expected + ", found " + found);
}

const nlohmann::json& JsonMap::need(const std::string& key, const std::string& expected) {
  if (!has(key)) reject(key, expected);
  return node_[key];
}

bool JsonMap::has(const std::string& key) {
  asked_.insert(key);
  return node_.contains(key) && !node_[key].is_null();
}

std::string JsonMap::text(const std::string& key) {
  const nlohmann::json& value = need(key, "a text");
  if (!value.is_string()) reject(key, "a text");
  return value.get<std::string>();
}

std::string JsonMap::text(const std::string& key, const std::string& otherwise) {
  return has(key) ? text(key) : otherwise;
}

double JsonMap::number(const std::string& key) {
  const nlohmann::json& value = need(key, "a number");
  if (!value.is_number() || !std::isfinite(value.get<double>())) reject(key, "a number");
  return value.get<double>();
}

double JsonMap::number(const std::string& key, double otherwise) {
  return has(key) ? number(key) : otherwise;
}

int JsonMap::integer(const std::string& key, int otherwise) {
  if (!has(key)) return otherwise;
  const double value = number(key);
  if (value != std::floor(value) || std::abs(value) > 1e9) reject(key, "a whole number");
  return static_cast<int>(value);
}

bool JsonMap::flag(const std::string& key, bool otherwise) {
  if (!has(key)) return otherwise;
  if (!node_[key].is_boolean()) reject(key, "true or false");
  return node_[key].get<bool>();
}

std::vector<double> JsonMap::numbers(const std::string& key, std::size_t count) {
  const std::string expected = std::to_string(count) + " numbers";
  const nlohmann::json& value = need(key, expected);
  if (!value.is_array() || value.size() != count) reject(key, expected);
  std::vector<double> all;
  for (const nlohmann::json& one : value) {
    if (!one.is_number()) reject(key, expected);
    all.push_back(one.get<double>());
  }
  return all;
}

JsonMap JsonMap::map(const std::string& key) {
  return JsonMap(need(key, "an object {...}"), place_ + "." + key);
}

std::vector<JsonMap> JsonMap::list(const std::string& key) {
  const nlohmann::json& value = need(key, "a list [...]");
  if (!value.is_array()) reject(key, "a list [...]");
  std::vector<JsonMap> maps;
  for (std::size_t i = 0; i < value.size(); ++i) {
    maps.emplace_back(value[i], place_ + "." + key + "[" + std::to_string(i) + "]");
  }
  return maps;
}

void JsonMap::finish() const {
  for (const auto& item : node_.items()) {
    if (asked_.count(item.key()) == 0) {
      throw InputError(place_ + "." + item.key() + ": expected no such key");
    }
  }
}

}  // namespace nao::validation

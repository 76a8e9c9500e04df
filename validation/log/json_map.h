#pragma once

#include <nlohmann/json.hpp>
#include <set>
#include <string>

// Private to validation/log/*.cc: a third-party type stays out of headers that others include.
namespace nao::validation {

/// One object of a JSON file, read strictly: a missing key, a wrong type and a key nobody asked for
/// are each an InputError that reads "file: place: expected ..., found ...".
class JsonMap {
 public:
  JsonMap(const nlohmann::json& node, std::string place);

  bool has(const std::string& key);
  std::string text(const std::string& key);
  std::string text(const std::string& key, const std::string& otherwise);
  double number(const std::string& key);
  double number(const std::string& key, double otherwise);
  int integer(const std::string& key, int otherwise);
  bool flag(const std::string& key, bool otherwise);
  std::vector<double> numbers(const std::string& key, std::size_t count);
  JsonMap map(const std::string& key);
  std::vector<JsonMap> list(const std::string& key);

  [[noreturn]] void reject(const std::string& key, const std::string& expected) const;
  /// To be called when all keys have been asked for.
  void finish() const;

 private:
  const nlohmann::json& need(const std::string& key, const std::string& expected);

  const nlohmann::json& node_;
  std::string place_;
  std::set<std::string> asked_;
};

}  // namespace nao::validation

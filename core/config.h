#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/frames.h"
#include "core/shape.h"

namespace nao {

/// The numbers a key accepts, both ends included.
struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};
inline constexpr Interval kPositive{std::numeric_limits<double>::min(),
                                    std::numeric_limits<double>::infinity()};
inline constexpr Interval kNotNegative{0, std::numeric_limits<double>::infinity()};

struct ConfigNode;

/// One map of a YAML file, read strictly: a missing key, a wrong type, a number out of range, a
/// key given twice and a key nobody asked for are each an InputError that reads
///   file:line: `key`: expected a number in [0, 1], found 'x'
/// Maps are visited by a function, so that the check for unknown keys is never forgotten.
class Config {
 public:
  using Visitor = std::function<void(Config&)>;

  /// Parses `file` and visits its top map.
  static void read(const std::string& file, const Visitor& visit);
  /// Visits a map already parsed, whose keys may come from several files.
  static void read(const ConfigNode& root, const Visitor& visit);

  bool has(const std::string& key);
  bool isList(const std::string& key);
  const std::string& file() const;
  int line() const;
  /// "file:line" of this map, for those who can judge its numbers only later.
  std::string place() const;
  /// The keys of this map in file order, for maps whose keys are names chosen by the user.
  std::vector<std::string> keys() const;

  double number(const std::string& key, Interval accepted = {});
  double number(const std::string& key, Interval accepted, double otherwise);
  int integer(const std::string& key, int low, int high);
  int integer(const std::string& key, int low, int high, int otherwise);
  bool flag(const std::string& key, bool otherwise);
  std::string text(const std::string& key);
  std::string text(const std::string& key, const std::string& otherwise);
  std::vector<std::string> texts(const std::string& key);
  /// A list of lists of two words.
  std::vector<std::pair<std::string, std::string>> pairs(const std::string& key);

  /// A list of exactly `count` numbers, or of any number of them for count 0.
  std::vector<double> numbers(const std::string& key, std::size_t count, Interval accepted = {});
  /// A list of lists of `width` numbers.
  std::vector<std::vector<double>> rows(const std::string& key, std::size_t width);
  Vec3 vector(const std::string& key);
  Vec3 vector(const std::string& key, const Vec3& otherwise);
  Color color(const std::string& key, const Color& otherwise);  // [red, green, blue], 0 to 255
  /// `position` [m] and `rpy` [rad]; each may be absent and is zero then.
  Pose pose();

  /// Visits the map at `key`, or each map of the list at `key`. An absent key visits nothing
  /// unless the call says required.
  enum class Presence { Optional, Required };
  void map(const std::string& key, Presence presence, const Visitor& visit);
  void list(const std::string& key, Presence presence, const Visitor& visit);

  /// Throws the InputError for `key` of this map: "file:line: `key`: expected ..., found 'x'".
  [[noreturn]] void reject(const std::string& key, const std::string& expected);
  /// Throws the InputError for this map as a whole: "file:line: <sentence>".
  [[noreturn]] void fail(const std::string& sentence) const;

 private:
  explicit Config(const ConfigNode& node) : node_(node) {}
  static void visitMap(const ConfigNode& node, const std::string& key, const Visitor& visit);
  const ConfigNode* find(const std::string& key);
  const ConfigNode& need(const std::string& key, const std::string& expected);
  void rejectUnknownKeys() const;

  const ConfigNode& node_;
  std::set<std::string> asked_;
};

}  // namespace nao

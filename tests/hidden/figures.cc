#include "tests/hidden/figures.h"

#include <algorithm>
#include <cmath>

#include "tests/hidden/result_line.h"

namespace nao::hidden {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kZ = 1.959964;  // of the normal distribution, 95 % two-sided

double wilson(const Fraction& f, double sign) {
  if (f.of == 0) return sign < 0 ? 0 : 1;
  const double n = f.of, p = f.value(), z2 = kZ * kZ;
  const double half = kZ * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n));
  return std::clamp((p + z2 / (2 * n) + sign * half) / (1 + z2 / n), 0.0, 1.0);
}

// Linear between order statistics; 0 of none.
double quantileOf(std::vector<double> values, double q) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const double at = q * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(at);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  return values[low] + (at - static_cast<double>(low)) * (values[high] - values[low]);
}

struct Lists {
  std::vector<double> set_sizes, errors, own_law_errors, removed;
};

void addNumbers(const Json& line, Figures& f, Lists& lists) {
  for (const Json& number : line.at("score").at("numbers")) {
    const bool own_law = number.value("own_law", false);
    lists.errors.push_back(number.at("error"));
    if (own_law) lists.own_law_errors.push_back(number.at("error"));
    if (!number.at("interval").get<bool>()) continue;
    const bool covered = number.at("covered").get<bool>();
    ++f.intervals;
    f.intervals_covering += covered;
    f.own_law_intervals += own_law;
    f.own_law_intervals_covering += own_law && covered;
  }
}

void addGain(const Json& line, Figures& f, Lists& lists) {
  if (!line.contains("gain") || !line.at("gain").at("known").get<bool>()) return;
  ++f.gains;
  lists.removed.push_back(line.at("gain").at("removed"));
  f.within_1_3_floor += line.at("gain").at("over_floor").get<double>() <= 1.3;
}

void addSingle(const Json& line, Figures& f, Lists& lists) {
  const Json& score = line.at("score");
  ++f.singles;
  f.singles_exact += score.at("exact").get<bool>();
  f.singles_named_wrong += score.at("named_wrong").get<bool>();
  f.singles_truth_in_set += score.at("truth_in_set").get<bool>();
  f.singles_ambiguous += score.at("ambiguous").get<bool>();
  f.singles_unknown += score.at("unknown").get<bool>();
  f.singles_with_look_alikes += !line.at("truth").at("hidden").at(0).at("look_alikes").empty();
  f.singles_look_alike += score.at("look_alike").get<bool>();
  if (score.at("set_size").get<int>() > 0) lists.set_sizes.push_back(score.at("set_size"));
  const std::string law = line.at("truth").at("hidden").at(0).at("law");
  if (law.rfind("hidden_", 0) == 0) {
    ++f.likenesses;
    f.likenesses_exact += score.at("exact").get<bool>();
  }
  addNumbers(line, f, lists);
  addGain(line, f, lists);
}

void addNull(const Json& line, bool exact, Figures& f) {
  const bool alarm = line.at("score").at("false_alarm");
  (exact ? f.exact_nulls : f.near_nulls) += 1;
  (exact ? f.exact_null_false_alarms : f.near_null_false_alarms) += alarm;
  f.nulls_said_unknown += line.at("score").at("said_unknown").get<bool>();
  if (!line.contains("gain")) return;
  ++f.null_gains;
  f.nulls_within_1_3_floor += line.at("gain").at("over_floor").get<double>() <= 1.3;
}

void addPair(const Json& line, Figures& f, Lists& lists) {
  const Json& score = line.at("score");
  ++f.pairs;
  f.pairs_both_found += score.at("found").get<int>() == 2;
  f.pairs_told_among += score.contains("found_among");
  f.pairs_both_among += score.value("found_among", 0) == 2;
  f.pairs_named += score.at("named").get<int>();
  f.pairs_named_right += score.at("named_right").get<int>();
  addNumbers(line, f, lists);
}

void addStranger(const Json& score, Figures& f) {
  ++f.unknowns;
  f.unknowns_flagged += score.at("flagged").get<bool>();
  f.signature_in_first_two += score.at("signature_right").get<bool>();
}

void addToLevel(const Json& line, LevelFigures& level) {
  const Json& score = line.at("score");
  const std::string kind = line.at("truth").at("kind");
  ++level.diagnoses;
  level.cpu += line.at("cpu_s").get<double>();
  if (kind == "exact_null" || kind == "near_null") {
    ++level.nulls;
    level.false_alarms += score.at("false_alarm").get<bool>();
  }
  if (kind == "single") {
    ++level.singles;
    level.exact += score.at("exact").get<bool>();
    level.named_wrong += score.at("named_wrong").get<bool>();
  }
}

void addLine(const Json& line, Figures& f, Lists& lists) {
  if (line.contains("skipped")) {
    ++f.skipped;
    f.imitated += line.at("truth").at("imitated").get<bool>();
    return;
  }
  const Json& score = line.at("score");
  const std::string kind = line.at("truth").at("kind");
  const std::string said = line.at("said");
  addToLevel(line, f.levels[line.at("truth").value("level", "joint")]);
  ++f.diagnoses;
  f.wall += line.at("wall_s").get<double>();
  f.cpu += line.at("cpu_s").get<double>();
  f.failed += said == "failed";
  f.unfinished += said.rfind("unfinished", 0) == 0;
  if (kind == "exact_null") addNull(line, true, f);
  if (kind == "near_null") addNull(line, false, f);
  if (kind == "single") addSingle(line, f, lists);
  if (kind == "pair") addPair(line, f, lists);
  if (kind == "stranger") addStranger(score, f);
  if (kind == "weak_single") {
    ++f.weak_singles;
    f.weak_detected += score.at("detected").get<bool>();
    f.weak_named_wrong += score.at("named_wrong").get<bool>();
  }
  if (kind == "mujoco_exact_null" || kind == "mujoco_null") {
    ++f.mujoco_nulls;
    f.mujoco_null_false_alarms += score.at("false_alarm").get<bool>();
    f.nulls_said_unknown += score.at("said_unknown").get<bool>();
  }
  if (kind == "mujoco_single") {
    ++f.mujoco_singles;
    f.mujoco_singles_exact += score.at("exact").get<bool>();
    f.mujoco_singles_named_wrong += score.at("named_wrong").get<bool>();
  }
  if (kind == "data_fault") {
    ++f.data_fault_sets;
    f.data_faults_found += score.at("fault_found").get<bool>();
    f.data_faults_named += score.at("fault_named").get<bool>();
  }
}

}  // namespace

double Fraction::low() const { return wilson(*this, -1); }
double Fraction::high() const { return wilson(*this, 1); }

Figures figuresOf(const std::vector<std::string>& lines) {
  Figures figures;
  Lists lists;
  for (const std::string& line : lines) addLine(parseResult(line), figures, lists);
  for (const double size : lists.set_sizes) {
    figures.set_size_mean += size / static_cast<double>(lists.set_sizes.size());
  }
  figures.parameter_error_median = quantileOf(lists.errors, 0.5);
  figures.parameter_error_p90 = quantileOf(lists.errors, 0.9);
  figures.own_law_parameter_error_median = quantileOf(lists.own_law_errors, 0.5);
  figures.own_law_parameter_error_p90 = quantileOf(lists.own_law_errors, 0.9);
  figures.excess_error_removed_median = quantileOf(lists.removed, 0.5);
  return figures;
}

}  // namespace nao::hidden

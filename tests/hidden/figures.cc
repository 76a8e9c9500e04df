#include "tests/hidden/figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/check.h"

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

Json parse(const std::string& line) {
  try {
    return Json::parse(line);
  } catch (const Json::exception& error) {
    throw InputError(std::string("results: expected a line of JSON: ") + error.what());
  }
}

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

std::string row(const char* name, const Fraction& f) {
  char text[160];
  std::snprintf(text, sizeof text, "%-44s %4d of %4d  %5.1f %%  (95 %%: %.1f to %.1f)\n", name,
                f.count, f.of, 100 * f.value(), 100 * f.low(), 100 * f.high());
  return text;
}

std::string row(const char* name, double value, const char* unit) {
  char text[160];
  std::snprintf(text, sizeof text, "%-44s %8.3g %s\n", name, value, unit);
  return text;
}

std::string rowsOf(const std::string& name, const LevelFigures& level) {
  std::string text =
      row((name + " level, nulls: false alarms").c_str(), {level.false_alarms, level.nulls});
  text += row("  singles: exact", {level.exact, level.singles});
  text += row("  singles: named alone and wrong", {level.named_wrong, level.singles});
  text += row("  processor time, mean", level.cpu / std::max(1, level.diagnoses), "s");
  return text;
}

Json toJson(const std::map<std::string, LevelFigures>& levels) {
  Json json = Json::object();
  for (const auto& [name, level] : levels) {
    json[name] = {{"nulls", level.nulls},
                  {"false_alarms", level.false_alarms},
                  {"singles", level.singles},
                  {"exact", level.exact},
                  {"named_wrong", level.named_wrong},
                  {"diagnoses", level.diagnoses},
                  {"cpu_s", level.cpu}};
  }
  return json;
}

bool isWrong(const std::string& kind, const Json& score) {
  if (kind.find("null") != std::string::npos) {
    return score.at("false_alarm").get<bool>() || score.at("said_unknown").get<bool>();
  }
  if (kind == "single" || kind == "mujoco_single")
    return !score.at("exact").get<bool>() || score.at("named_wrong").get<bool>();
  if (kind == "weak_single") return score.at("named_wrong").get<bool>();
  if (kind == "pair") {
    return score.at("found").get<int>() != 2 || score.at("named_right") != score.at("named");
  }
  if (kind == "stranger") return !score.at("flagged").get<bool>();
  return !score.at("fault_named").get<bool>();
}

}  // namespace

double Fraction::low() const { return wilson(*this, -1); }
double Fraction::high() const { return wilson(*this, 1); }

Figures figuresOf(const std::vector<std::string>& lines) {
  Figures figures;
  Lists lists;
  for (const std::string& line : lines) addLine(parse(line), figures, lists);
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

std::string toText(const Figures& f) {
  std::string text;
  text += row("exact nulls: false alarms", {f.exact_null_false_alarms, f.exact_nulls});
  text += row("near-nulls: false alarms", {f.near_null_false_alarms, f.near_nulls});
  text += row("nulls called unknown",
              {f.nulls_said_unknown, f.exact_nulls + f.near_nulls + f.mujoco_nulls});
  text += row("singles: exact", {f.singles_exact, f.singles});
  text += row("  of which by a law of their own: exact", {f.likenesses_exact, f.likenesses});
  text += row("singles: named alone and wrong", {f.singles_named_wrong, f.singles});
  text += row("singles: truth in the ambiguity set", {f.singles_truth_in_set, f.singles});
  text += row("singles: ambiguous", {f.singles_ambiguous, f.singles});
  text += row("singles: unknown", {f.singles_unknown, f.singles});
  text += row("singles: look-alikes are listed", {f.singles_with_look_alikes, f.singles});
  text += row("  first cause is such a one", {f.singles_look_alike, f.singles});
  text += row("mean size of the set", f.set_size_mean, "");
  text += row("weak singles: detected", {f.weak_detected, f.weak_singles});
  text += row("weak singles: named alone and wrong", {f.weak_named_wrong, f.weak_singles});
  text += row("pairs: both found", {f.pairs_both_found, f.pairs});
  text += row("  rivals and listed look-alikes too", {f.pairs_both_among, f.pairs_told_among});
  text += row("pairs: named causes that are right", {f.pairs_named_right, f.pairs_named});
  text += row("out of catalogue: flagged", {f.unknowns_flagged, f.unknowns});
  text += row("out of catalogue: feature in first two", {f.signature_in_first_two, f.unknowns});
  text += row("data faults: found", {f.data_faults_found, f.data_fault_sets});
  text += row("MuJoCo as reality, singles: exact", {f.mujoco_singles_exact, f.mujoco_singles});
  text += row("  named alone and wrong", {f.mujoco_singles_named_wrong, f.mujoco_singles});
  text +=
      row("MuJoCo as reality, nulls: false alarms", {f.mujoco_null_false_alarms, f.mujoco_nulls});
  text += row("  by the right kind", {f.data_faults_named, f.data_fault_sets});
  text += row("parameter error, median", 100 * f.parameter_error_median, "%");
  text += row("parameter error, 90th percentile", 100 * f.parameter_error_p90, "%");
  text += row("90 % intervals: covering", {f.intervals_covering, f.intervals});
  text += row("of the catalogue's own laws: error, median", 100 * f.own_law_parameter_error_median,
              "%");
  text += row("  90th percentile", 100 * f.own_law_parameter_error_p90, "%");
  text += row("  intervals covering", {f.own_law_intervals_covering, f.own_law_intervals});
  text += row("excess test error removed, median", 100 * f.excess_error_removed_median, "%");
  text += row("test RMSE within 1.3 times the floor", {f.within_1_3_floor, f.gains});
  text += row("  of nulls, by the nominal model", {f.nulls_within_1_3_floor, f.null_gains});
  text += row("processor time of a diagnosis, mean", f.cpu / std::max(1, f.diagnoses), "s");
  if (f.levels.size() > 1) {
    for (const auto& [name, level] : f.levels) text += rowsOf(name, level);
  }
  if (f.skipped > 0) text += row("sets that could not be made as wished", f.skipped, "");
  if (f.imitated > 0) text += row("  of which strangers that a cause imitates", f.imitated, "");
  if (f.failed > 0) text += row("diagnoses that failed", f.failed, "");
  if (f.unfinished > 0) text += row("unfinished", f.unfinished, "");
  return text;
}

std::string toJson(const Figures& f, const std::string& preset, double wall) {
  const Fraction within{f.within_1_3_floor, f.gains};
  const Json json = {{"preset", preset},
                     {"exact_nulls", f.exact_nulls},
                     {"exact_null_false_alarms", f.exact_null_false_alarms},
                     {"near_nulls", f.near_nulls},
                     {"near_null_false_alarms", f.near_null_false_alarms},
                     {"nulls_said_unknown", f.nulls_said_unknown},
                     {"singles", f.singles},
                     {"singles_exact", f.singles_exact},
                     {"singles_named_wrong", f.singles_named_wrong},
                     {"singles_truth_in_set", f.singles_truth_in_set},
                     {"singles_ambiguous", f.singles_ambiguous},
                     {"singles_unknown", f.singles_unknown},
                     {"singles_by_other_law", f.likenesses},
                     {"singles_by_other_law_exact", f.likenesses_exact},
                     {"weak_singles", f.weak_singles},
                     {"weak_detected", f.weak_detected},
                     {"weak_named_wrong", f.weak_named_wrong},
                     {"pairs", f.pairs},
                     {"pairs_both_found", f.pairs_both_found},
                     {"pairs_told_among", f.pairs_told_among},
                     {"pairs_both_among", f.pairs_both_among},
                     {"pairs_named", f.pairs_named},
                     {"pairs_named_right", f.pairs_named_right},
                     {"unknowns", f.unknowns},
                     {"unknowns_flagged", f.unknowns_flagged},
                     {"signature_in_first_two", f.signature_in_first_two},
                     {"data_fault_sets", f.data_fault_sets},
                     {"data_faults_found", f.data_faults_found},
                     {"data_faults_named", f.data_faults_named},
                     {"singles_with_look_alikes", f.singles_with_look_alikes},
                     {"singles_look_alike", f.singles_look_alike},
                     {"unknowns_imitated", f.imitated},
                     {"mujoco_singles", f.mujoco_singles},
                     {"mujoco_singles_exact", f.mujoco_singles_exact},
                     {"mujoco_nulls", f.mujoco_nulls},
                     {"mujoco_null_false_alarms", f.mujoco_null_false_alarms},
                     {"set_size_mean", f.set_size_mean},
                     {"parameter_error_median", f.parameter_error_median},
                     {"parameter_error_p90", f.parameter_error_p90},
                     {"intervals", f.intervals},
                     {"intervals_covering", f.intervals_covering},
                     {"own_law_parameter_error_median", f.own_law_parameter_error_median},
                     {"own_law_parameter_error_p90", f.own_law_parameter_error_p90},
                     {"own_law_intervals", f.own_law_intervals},
                     {"own_law_intervals_covering", f.own_law_intervals_covering},
                     {"excess_error_removed_median", f.excess_error_removed_median},
                     {"within_1_3_floor_fraction", within.value()},
                     {"skipped", f.skipped},
                     {"failed", f.failed},
                     {"unfinished", f.unfinished},
                     {"levels", toJson(f.levels)},
                     {"wall_s", wall}};
  return json.dump(2);
}

std::string listWrong(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& one : lines) {
    const Json line = parse(one);
    if (line.contains("skipped")) continue;
    const std::string kind = line.at("truth").at("kind");
    if (!isWrong(kind, line.at("score"))) continue;
    text += line.at("name").get<std::string>() + " " + kind;
    for (const Json& hidden : line.at("truth").at("hidden")) {
      char numbers[160];
      std::snprintf(numbers, sizeof numbers, "%.4g (size %.1f, nearest %s %.1f)",
                    hidden.at("value").get<double>(), hidden.at("size").get<double>(),
                    hidden.at("nearest").get<std::string>().c_str(),
                    hidden.at("nearest_apart").get<double>());
      const std::string joint = hidden.at("joint");
      text += " [" + hidden.at("law").get<std::string>() + " " +
              hidden.at("parameter").get<std::string>() + " " + numbers + " at " +
              (joint.empty() ? "all" : joint) + "]";
    }
    for (const Json& joint : line.at("truth").at("joints")) text += " " + joint.get<std::string>();
    text += " -> " + line.at("said").get<std::string>() + "\n";
  }
  return text;
}

}  // namespace nao::hidden

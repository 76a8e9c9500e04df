// Figures as a table, as JSON, and what lies behind those that are not as they should be.
#include <algorithm>
#include <cstdio>

#include "tests/hidden/figures.h"
#include "tests/hidden/result_line.h"

namespace nao::hidden {
namespace {

using Json = nlohmann::ordered_json;

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
    const Json line = parseResult(one);
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

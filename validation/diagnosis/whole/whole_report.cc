#include <nlohmann/json.hpp>
#include <sstream>

#include "validation/diagnosis/whole/whole_diagnosis.h"
#include "validation/report.h"

namespace nao::validation {
namespace {

using Json = nlohmann::ordered_json;

// A cause that is left out passes for noise.
std::string withFound(const WholeDiagnosis::RobotSpread& one) {
  if (one.found.noise.torque == one.spread.noise.torque) return "";
  return "; with what was found " + fixed(one.found.noise.torque, 2) + " times";
}

std::string sentenceOf(const WholeDiagnosis::RobotSpread& one) {
  const WholeSpread& spread = one.spread;
  const std::string more = spread.noise.torque > spread.high ? "more" : "less";
  return "process_noise: repeats of " + one.robot + " scatter " + more +
         " than the model's noise lets them: " + fixed(spread.noise.torque, 2) +
         " times its torque noise fits them, chance gives " + fixed(spread.low, 2) + " to " +
         fixed(spread.high, 2) + withFound(one);
}

// "LHipPitch: encoder_offset 3.3 deg from below: found here too, 3.26 deg"
std::string sentenceOf(const HandedOnFate& fate) {
  std::string text = fate.was.place + ": " + fate.was.cause + " " + valueText(fate.before) +
                     " was handed on: " + fate.outcome;
  return text + (fate.now.parameter.empty() ? "" : ", " + valueText(fate.now));
}

Json toJson(const std::vector<HandedOnFate>& fates) {
  Json all = Json::array();
  for (const HandedOnFate& fate : fates) {
    const bool here = !fate.now.parameter.empty();
    all.push_back({{"place", fate.was.place},
                   {"cause", fate.was.cause},
                   {"deviation", fate.before.deviation},
                   {"named_alone", fate.was.alone},
                   {"would_show_sd", fate.would_show},
                   {"outcome", fate.outcome},
                   {"deviation_here", here ? Json(fate.now.deviation) : Json(nullptr)}});
  }
  return all;
}

}  // namespace

std::string toJson(const WholeDiagnosis& diagnosis, const Provenance& provenance) {
  Json all = Json::parse(toJson(diagnosis.set, provenance));
  Json spreads = Json::array(), gait = Json::array();
  for (const auto& one : diagnosis.spreads) {
    spreads.push_back({{"robot", one.robot},
                       {"process_noise_scale", one.spread.noise.torque},
                       {"with_what_was_found", one.found.noise.torque},
                       {"encoder_jitter_scale", one.found.noise.jitter},
                       {"start_sd_s", one.found.noise.start_sd},
                       {"chance_99", {one.spread.low, one.spread.high}},
                       {"differs", one.spread.differs},
                       {"measured_sd_rad", one.spread.measured_sd},
                       {"simulated_sd_rad", one.spread.simulated_sd}});
  }
  for (const GaitRow& row : diagnosis.gait) {
    gait.push_back({{"robot", row.robot},
                    {"motion", row.motion},
                    {"split", row.split},
                    {"name", row.name},
                    {"measured", row.measured},
                    {"measured_sd", row.measured_sd},
                    {"nominal", row.nominal},
                    {"nominal_sd", row.nominal_sd},
                    {"extended", row.extended}});
  }
  all["second_moments"] = spreads;
  all["gait"] = gait;
  all["handed_on"] = toJson(diagnosis.handed_on);
  return all.dump(2);
}

std::string toText(const WholeDiagnosis& diagnosis) {
  std::ostringstream out;
  out << toText(diagnosis.set);
  for (const auto& one : diagnosis.spreads) {
    if (one.spread.differs) out << sentenceOf(one) << "\n";
  }
  for (const HandedOnFate& fate : diagnosis.handed_on) out << sentenceOf(fate) << "\n";
  TextTable table{"Mean of the runs",
                  {"motion", "runs to", "", "measured", "nominal", "with what was found"},
                  {}};
  for (const GaitRow& row : diagnosis.gait) {
    table.lines.push_back({row.motion, row.split, row.name, fixed(row.measured, 4),
                           fixed(row.nominal, 4), fixed(row.extended, 4)});
  }
  if (!table.lines.empty()) {
    Report report;
    report.tables = {table};
    out << toText(report);
  }
  return out.str();
}

}  // namespace nao::validation

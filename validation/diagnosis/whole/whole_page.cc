#include "validation/diagnosis/whole/whole_diagnosis.h"
#include "validation/html.h"

namespace nao::validation {
namespace {

std::string headline(const WholeDiagnosis& diagnosis) {
  std::string text;
  for (const JointVerdict& place : diagnosis.set.joints) {
    for (const Finding* finding : place.named()) {
      text += place.joint + ": " + finding->sentence;
      for (const Rival& rival : finding->rivals) text += ", or " + rival.label();
      text += ". ";
    }
    if (place.remainder_critical > 0 && place.remainder_score > place.remainder_critical) {
      text += place.joint +
              ": something remains that no cause of the catalogue explains, most of "
              "all in " +
              place.signature + ". ";
    }
    if (!place.not_tried.empty()) text += "Unfinished: some causes were not tried. ";
  }
  if (text.empty()) text = "The model explains this set: what is left is noise. ";
  for (const auto& one : diagnosis.spreads) {
    if (!one.spread.differs) continue;
    text += "Repeats of " + one.robot + " scatter as " + fixed(one.spread.noise.torque, 2) +
            " times the model's torque noise would let them, " + fixed(one.found.noise.torque, 2) +
            " times with what was found. ";
  }
  return text;
}

TextTable findingsOf(const WholeDiagnosis& diagnosis) {
  TextTable table{"Found",
                  {"where", "cause", "value", "90 % interval", "gain [nats]", "held out", "rivals",
                   "to tell them apart", "such statements before"},
                  {}};
  for (const JointVerdict& place : diagnosis.set.joints) {
    for (const Finding& finding : place.findings) {
      std::string values, intervals, rivals;
      for (const FoundNumber& number : finding.numbers) {
        values += number.parameter + " " + valueText(number) + " ";
        intervals += intervalText(number) + " ";
      }
      for (const Rival& rival : finding.rivals) rivals += rival.label() + " ";
      if (finding.one_motion_only) rivals += "(no block held back shows it)";
      table.lines.push_back(
          {place.joint, finding.cause + (finding.small ? " (perhaps too small)" : ""), values,
           intervals, fixed(finding.gain, 0), fixed(finding.held_out_gain, 0), rivals,
           finding.rivals.empty() ? "" : finding.experiment, finding.record});
    }
  }
  return table;
}

TextTable rejectedOf(const JointVerdict& place) {
  TextTable table{"Not taken: " + place.joint, {"cause", "gain [nats]", "why"}, {}};
  for (const Rejected& one : place.rejected) {
    table.lines.push_back({one.cause, fixed(one.gain, 1), one.reason});
  }
  for (const std::string& cause : place.not_tried) {
    table.lines.push_back({cause, "", "not tried: the budget was spent"});
  }
  return table;
}

TextTable spreadsOf(const WholeDiagnosis& diagnosis) {
  TextTable table{"How much repeats differ",
                  {"robot", "measured SD [mrad]", "simulated SD [mrad]", "times the model's noise",
                   "chance (99 %)", "with what was found"},
                  {}};
  for (const auto& one : diagnosis.spreads) {
    table.lines.push_back({one.robot, fixed(1e3 * one.spread.measured_sd, 2),
                           fixed(1e3 * one.spread.simulated_sd, 2),
                           fixed(one.spread.noise.torque, 2),
                           fixed(one.spread.low, 2) + " to " + fixed(one.spread.high, 2),
                           fixed(one.found.noise.torque, 2)});
  }
  return table;
}

TextTable gaitOf(const WholeDiagnosis& diagnosis) {
  TextTable table{"Mean and SD of the runs",
                  {"robot", "motion", "runs to", "", "measured", "nominal", "with what was found"},
                  {}};
  for (const GaitRow& row : diagnosis.gait) {
    table.lines.push_back({row.robot, row.motion, row.split, row.name,
                           fixed(row.measured, 4) + " +- " + fixed(row.measured_sd, 4),
                           fixed(row.nominal, 4) + " +- " + fixed(row.nominal_sd, 4),
                           fixed(row.extended, 4)});
  }
  return table;
}

TextTable handedOnOf(const WholeDiagnosis& diagnosis) {
  TextTable table{"Handed on by a lower level",
                  {"where", "cause", "there", "would show here by [SD]", "", "here"},
                  {}};
  for (const HandedOnFate& fate : diagnosis.handed_on) {
    table.lines.push_back({fate.was.place, fate.was.cause, valueText(fate.before),
                           fixed(fate.would_show, 1), fate.outcome,
                           fate.now.parameter.empty() ? "" : valueText(fate.now)});
  }
  return table;
}

std::string originOf(const WholeDiagnosis& diagnosis, const Provenance& provenance) {
  return "<h2>Where this comes from</h2>\n<p>" + originInHtml(provenance) + ". Threshold " +
         fixed(diagnosis.set.critical_gain, 1) + " nats: 1 % of whole sets, by " +
         std::to_string(diagnosis.set.null_sets) + " null sets. " +
         std::to_string(diagnosis.set.runs) +
         " simulated runs. Test runs were not opened. Assumed: a level floor, a robot at rest when "
         "a run begins, commands as logged; a walk's ankles answer what a replay feels beside the "
         "log.</p>\n" +
         commandInHtml(provenance);
}

}  // namespace

std::string wholePage(const WholeDiagnosis& diagnosis, const Provenance& provenance) {
  std::string body = "<p class=\"verdict\">" + escapeHtml(headline(diagnosis)) + "</p>\n";
  body += toHtml(findingsOf(diagnosis));
  if (!diagnosis.handed_on.empty()) body += toHtml(handedOnOf(diagnosis));
  for (const auto& worst : diagnosis.courses) {
    body += "<h2>" + escapeHtml(worst.place + ": " + worst.joint + " is furthest off") + "</h2>\n";
    body += drawSvg(drawCourse(worst.course));
  }
  for (const JointVerdict& place : diagnosis.set.joints) {
    if (place.remainder_critical <= 0) continue;
    body += "<h2>" + escapeHtml(place.joint) + "</h2>\n";
    if (!place.findings.empty() || !place.rejected.empty()) body += drawSvg(drawRanking(place));
    body += "<p>What is left: " + fixed(place.misfit_after, 2) +
            " of the noise floor (before: " + fixed(place.misfit_before, 2) +
            "); a remainder is told from " + fixed(place.remainder_critical, 2) + " on.</p>\n";
    body += toHtml(rejectedOf(place));
  }
  body += toHtml(spreadsOf(diagnosis));
  if (!diagnosis.gait.empty()) body += toHtml(gaitOf(diagnosis));
  return htmlPage("Diagnosis of " + provenance.set, body + originOf(diagnosis, provenance));
}

}  // namespace nao::validation

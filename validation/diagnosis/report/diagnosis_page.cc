#include "validation/diagnosis/report/diagnosis_page.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/check.h"
#include "validation/diagnosis/report/report_file.h"
#include "validation/html.h"

namespace nao::validation {
namespace {

/// A joint with its errors before and after.
struct Examined : ExaminedJoint {
  const JointVerdict* verdict;
};

std::string milli(double rad) { return fixed(1e3 * rad, 2); }

bool isOfInterest(const Examined& joint) {
  return joint.verdict->verdict != Verdict::NoDiscrepancy;
}

std::string gainText(const Examined& joint) {
  return "error " + milli(joint.before.rmse) + " -> " + milli(joint.after.rmse) + " mrad, floor " +
         milli(joint.before.floor);
}

// The verdict in words: what was found where, the largest error first.
std::string headline(const SetDiagnosis& diagnosis, const std::vector<Examined>& joints) {
  std::string text;
  for (const SharedFinding& one : diagnosis.shared) {
    text += (one.robot_id.empty() ? "" : one.robot_id + ": ") + one.finding.sentence + ". ";
  }
  for (const Examined& joint : joints) {
    const std::vector<const Finding*> named = joint.verdict->named();
    const std::string robot = ReportedPlace(joint.verdict->joint).robot_id;
    for (const Finding* finding : named) {
      text += (robot.empty() ? "" : robot + ": ") + finding->sentence;
      for (const Rival& rival : finding->rivals) text += ", or " + rival.label();
      text += finding == named.back() ? " (" + gainText(joint) + "). " : "; ";
    }
    const Verdict word = joint.verdict->verdict;
    if (word == Verdict::Unknown || word == Verdict::PartlyExplained) {
      text += joint.verdict->joint + " shows something that no cause of the catalogue explains" +
              (joint.verdict->signature.empty()
                   ? ""
                   : "; what the model lacks goes with " + joint.verdict->signature) +
              ". ";
    }
  }
  if (text.empty()) {
    return "The model explains this set: what is left is noise. Such statements before: " +
           diagnosis.joints.front().record + ".";
  }
  return text;
}

TextTable errorMap(const std::vector<Examined>& joints) {
  TextTable table{"What is wrong, joint by joint (fit and select runs, mrad)",
                  {"joint", "verdict", "nominal", "extended", "floor", "real SD", "simulated SD"},
                  {}};
  for (const Examined& joint : joints) {
    table.lines.push_back({joint.verdict->joint, wordOf(joint.verdict->verdict),
                           milli(joint.before.rmse), milli(joint.after.rmse),
                           milli(joint.before.floor), milli(joint.before.real_sd),
                           milli(joint.before.simulated_sd)});
  }
  return table;
}

TextTable findingsOf(const JointVerdict& joint) {
  TextTable table{"Found, in this order",
                  {"cause", "value", "90 % interval", "gain [nats]", "folds", "rivals",
                   "to tell them apart", "such statements before"},
                  {}};
  for (const Finding& finding : joint.findings) {
    std::string values, intervals, rivals;
    for (const FoundNumber& number : finding.numbers) {
      values += number.parameter + " " + valueText(number) + " ";
      intervals += (intervals.empty() ? sizeIntervalText(finding) : intervalText(number)) + " ";
    }
    for (const Rival& rival : finding.rivals) rivals += rival.label() + " ";
    if (finding.one_motion_only) rivals += "(seen in one motion only)";
    table.lines.push_back(
        {finding.cause + (finding.small ? " (perhaps too small to matter)" : ""), values, intervals,
         fixed(finding.gain, 0),
         std::to_string(finding.folds_better) + " of " + std::to_string(finding.folds), rivals,
         finding.rivals.empty() ? "" : finding.experiment, finding.record});
  }
  return table;
}

TextTable adjustmentsOf(const std::vector<Examined>& joints) {
  TextTable table{"What this robot differs by beside that, as robots of one kind do",
                  {"joint", "number", "likeliest deviation", "90 %"},
                  {}};
  for (const Examined& joint : joints) {
    for (const Adjustment& one : joint.verdict->adjustments) {
      FoundNumber middle = one.number;
      middle.value = middle.deviation;
      table.lines.push_back(
          {joint.verdict->joint, one.cause, valueText(middle), deviationIntervalText(one.number)});
    }
  }
  return table;
}

TextTable rejectedOf(const JointVerdict& joint) {
  TextTable table{"Not taken", {"cause", "gain [nats]", "why"}, {}};
  for (const Rejected& one : joint.rejected) {
    table.lines.push_back({one.cause, fixed(one.gain, 1), one.reason});
  }
  for (const std::string& cause : joint.not_tried) {
    table.lines.push_back({cause, "", "not tried: the budget was spent"});
  }
  return table;
}

TextTable confusionOf(const Finding& finding) {
  const Confusion& confusion = finding.confusion;
  TextTable table{
      "Of null sets with the cause on the left, how many each candidate explains best [%]",
      {"made with"},
      {}};
  for (std::size_t i = 0; i < confusion.causes.size(); ++i) {
    table.head.push_back(confusion.causes[i]);
    std::vector<std::string>& line = table.lines.emplace_back();
    line.push_back(confusion.causes[i]);
    for (const double share : confusion.share[i]) line.push_back(fixed(100 * share, 0));
  }
  return table;
}

std::string detailsOf(const Finding& finding) {
  std::string out;
  if (!finding.profile.empty()) out += drawSvg(drawProfile(finding));
  if (finding.confusion.causes.size() > 1) out += toHtml(confusionOf(finding));
  return out;
}

std::string chapterOf(const Examined& joint) {
  const JointVerdict& verdict = *joint.verdict;
  std::string out = "<h1>" + escapeHtml(verdict.joint) + "</h1>\n";
  if (!verdict.findings.empty()) out += toHtml(findingsOf(verdict));
  out += drawSvg(drawCourse(joint.course)) + drawSvg(drawSignature(joint.course));
  for (const Finding& finding : verdict.findings) out += detailsOf(finding);
  if (!verdict.findings.empty() || !verdict.rejected.empty()) {
    out += drawSvg(drawRanking(verdict));
  }
  out += "<p>What is left: " + fixed(verdict.misfit_after, 2) +
         " of the noise floor (before: " + fixed(verdict.misfit_before, 2) + "), " +
         fixed(verdict.remainder_score, 1) + " SD beyond null sets; a remainder is told from " +
         fixed(verdict.remainder_critical, 1) + " on." +
         (verdict.record.empty() ? "" : " Such statements before: " + escapeHtml(verdict.record)) +
         "</p>\n";
  return out + toHtml(rejectedOf(verdict));
}

std::string testsOf(const Provenance& provenance) {
  const int openings = provenance.test_openings;
  return "Test runs were not opened; `gain` has opened them " +
         (openings == 1 ? std::string("once") : std::to_string(openings) + " times") + " so far.";
}

std::string runsAssumed(int repeats) {
  if (repeats < 2) {
    return "Motions were run once, so that nothing tells noise from error: causes were chosen by "
           "what "
           "they predict of runs that their numbers were not fitted to.";
  }
  return "Runs of one motion (" + std::to_string(repeats) +
         " or more were measured) differ by random torques with a memory, by a late start and by "
         "the encoder's counts, as fitted to them.";
}

// What the verdict stands on beside the data.
std::string assumptionsOf(const SetDiagnosis& diagnosis) {
  int repeats = diagnosis.joints.front().repeats;
  for (const JointVerdict& joint : diagnosis.joints) repeats = std::min(repeats, joint.repeats);
  return "<h2>Assumed</h2>\n<ul>\n<li>" + runsAssumed(repeats) +
         "</li>\n<li>Robots of one kind differ undeclared by up to 2 % in masses and gains, 5 % "
         "in inertias, 10 % in friction and 0.1 degree in their zeros: less is never named, and is "
         "part of every interval.</li>\n<li>Joints that nobody measured hold what they were told; "
         "the base does not move.</li>\n<li>What acts is in the catalogue, or is told as "
         "unknown.</li>\n</ul>\n";
}

std::string originOf(const SetDiagnosis& diagnosis, const Provenance& provenance) {
  return "<h2>Where this comes from</h2>\n<p>" + originInHtml(provenance) + ". Threshold " +
         fixed(diagnosis.critical_gain, 1) +
         " nats: the 99 % quantile, over all joints and causes, of " +
         std::to_string(diagnosis.null_sets) + " null sets. " + std::to_string(diagnosis.runs) +
         " simulated runs. " + testsOf(provenance) + "</p>\n" + assumptionsOf(diagnosis) +
         commandInHtml(provenance);
}

}  // namespace

std::string diagnosisPage(const SetDiagnosis& diagnosis, const std::vector<ExaminedJoint>& examined,
                          const Provenance& provenance) {
  NAO_CHECK(examined.size() == diagnosis.joints.size());
  std::vector<Examined> joints;
  for (std::size_t i = 0; i < examined.size(); ++i) {
    joints.push_back({examined[i], &diagnosis.joints[i]});
  }
  std::stable_sort(joints.begin(), joints.end(), [](const Examined& a, const Examined& b) {
    return a.before.rmse > b.before.rmse;
  });
  std::string body = "<p class=\"verdict\">" + escapeHtml(headline(diagnosis, joints)) + "</p>\n";
  body += toHtml(errorMap(joints));
  for (const Examined& joint : joints) {
    if (isOfInterest(joint)) body += chapterOf(joint);
  }
  const TextTable adjustments = adjustmentsOf(joints);
  if (!adjustments.lines.empty()) body += toHtml(adjustments);
  return htmlPage("Diagnosis of " + provenance.set, body + originOf(diagnosis, provenance));
}

}  // namespace nao::validation

#include "tests/hidden/score.h"

#include <algorithm>
#include <cmath>

#include "tests/hidden/hideout.h"

namespace nao::hidden {
namespace {

bool has(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

// A fault of all joints may be named once for all or at the joint that shows it; one of a single
// joint for all only where no other joint is in the set.
bool isThere(const Truth& truth, const HiddenTruth& hidden, const GivenCause& given) {
  if (hidden.joint.empty() || hidden.joint == given.joint) return true;
  return truth.joints.size() == 1;
}

bool isRight(const Truth& truth, const HiddenTruth& hidden, const GivenCause& given) {
  return isThere(truth, hidden, given) && looksAlike(hidden.cause, given.cause);
}

// One of those that the truth lists beforehand as looking like this one.
bool isListed(const Truth& truth, const HiddenTruth& hidden, const GivenCause& given) {
  const auto& all = hidden.look_alikes;
  return !isRight(truth, hidden, given) && isThere(truth, hidden, given) &&
         std::any_of(all.begin(), all.end(),
                     [&](const std::string& one) { return looksAlike(one, given.cause); });
}

bool isLookAlike(const Truth& truth, const GivenCause& given) {
  return std::any_of(truth.hidden.begin(), truth.hidden.end(),
                     [&](const HiddenTruth& hidden) { return isListed(truth, hidden, given); });
}

bool isAmong(const Truth& truth, const HiddenTruth& hidden, const GivenCause& given) {
  if (isRight(truth, hidden, given)) return true;
  if (has(given.rivals, hidden.cause + " at " + hidden.joint)) return true;
  return isThere(truth, hidden, given) &&
         std::find(given.rivals.begin(), given.rivals.end(), hidden.cause) != given.rivals.end();
}

bool isAnyRight(const Truth& truth, const GivenCause& given) {
  return std::any_of(truth.hidden.begin(), truth.hidden.end(),
                     [&](const HiddenTruth& hidden) { return isRight(truth, hidden, given); });
}

void scoreFirst(const Truth& truth, const GivenReport& report, Score& score) {
  if (truth.hidden.empty() || report.causes.empty()) return;
  const GivenCause& first = report.causes.front();
  score.exact = isRight(truth, truth.hidden.front(), first);
  score.look_alike = isLookAlike(truth, first);
  const bool among = isAmong(truth, truth.hidden.front(), first);
  score.truth_in_set = among || score.look_alike;
  score.ambiguous = !first.rivals.empty() || score.look_alike;
  score.set_size = 1 + static_cast<int>(first.rivals.size()) + (score.look_alike && !among);
}

void scorePair(const Truth& truth, const GivenReport& report, Score& score) {
  for (const GivenCause& given : report.causes) {
    const bool right = isAnyRight(truth, given);
    score.named += right || !isLookAlike(truth, given);
    score.named_right += right;
  }
  const auto isAny = [&](const auto& of) {
    return std::any_of(report.causes.begin(), report.causes.end(), of);
  };
  for (const HiddenTruth& hidden : truth.hidden) {
    score.found += isAny([&](const GivenCause& c) { return isRight(truth, hidden, c); });
    score.found_among += isAny([&](const GivenCause& c) {
      return isAmong(truth, hidden, c) || isListed(truth, hidden, c);
    });
  }
}

// A signature reads "sgn v (41 %), then q (12 %)". Features that begin a word of many ("sin and cos
// of 8 q", "sgn v near q = 0.3") are given by their beginning.
bool isInFirstTwo(const std::string& signature, const HiddenTruth& hidden) {
  std::size_t begin = 0;
  for (int term = 0; term < 2 && begin < signature.size(); ++term) {
    const std::size_t end = std::min(signature.find(", then ", begin), signature.size());
    const std::string name = signature.substr(begin, signature.rfind(" (", end) - begin);
    for (const std::string& feature : hidden.features) {
      const bool family = feature.find(" of") != std::string::npos || feature.back() == '=';
      if (name == feature || (family && name.rfind(feature, 0) == 0)) return true;
      if (name == "sin and cos of " + feature) return true;  // "1.7 Hz"
    }
    begin = end + std::string(", then ").size();
  }
  return false;
}

void scoreStranger(const Truth& truth, const GivenReport& report, Score& score) {
  if (truth.hidden.empty() || !truth.hidden.front().cause.empty()) return;
  const HiddenTruth& hidden = truth.hidden.front();
  const bool alone = std::any_of(report.causes.begin(), report.causes.end(),
                                 [](const GivenCause& c) { return c.rivals.empty(); });
  score.flagged = report.remains(hidden.joint) && !alone;
  for (const GivenJoint& joint : report.joints) {
    if (joint.joint == hidden.joint) score.signature_right = isInFirstTwo(joint.signature, hidden);
  }
}

void scoreNumbers(const Truth& truth, const GivenReport& report, Score& score) {
  for (const HiddenTruth& hidden : truth.hidden) {
    if (!hidden.comparable || hidden.cause.empty()) continue;
    for (const GivenCause& given : report.causes) {
      if (given.cause != hidden.cause || !isThere(truth, hidden, given)) continue;
      if (!given.has_number || given.parameter != hidden.parameter) continue;
      // Of a limit that counts by its inverse: 1 / rate.
      const double found = hidden.inverse ? 1 / given.value : given.deviation;
      Score::Number number;
      number.error = std::abs(found - hidden.deviation) / std::abs(hidden.deviation);
      number.has_interval = given.high > given.low;
      number.covered = hidden.deviation >= given.low && hidden.deviation <= given.high;
      if (hidden.inverse) number.has_interval = false;
      number.own_law = hidden.law.rfind("hidden_", 0) != 0;
      score.numbers.push_back(number);
      break;
    }
  }
}

// A remainder beside a cause is what a stranger leaves.
bool isRightAbout(const Truth& truth, const GivenCause& given) {
  return std::any_of(truth.hidden.begin(), truth.hidden.end(), [&](const HiddenTruth& hidden) {
    if (!hidden.cause.empty()) return isAmong(truth, hidden, given);
    return isThere(truth, hidden, given) && has(given.rivals, "unknown");
  });
}

// Nothing to name: right if nothing is hidden here, or if what is here has no name.
bool isRightAbout(const Truth& truth, const GivenJoint& given) {
  const auto& all = truth.hidden;
  return std::all_of(all.begin(), all.end(),
                     [&](const HiddenTruth& hidden) {
                       const bool here = hidden.joint.empty() || hidden.joint == given.joint;
                       return !here || (given.verdict == "unknown" && hidden.cause.empty());
                     }) &&
         (given.verdict == "no_discrepancy" || !all.empty());
}

}  // namespace

std::vector<JudgedStatement> judgeStatements(const Truth& truth, const GivenReport& report) {
  std::vector<JudgedStatement> judged;
  for (const GivenCause& given : report.causes) {
    if (given.kind.verdict.empty()) continue;
    const bool right = isRightAbout(truth, given);
    judged.push_back({given.kind, right, !right && !isLookAlike(truth, given)});
  }
  for (const GivenJoint& given : report.joints) {
    if (given.kind.verdict.empty()) continue;
    const bool right = isRightAbout(truth, given);
    judged.push_back({given.kind, right, !right});
  }
  return judged;
}

Score score(const Truth& truth, const GivenReport& report) {
  Score score;
  score.false_alarm = !report.causes.empty();
  score.said_unknown = report.remains("");
  score.detected = report.verdict != "no_discrepancy" && report.verdict != "unfinished";
  score.unknown = report.verdict == "unknown";
  score.fault_found = report.verdict == "data_fault";
  const std::string fault = faultOf(truth.spoil);
  score.fault_named = score.fault_found && !fault.empty() && has(report.faults, fault);
  for (const GivenCause& given : report.causes) {
    const bool wrong = !isAnyRight(truth, given) && !isLookAlike(truth, given);
    score.named_wrong = score.named_wrong || (given.rivals.empty() && wrong);
  }
  scoreFirst(truth, report, score);
  scorePair(truth, report, score);
  scoreStranger(truth, report, score);
  scoreNumbers(truth, report, score);
  return score;
}

}  // namespace nao::hidden

#include "validation/diagnosis/report/verdict_record.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "core/check.h"
#include "core/config.h"

namespace nao::validation {
namespace {

constexpr char kTop[] = "diagnosis_record";
constexpr char kOwn[] = "own";
constexpr int kMost = 1'000'000'000;
const std::vector<std::string> kKeys = {"level", "verdict", "size", "signals", "repeats", "engine"};

std::vector<std::string> rowOf(const StatementKind& kind, const std::string& engine) {
  return {kind.level, kind.verdict, kind.size, kind.signals, kind.repeats, engine};
}

// Gains over the threshold of their set; free choice: about equal numbers of hidden effects of size
// 5 to 15 in the upper two.
std::string sizeOf(double gain, double critical) {
  if (critical <= 0) return "any";  // folds decided
  const double times = gain / critical;
  return times < 3 ? "near the threshold" : times < 30 ? "clear" : "large";
}

std::string classOf(int repeats) {
  return repeats < 2 ? "1" : repeats < 5 ? "2 to 4" : "5 or more";
}

std::string wordOf(const Finding& finding) {
  const auto named = [](const Rival& rival) { return rival.hasName(); };
  if (finding.rivals.empty()) return "named";
  return std::all_of(finding.rivals.begin(), finding.rivals.end(), named) ? "ambiguous"
                                                                          : "partly_explained";
}

std::string counted(const Outcomes& outcomes) {
  std::string text =
      "right " + std::to_string(outcomes.right) + " of " + std::to_string(outcomes.of);
  if (outcomes.wrong > 0) text += ", wrong " + std::to_string(outcomes.wrong);
  return text;
}

void record(Finding& finding, const VerdictRecords& records, StatementKind kind, double critical) {
  if (finding.small) return;
  kind.verdict = wordOf(finding);
  kind.size = sizeOf(finding.gain, critical);
  finding.kind = kind;
  finding.record = records.textOf(kind);
}

}  // namespace

VerdictRecords VerdictRecords::read(const std::string& file) {
  VerdictRecords records;
  if (!std::filesystem::exists(file)) return records;
  Config::read(file, [&](Config& top) {
    records.sets_ = top.has("hidden_sets") ? top.integer("hidden_sets", 0, kMost) : 0;
    top.list(kTop, Config::Presence::Optional, [&](Config& row) {
      std::vector<std::string> words;
      for (const std::string& key : kKeys) words.push_back(row.text(key));
      Outcomes& outcomes = records.rows_[words];
      outcomes.of = row.integer("of", 1, kMost);
      outcomes.right = row.integer("right", 0, outcomes.of);
      outcomes.wrong = row.integer("wrong", 0, outcomes.of - outcomes.right);
    });
  });
  return records;
}

void VerdictRecords::add(const StatementKind& kind, const std::string& engine,
                         const Outcomes& outcomes) {
  Outcomes& row = rows_[rowOf(kind, engine)];
  row.right += outcomes.right;
  row.wrong += outcomes.wrong;
  row.of += outcomes.of;
}

std::string VerdictRecords::textOf(const StatementKind& kind) const {
  std::string own, others;
  std::vector<std::string> row = rowOf(kind, "");
  for (const auto& [words, outcomes] : rows_) {
    row.back() = words.back();
    if (row != words) continue;
    if (words.back() == kOwn) {
      own = counted(outcomes);
    } else {
      others += " (sets of " + words.back() + ": " + counted(outcomes) + ")";
    }
  }
  if (own.empty() && others.empty()) return "no hidden sets of this kind on record";
  return kind.verdict + ": " + (own.empty() ? "none on record from our own engine" : own) + others;
}

std::string VerdictRecords::yaml() const {
  std::ostringstream out;
  out << "hidden_sets: " << sets_ << "\n" << kTop << ":" << (rows_.empty() ? " []" : "") << "\n";
  for (const auto& [words, outcomes] : rows_) {
    out << "  - {";
    for (std::size_t i = 0; i < kKeys.size(); ++i) {
      out << kKeys[i] << ": \"" << words[i] << "\", ";
    }
    out << "right: " << outcomes.right << ", wrong: " << outcomes.wrong << ", of: " << outcomes.of
        << "}\n";
  }
  return out.str();
}

void addRecords(SetDiagnosis& diagnosis, const VerdictRecords& records, const std::string& level,
                const std::string& signals, int repeats) {
  const StatementKind kind{level, "", "any", signals, classOf(repeats)};
  for (SharedFinding& one : diagnosis.shared) {
    record(one.finding, records, kind, diagnosis.critical_gain);
  }
  for (JointVerdict& joint : diagnosis.joints) {
    for (Finding& finding : joint.findings) record(finding, records, kind, joint.critical_gain);
    joint.kind = kind;
    joint.kind.verdict = validation::wordOf(joint.verdict);
    if (joint.named().empty()) joint.record = records.textOf(joint.kind);
  }
}

void addRecords(SetDiagnosis& diagnosis, const VerdictRecords& records,
                const std::vector<JointTask>& tasks) {
  std::size_t repeats = 1000;
  bool current = true;
  for (const JointTask& task : tasks) {
    for (const JointMotion& motion : task.joint->measured()) {
      if (motion.split == Split::Test || motion.repeats.empty()) continue;
      repeats = std::min(repeats, motion.repeats.size());
      current = current && motion.repeats.front().cols() > 1;
    }
  }
  addRecords(diagnosis, records, "joint", current ? "angle and current" : "angle",
             static_cast<int>(repeats));
}

}  // namespace nao::validation

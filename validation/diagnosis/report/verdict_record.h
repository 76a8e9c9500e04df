#pragma once

#include <map>
#include <string>
#include <vector>

#include "validation/diagnosis/joint/diagnose.h"

namespace nao::validation {

/// What became of statements of one kind about hidden sets. Neither right nor wrong: a cause that
/// looks like the hidden one, as was known beforehand.
struct Outcomes {
  int right = 0, wrong = 0, of = 0;
};

/// How diagnoses did where the truth was known: statements counted by their kind and by the engine
/// that the hidden sets came from. The file is a table that `usarnaoqi bench diagnosis --record`
/// writes:
///   hidden_sets: 120
///   diagnosis_record:
///     - {level: joint, verdict: named, size: large, signals: angle, repeats: 6, engine: own,
///        right: 93, wrong: 2, of: 100}
class VerdictRecords {
 public:
  VerdictRecords() = default;
  /// A file that is not there has no records. @throws InputError for one that is something else.
  static VerdictRecords read(const std::string& file);

  /// Sets that all statements together are about.
  void addSets(int count) { sets_ += count; }
  int sets() const { return sets_; }
  void add(const StatementKind& kind, const std::string& engine, const Outcomes& outcomes);
  /// "named: right 93 of 100, wrong 2 (sets of MuJoCo: right 20 of 25)", or that there are none.
  std::string textOf(const StatementKind& kind) const;
  std::string yaml() const;

 private:
  int sets_ = 0;
  std::map<std::vector<std::string>, Outcomes> rows_;  // by kind and engine
};

/// Says of every finding of interest, and of every joint without one, what kind of statement it is
/// and how such statements turned out. `level`: "joint", "limb" or "robot"; `signals`: "angle" ...;
/// `repeats`: of the motion that was repeated least.
void addRecords(SetDiagnosis& diagnosis, const VerdictRecords& records, const std::string& level,
                const std::string& signals, int repeats);

/// The same for joints: their signals and repeats are those of the tasks.
void addRecords(SetDiagnosis& diagnosis, const VerdictRecords& records,
                const std::vector<JointTask>& tasks);

}  // namespace nao::validation

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "validation/diagnosis/maths/number_form.h"

namespace nao::validation {

struct Cause;

/// A number of a named cause, as a person reads it.
struct FoundNumber {
  std::string parameter, unit;
  double value = 0;          // of the effect's parameter
  double deviation = 0;      // from the nominal model
  double low = 0, high = 0;  // 90 % interval of the deviation
  Form form = Form::Offset;  // how the value follows from the deviation
};

/// The value [unit] that a number has at another deviation; infinite for a limit at none.
double valueAt(const FoundNumber& number, double deviation);

/// The 90 % interval of the value [unit], the smaller end first.
std::pair<double, double> valueInterval(const FoundNumber& number);

/// The numbers of a cause at a fit's `x`; their intervals are the numbers themselves.
std::vector<FoundNumber> foundNumbers(const Cause& cause, const std::vector<double>& x);

/// Whether the interval of a deviation reaches into what is of no interest: less than `smallest`.
bool mayBeSmall(double low, double high, double smallest);

/// "12.3 ms", "0.4 deg": as the report writes it.
std::string valueText(const FoundNumber& number);

/// "12.1 ms to 12.5 ms": the 90 % interval of the value, or of the deviation from the nominal
/// model.
std::string intervalText(const FoundNumber& number);
std::string deviationIntervalText(const FoundNumber& number);

struct Finding;
/// The interval of a finding's first number, and what it would be if all else were as found.
std::string sizeIntervalText(const Finding& finding);

/// Another cause that explains the data about as well.
struct Rival {
  std::string cause;
  std::string effect;  // of the catalogue; empty: what has no name
  std::string place;   // empty: where its finding is
  std::vector<FoundNumber> numbers;
  double behind = 0;  // [nats] of gain

  /// "kp_error"; of a rival elsewhere "kp_error at LHipRoll".
  std::string label() const { return place.empty() ? cause : cause + " at " + place; }
  bool hasName() const { return !effect.empty(); }
};

/// What is in no catalogue, as a rival of what is.
inline Rival whatHasNoName() { return {"unknown", "", "", {}, 0}; }

/// Size of interest of a cause of which equal robots have a little, up to `smallest`, at every
/// place: where the same at other places explains the data as well, chance adds up what all of
/// them have.
double smallestTogether(const std::string& cause, double smallest,
                        const std::vector<Rival>& rivals);

/// Which of several candidates explains data best that were made with one of them: share[i][j] of
/// the sets made with causes[i] were explained best by causes[j].
struct Confusion {
  std::vector<std::string> causes;
  std::vector<std::vector<double>> share;
};

/// Another value of a number, all others following: how much worse it fits. From rough runs: it
/// shows the shape, the interval comes from null sets.
struct ProfilePoint {
  double deviation = 0;  // from the nominal model
  double lost = 0;       // [nats] of gain; below zero by chance
};

/// What kind of statement a diagnosis makes, by what its report shows of it: those of one kind are
/// about as often right (verdict_record.h).
struct StatementKind {
  std::string level;          // "joint", "limb", "robot"
  std::string verdict;        // of a finding: "named", "ambiguous", "partly_explained"
  std::string size, signals;  // of the gain; what was measured
  std::string repeats;        // "1", "2 to 4", "5 or more"
};

/// A cause that is part of a joint's fitted model.
struct Finding {
  std::string cause;   // id in the catalogue of causes
  std::string effect;  // of sim/effects
  std::vector<FoundNumber> numbers;
  double gain = 0;   // [nats] on the fit motions
  double share = 0;  // of the excess misfit at that stage
  int folds = 0, folds_better = 0;
  double held_out_gain = 0;  // [nats]
  bool one_motion_only = false;
  bool small = false;  // perhaps below its size of interest: fitted, never named
  /// Of a lone cause its first number, with the 90 % interval that it has if all else is as found:
  /// whether it is of interest is decided by that. Of others, none.
  std::vector<FoundNumber> as_shaped{};
  std::vector<Rival> rivals;  // none: named alone
  std::string sentence;
  std::string experiment;               // that separates it from its rivals
  std::vector<ProfilePoint> profile{};  // of the first number
  Confusion confusion{};                // among the candidates that were fitted in full
  StatementKind kind{};                 // empty until addRecords()
  std::string record{};                 // how such statements turned out where the truth was known
};

/// What a robot of the same kind differs by, too little to be a cause: the number that is likeliest
/// as equal robots are spread and the joint's residual is. Shrunk: where the data say little it is
/// near nominal.
struct Adjustment {
  std::string cause, effect;  // ids in the catalogues
  FoundNumber number;
};

/// What became of a candidate that is not part of the model.
struct Rejected {
  std::string cause;
  double gain = 0;  // [nats] it would have brought
  std::string reason;
};

enum class Verdict {
  NoDiscrepancy,
  Named,
  Ambiguous,
  PartlyExplained,  // named or ambiguous, and something remains
  Unknown,
  DataFault,
  Unfinished,
};

/// The diagnosis of one joint.
struct JointVerdict {
  std::string joint;
  Verdict verdict = Verdict::NoDiscrepancy;
  std::vector<Finding> findings;          // in the order they were found
  std::vector<Adjustment> adjustments{};  // beside them
  std::vector<Rejected> rejected;
  std::vector<std::string> not_tried;
  double critical_gain = 0;                            // [nats] the threshold, of the whole set
  double misfit_before = 0, misfit_after = 0;          // whitened, in units of the noise floor
  double remainder_score = 0, remainder_critical = 0;  // in SDs of the null sets
  double split_ratio =
      0;  // gains of repeat splits over gains of null sets: 1 if the noise is right
  bool with_repeats = true;
  int repeats = 0;  // of the motion with the fewest
  /// [N m] SD of the torque noise that makes simulated repeats, with what was found, scatter as the
  /// measured ones do, and of the robot's file; 0: not known.
  double noise = 0, nominal_noise = 0;
  long runs = 0;          // simulated
  std::string signature;  // of what has no name; empty: none was sought
  StatementKind kind{};   // likewise, if nothing is named here
  std::string record{};

  /// Whether more is left than chance leaves.
  bool remains() const { return remainder_score > remainder_critical; }
  /// The findings that count: of interest.
  std::vector<const Finding*> named() const;
  /// Whether repeats scatter more or less than the robot's file says, by half or more.
  bool scattersOtherwise() const;
};

/// The word of the report: "named", "partly_explained" ...
const char* wordOf(Verdict verdict);
/// Of the command line: 0 none, 10 named, 11 ambiguous, 12 unknown or partly explained, 13
/// unfinished, 20 data fault.
int exitCodeOf(Verdict verdict);
/// What a set with these joints comes to: the gravest of them.
Verdict overall(const std::vector<JointVerdict>& joints);

}  // namespace nao::validation

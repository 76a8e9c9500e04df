#pragma once

#include <map>
#include <string>
#include <vector>

namespace nao::hidden {

/// A part of a whole with its 95 % interval (Wilson 1927), which does not leave [0, 1].
struct Fraction {
  int count = 0, of = 0;
  double value() const { return of == 0 ? 0 : static_cast<double>(count) / of; }
  double low() const;
  double high() const;
};

/// The nulls and singles of one level of the diagnosis, which the totals hold too.
struct LevelFigures {
  int nulls = 0, false_alarms = 0, singles = 0, exact = 0, named_wrong = 0, diagnoses = 0;
  double cpu = 0;  // [s]
};

/// What the lines of results.jsonl come to.
struct Figures {
  int exact_nulls = 0, exact_null_false_alarms = 0, near_nulls = 0, near_null_false_alarms = 0;
  int nulls_said_unknown = 0;
  int singles = 0, singles_exact = 0, singles_named_wrong = 0, singles_truth_in_set = 0,
      singles_ambiguous = 0, singles_unknown = 0;
  /// Singles for which look-alikes are listed, and those of which one was called the first cause.
  int singles_with_look_alikes = 0, singles_look_alike = 0;
  int likenesses = 0, likenesses_exact = 0;  // of the singles, those of a law of their own
  int weak_singles = 0, weak_detected = 0, weak_named_wrong = 0;
  int pairs = 0, pairs_both_found = 0, pairs_named = 0, pairs_named_right = 0;
  /// With rivals and look-alikes listed beforehand, of those whose results tell it.
  int pairs_told_among = 0, pairs_both_among = 0;
  int unknowns = 0, unknowns_flagged = 0, signature_in_first_two = 0;
  int imitated = 0;  // of the skipped: strangers that some cause imitates wherever they were tried
  int data_fault_sets = 0, data_faults_found = 0, data_faults_named = 0;
  int mujoco_singles = 0, mujoco_singles_exact = 0, mujoco_singles_named_wrong = 0;
  int mujoco_nulls = 0, mujoco_null_false_alarms = 0;
  int diagnoses = 0, skipped = 0, failed = 0, unfinished = 0;
  int intervals = 0, intervals_covering = 0;
  int own_law_intervals = 0, own_law_intervals_covering = 0;  // of numbers that mean just the same
  int gains = 0, within_1_3_floor = 0;
  int null_gains = 0, nulls_within_1_3_floor = 0;  // what chance leaves of a right model
  double set_size_mean = 0, parameter_error_median = 0, parameter_error_p90 = 0,
         own_law_parameter_error_median = 0, own_law_parameter_error_p90 = 0,
         excess_error_removed_median = 0;
  double wall = 0, cpu = 0;                    // [s] of all diagnoses
  std::map<std::string, LevelFigures> levels;  // "joint", "limb", "robot"
};

/// @throws InputError for a line that is none.
Figures figuresOf(const std::vector<std::string>& lines);

std::string toText(const Figures& figures);
std::string toJson(const Figures& figures, const std::string& preset, double wall);

/// One line per diagnosis that was wrong: what was hidden and what was said.
std::string listWrong(const std::vector<std::string>& lines);

}  // namespace nao::hidden

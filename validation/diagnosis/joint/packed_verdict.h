#pragma once

#include "validation/diagnosis/causes/verdict.h"
#include "validation/diagnosis/jobs/packed_as.h"

namespace nao::validation {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FoundNumber, parameter, unit, value, deviation, low, high, form)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Rival, cause, effect, place, numbers, behind)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ProfilePoint, deviation, lost)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Confusion, causes, share)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StatementKind, level, verdict, size, signals, repeats)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Finding, cause, effect, numbers, gain, share, folds,
                                   folds_better, held_out_gain, one_motion_only, small, as_shaped,
                                   rivals, sentence, experiment, profile, confusion, kind, record)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Adjustment, cause, effect, number)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Rejected, cause, gain, reason)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(JointVerdict, joint, verdict, findings, adjustments, rejected,
                                   not_tried, critical_gain, misfit_before, misfit_after,
                                   remainder_score, remainder_critical, split_ratio, with_repeats,
                                   repeats, noise, nominal_noise, runs, signature, kind, record)

// A member that is missing above is a value that is lost: who adds one is stopped here.
inline void countMembers(const FoundNumber& number, const Finding& finding,
                         const JointVerdict& verdict) {
  [[maybe_unused]] const auto& [pa, un, va, de, lo, hi, fo] = number;
  [[maybe_unused]] const auto& [c, e, n, g, s, f, b, h, o, m, as, r, t, x, p, co, k, re] = finding;
  [[maybe_unused]] const auto& [jo, ve, fi, ad, rj, nt, cg, mb, ma, rs, rc, sr, wr, rp, no, nn, ru,
                                si, ki, rd] = verdict;
}

}  // namespace nao::validation

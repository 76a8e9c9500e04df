#include "validation/diagnosis/packed.h"

#include <nlohmann/json.hpp>

#include "core/check.h"
#include "validation/diagnosis/examined_joint.h"
#include "validation/diagnosis/fold_search.h"
#include "validation/diagnosis/joint_crowd.h"
#include "validation/diagnosis/kept_runs.h"

namespace Eigen {

static void to_json(nlohmann::json& json, const VectorXd& values) {
  json = std::vector<double>(values.data(), values.data() + values.size());
}

static void from_json(const nlohmann::json& json, VectorXd& values) {
  const auto list = json.get<std::vector<double>>();
  values = Map<const VectorXd>(list.data(), static_cast<Index>(list.size()));
}

}  // namespace Eigen

namespace nao::validation {

using Json = nlohmann::json;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(JointNoise, torque_sd, torque_time, start_sd, quantum, jitter)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(NullRecord, gains, remainders)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SharedStep, along, square, nulls)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SharedPart, cause, x, scanned, along, square, gain, lower, upper)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LinkLook, cause, x, gain)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(JointLooks, nulls, best, square, shared, links)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FoundNumber, parameter, unit, value, deviation, low, high, form)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Rival, cause, numbers, behind)
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
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Fold, name, motions)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FoldErrors, held_out)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FoldDiagnosis, verdict, folds, before, after, fitted)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(JointReplay, joint, rmse, mae, floor, misfit, share, real_sd,
                                   simulated_sd, noise_free_rmse)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(JointCourse, motion, dt, measured, nominal, extended, floor,
                                   measured_sd, simulated_sd, rival, with_rival)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ExaminedJoint, before, after, course)

namespace {

// A member that is missing above is a value that is lost: who adds one is stopped here.
[[maybe_unused]] void countMembers(const FoundNumber& number, const Finding& finding,
                                   const JointVerdict& verdict) {
  [[maybe_unused]] const auto& [pa, un, va, de, lo, hi, fo] = number;
  [[maybe_unused]] const auto& [c, e, n, g, s, f, b, h, o, m, as, r, t, x, p, co, k, re] = finding;
  [[maybe_unused]] const auto& [jo, ve, fi, ad, rj, nt, cg, mb, ma, rs, rc, sr, wr, rp, no, nn, ru,
                                si, ki, rd] = verdict;
}

}  // namespace

// CBOR: unlike text it holds every double, infinite ones too.
template <class T>
std::string pack(const T& value) {
  std::string bytes;
  Json::to_cbor(Json(value), bytes);
  return bytes;
}

template <class T>
T unpack(const std::string& bytes) {
  try {
    return Json::from_cbor(bytes).get<T>();
  } catch (const Json::exception& error) {
    throw InputError(std::string("a kept part of a diagnosis can not be read: ") + error.what());
  }
}

template std::string pack(const long&);
template long unpack(const std::string&);
template std::string pack(const double&);
template double unpack(const std::string&);
template std::string pack(const std::vector<double>&);
template std::vector<double> unpack(const std::string&);
template std::string pack(const WholePool&);
template WholePool unpack(const std::string&);
template std::string pack(const JointNoise&);
template JointNoise unpack(const std::string&);
template std::string pack(const SharedStep&);
template SharedStep unpack(const std::string&);
template std::string pack(const JointLooks&);
template JointLooks unpack(const std::string&);
template std::string pack(const JointVerdict&);
template JointVerdict unpack(const std::string&);
template std::string pack(const FoldDiagnosis&);
template FoldDiagnosis unpack(const std::string&);
template std::string pack(const ExaminedJoint&);
template ExaminedJoint unpack(const std::string&);

}  // namespace nao::validation

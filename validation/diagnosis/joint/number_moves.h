#pragma once

#include <vector>

#include <Eigen/Core>

#include "validation/diagnosis/causes/verdict.h"
#include "validation/diagnosis/joint/candidate_fit.h"
#include "validation/diagnosis/joint/stage.h"

namespace nao::validation {

/// By how much the numbers of a fit may be off, a row per null set, a column per number.
/// What they would have come out as in each null set: one Gauss-Newton step with the sensitivities
/// of the fit.
Eigen::MatrixXd reestimated(const Stage& stage, const ModelSlopes& fit);

/// Beyond chance: what is wrong otherwise draws each motion's numbers its own way. `left`: the raw
/// residual at the fit.
void addDisagreement(const JointData& data, const Stage& stage, const ModelSlopes& fit,
                     const Eigen::VectorXd& left, Eigen::MatrixXd& moves);

/// A joint that rests reads one count all along, at a stop in motion after motion: rounding is one
/// error there, not one per sample. How far it is from one place of rest to the next, `angle`
/// tells, a prediction that no encoder rounds; where between two counts any of them lies nobody
/// knows, nor where a model's does that reads the same: of both sawteeth, smeared by how the joint
/// shakes, the phase is drawn.
void addRounding(const JointData& data, const Stage& stage, const ModelSlopes& fit,
                 const Eigen::VectorXd& angle, Eigen::MatrixXd& moves);

/// What equal robots differ by in the numbers themselves, and what laws leave out.
void addSpread(const std::vector<Cause>& causes, const CauseList& model, Eigen::MatrixXd& moves);

/// The number with the interval that leaves 1 - `high` of its moves out at either end: of 90 %.
FoundNumber within(FoundNumber number, const Eigen::VectorXd& moves, double high = 0.95);
/// Whether a cause of this size may be of no interest, as its size may be what it is less `moves`.
bool mayBeSmall(const FoundNumber& size, const Eigen::VectorXd& moves, const Cause& cause,
                double high = 0.95);

}  // namespace nao::validation

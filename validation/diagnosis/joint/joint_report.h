#pragma once

#include <map>
#include <string>
#include <vector>

#include "validation/diagnosis/causes/verdict.h"
#include "validation/diagnosis/joint/joint_model.h"
#include "validation/diagnosis/joint/signature.h"

namespace nao::validation {

/// What a search notes on its way.
struct SearchNotes {
  double misfit_before = 0, split_ratio = 0;
  std::vector<Rejected> rejected;
  std::map<std::size_t, double> last_gains;  // [nats] by cause, of the last round's fits
  std::vector<std::string> not_tried;        // ids of causes, some more than once
};

/// Puts what was found into words and numbers.
class JointReport {
 public:
  /// Of a model that is refined, whose runs it takes for intervals and profiles. Both must outlive
  /// it.
  JointReport(JointModel& model, const SearchNotes& notes);

  JointVerdict verdict();

 private:
  void addFindings(JointVerdict& verdict);
  Finding findingOf(std::size_t place) const;
  Eigen::VectorXd unroundedAngle();
  Eigen::MatrixXd movesOf(const ModelSlopes& fit, const Eigen::VectorXd& angle) const;
  std::vector<ProfilePoint> profileOf(std::size_t place, const FoundNumber& number);
  Eigen::VectorXd leftAtFit() const;
  std::vector<Adjustment> adjustments() const;
  std::vector<Rejected> rejected() const;
  void addEvidence(JointVerdict& verdict) const;
  void judge(JointVerdict& verdict) const;
  bool leansOnATrifle(const JointVerdict& verdict) const;
  void doubtThoseAtEnd(JointVerdict& verdict) const;
  Signature shapeOfUnknown() const;

  JointModel& model_;
  const SearchNotes& notes_;
  const Stage& stage_;
  const ModelFit& fit_;
  const std::vector<Cause>& causes_;
};

}  // namespace nao::validation

// How well other values of the numbers that were found would fit: shapes for the report. Widths
// come from null sets, not from here.
#include <Eigen/QR>

#include "validation/diagnosis/joint/joint_report.h"

namespace nao::validation {
namespace {

// In half widths of the interval: free choice.
constexpr double kPlaces[] = {-3, -2, -1, -0.5, 0.5, 1, 2, 3};

// What the other numbers of a model cannot follow.
class Alone {
 public:
  Alone(const Stage& stage, const ModelFit& fit, Eigen::Index own) : stage_(stage) {
    Eigen::MatrixXd others(stage.fitSize(), fit.jacobian.cols() - 1);
    for (Eigen::Index i = 0, next = 0; i < fit.jacobian.cols(); ++i) {
      if (i != own) others.col(next++) = stage.whitenFit(fit.jacobian.col(i));
    }
    if (others.cols() > 0) qr_.compute(others);
  }

  Eigen::VectorXd operator()(const Eigen::VectorXd& raw) const {
    Eigen::VectorXd white = stage_.whitenFit(raw);
    if (qr_.cols() == 0) return white;
    Eigen::VectorXd turned = qr_.householderQ().adjoint() * white;
    turned.head(qr_.rank()).setZero();
    return qr_.householderQ() * turned;
  }

 private:
  const Stage& stage_;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr_;
};

}  // namespace

// What is left at the fit's numbers, which a last step moved away from the stage's.
Eigen::VectorXd JointReport::leftAtFit() const {
  Eigen::VectorXd left = stage_.raw();
  Eigen::Index column = 0;
  for (std::size_t i = 0; i < fit_.model.size(); ++i) {
    for (std::size_t n = 0; n < fit_.model[i].x.size(); ++n, ++column) {
      left -= fit_.jacobian.col(column) * (fit_.model[i].x[n] - stage_.model()[i].x[n]);
    }
  }
  return left;
}

std::vector<ProfilePoint> JointReport::profileOf(std::size_t place, const FoundNumber& number) {
  const Cause& cause = causes_[fit_.model[place].cause];
  std::vector<ProfilePoint> profile;
  if (cause.beats || number.high <= number.low || model_.ensemble().spent()) return profile;
  Eigen::Index column = 0;
  for (std::size_t i = 0; i < place; ++i) {
    column += static_cast<Eigen::Index>(fit_.model[i].x.size());
  }
  const Alone alone(stage_, fit_, column);
  const Eigen::VectorXd left = alone(leftAtFit());
  const auto halves = [&](const CauseList& model) {
    return model_.ensemble().roughHalves(settingsOf(causes_, model), model_.effort().look_runs,
                                         Over::Fit);
  };
  const Halves base = halves(fit_.model);
  for (const double place_in_widths : kPlaces) {
    CauseList beside = fit_.model;
    double& x = beside[place].x[0];
    x += place_in_widths * (number.high - number.low) / 2;
    if (x < cause.free[0].lower || x > cause.free[0].upper) continue;
    const Halves change = (halves(beside) - base).through(alone);
    profile.push_back({x, change.first.dot(change.second) / 2 - change.mean().dot(left)});
  }
  return profile;
}

}  // namespace nao::validation

#include "validation/diagnosis/ensemble/noise_modes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "validation/diagnosis/ensemble/joint_data.h"
#include "validation/diagnosis/maths/thin_svd.h"

namespace nao::validation {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kMost = 12;    // modes per motion: free choice
constexpr double kStands = 3;  // times the usual variance: independent samples reach less than 2

// Of one motion: deviations of its runs, in SDs of the measured mean.
MatrixXd deviationsOf(const RunPool& pool, const MotionSpan& span, std::size_t i,
                      const VectorXd& sd) {
  const MatrixXd deviations = pool.deviations(i);
  const double scale = 1 / std::sqrt(static_cast<double>(deviations.cols() * span.repeats));
  const VectorXd inverse = sd.segment(span.offset, span.size()).cwiseInverse() * scale;
  return inverse.asDiagonal() * deviations;
}

double median(VectorXd values) {
  std::sort(values.data(), values.data() + values.size());
  return values[values.size() / 2];
}

}  // namespace

NoiseModes findNoiseModes(const RunPool& pool, double worth, const JointData& data,
                          const VectorXd& sd) {
  NoiseModes found{sd, {}};
  std::vector<VectorXd> columns;
  for (std::size_t i = 0; i < data.spans().size(); ++i) {
    const MotionSpan& span = data.spans()[i];
    const MatrixXd deviations = deviationsOf(pool, span, i, sd);
    const ThinSvd svd = calcSvd(deviations);
    const VectorXd variance = svd.values.cwiseAbs2();
    const double usual = median(variance);
    VectorXd beside = deviations.rowwise().squaredNorm();
    const double two_means = 1 + static_cast<double>(span.repeats) / worth;
    for (Index k = 0; k < std::min(kMost, variance.size()); ++k) {
      if (variance[k] < kStands * usual) break;
      const VectorXd mode = svd.left.col(k);
      beside -= variance[k] * mode.cwiseAbs2();
      VectorXd column = VectorXd::Zero(data.size());
      column.segment(span.offset, span.size()) =
          std::sqrt((variance[k] - usual) * two_means) *
          sd.segment(span.offset, span.size()).cwiseProduct(mode);
      columns.push_back(column);
    }
    for (Index s = 0; s < span.size(); ++s) {
      found.sd[span.offset + s] *= std::sqrt(std::max(1.0, beside[s]));
    }
  }
  found.directions.resize(data.size(), static_cast<Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    found.directions.col(static_cast<Index>(i)) = columns[i];
  }
  return found;
}

}  // namespace nao::validation

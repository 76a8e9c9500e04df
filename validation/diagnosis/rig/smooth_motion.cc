#include "validation/diagnosis/rig/smooth_motion.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "core/check.h"

namespace nao::validation {
namespace {

constexpr double kReach = 3.5;  // SDs of the weights beyond which a sample counts for nothing

// The window around a time that lies `later` samples after its row.
class Window {
 public:
  Window(double later, double sd)
      : first_(std::lround(std::ceil(later - kReach * sd))),
        last_(std::lround(std::floor(later + kReach * sd))),
        later_(later),
        sd_(sd) {
    std::vector<double> pulse(static_cast<std::size_t>(last_ - first_ + 1), 0.0);
    kernel_.resize(3, static_cast<Eigen::Index>(pulse.size()));
    for (std::size_t i = 0; i < pulse.size(); ++i) {
      pulse[i] = 1;
      kernel_.col(static_cast<Eigen::Index>(i)) = fit(pulse);
      pulse[i] = 0;
    }
  }

  /// Value, first and second derivative, per sample, of the cubic around row `k`.
  Eigen::Vector3d at(const std::vector<double>& samples, std::size_t k) const {
    std::vector<double> seen;
    seen.reserve(static_cast<std::size_t>(kernel_.cols()));
    const long end = static_cast<long>(samples.size()) - 1;
    for (long i = first_; i <= last_; ++i) {
      const long at = std::clamp(static_cast<long>(k) + i, 0L, end);
      seen.push_back(samples[static_cast<std::size_t>(at)]);
    }
    const bool whole = std::none_of(seen.begin(), seen.end(), [](double s) { return s != s; });
    if (!whole) return fit(seen);
    return kernel_ * Eigen::Map<const Eigen::VectorXd>(seen.data(), kernel_.cols());
  }

 private:
  Eigen::Vector3d fit(const std::vector<double>& seen) const {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (std::isnan(seen[i])) continue;
      const double x = static_cast<double>(first_ + static_cast<long>(i)) - later_;
      const double weight = std::exp(-x * x / (2 * sd_ * sd_));
      const Eigen::Vector4d basis(1, x, x * x, x * x * x);
      normal += weight * basis * basis.transpose();
      right += weight * seen[i] * basis;
    }
    const Eigen::Vector4d cubic = normal.ldlt().solve(right);
    return {cubic[0], cubic[1], 2 * cubic[2]};
  }

  long first_, last_;  // rows, from the row at hand
  double later_, sd_;  // [rows]
  Eigen::MatrixXd kernel_;
};

}  // namespace

SmoothMotion smoothed(const std::vector<double>& samples, double dt, double bandwidth,
                      double later) {
  NAO_CHECK(!samples.empty() && dt > 0 && bandwidth > 0);
  // exp(-(2 pi f sd)^2 / 2) = 1 / sqrt(2); at least what a cubic needs to be known.
  const double sd = std::max(std::sqrt(std::log(2.0)) / (2 * M_PI * bandwidth) / dt, 0.8);
  const Window window(later / dt, sd);
  SmoothMotion motion;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const Eigen::Vector3d found = window.at(samples, k);
    motion.angle.push_back(found[0]);
    motion.rate.push_back(found[1] / dt);
    motion.acceleration.push_back(found[2] / (dt * dt));
  }
  return motion;
}

}  // namespace nao::validation

#include "validation/diagnosis/whole/whole_noise.h"

#include <algorithm>
#include <cmath>

#include "validation/diagnosis/maths/moving_mean.h"
#include "validation/diagnosis/maths/thin_svd.h"
#include "validation/diagnosis/whole/whole_scatter.h"

namespace nao::validation {
namespace {

constexpr Eigen::Index kDirections = 6;  // free choice: the rest is as good as independent
constexpr Eigen::Index kSmooth = 5;      // bins to either side: 0.1 s
constexpr double kMostInflation = 40;
constexpr double kMostRaised = 5;  // SDs; more is no noise

// Values per independent one: 1 + 2 sum of the autocorrelation, as long as it is above 0.1.
double inflationOf(const Eigen::MatrixXd& course) {
  const double all = course.squaredNorm();
  double sum = 1;
  for (Eigen::Index lag = 1; lag < course.rows() / 3 && all > 0; ++lag) {
    const Eigen::Index n = course.rows() - lag;
    const double rho = course.topRows(n).cwiseProduct(course.bottomRows(n)).sum() / all;
    if (rho < 0.1) break;
    sum += 2 * rho;
  }
  return std::min(sum, kMostInflation);
}

double meanSquare(const Eigen::MatrixXd& m) {
  return m.size() > 0 ? m.squaredNorm() / static_cast<double>(m.size()) : 0;
}

}  // namespace

int perRun(int runs, std::size_t measured) {
  const auto n = static_cast<int>(measured);
  return std::max(1, (runs + n - 1) / n);
}

WholeNoise::WholeNoise(const WholeData& data, const WholePool& pool)
    : sd_(Eigen::VectorXd::Zero(data.size())), raised_(Eigen::VectorXd::Ones(data.size())) {
  std::vector<Eigen::VectorXd> directions;
  for (std::size_t block = 0; block < data.spaces().size(); ++block) {
    addBlock(data, pool, block, directions);
  }
  directions_.resize(data.size(), static_cast<Eigen::Index>(directions.size()));
  for (std::size_t i = 0; i < directions.size(); ++i) {
    directions_.col(static_cast<Eigen::Index>(i)) = directions[i];
  }
}

// Raises what was simulated, signal by signal, to the scatter of the repeats, each of which had the
// mean of so many simulated runs taken off.
Eigen::VectorXd WholeNoise::raise(const std::vector<FeatureGroup>& groups,
                                  Eigen::MatrixXd& simulated, const Eigen::MatrixXd& measured,
                                  double per_run) {
  Eigen::VectorXd by(simulated.rows());
  for (const FeatureGroup& group : groups) {
    const double own = meanSquare(simulated.middleRows(group.offset, group.size));
    double seen = own;
    if (measured.size() > 0) {
      seen = meanSquare(measured.middleRows(group.offset, group.size)) - own / per_run;
    }
    const double floor = group.floor * group.floor;
    const double ratio = std::sqrt(std::max(0.0, seen + floor) / (own + floor));
    by.segment(group.offset, group.size).setConstant(std::clamp(ratio, 1.0, kMostRaised));
  }
  simulated = by.asDiagonal() * simulated;
  return by;
}

void WholeNoise::addBlock(const WholeData& data, const WholePool& pool, std::size_t block,
                          std::vector<Eigen::VectorXd>& directions) {
  const WholeBlock& of = data.simulator().blocks()[block];
  const std::vector<FeatureGroup>& groups = data.spaces()[block].groups();
  const Eigen::Index at = data.offsets()[block];
  Eigen::MatrixXd simulated = deviationsOf(simulatedRuns(pool, of));
  const auto columns = static_cast<double>(simulated.cols());
  const double measured = 1 / static_cast<double>(of.runs.size());
  const double of_mean = std::sqrt(measured + 1 / columns + data.stepErrors().variance);
  raised_.segment(at, simulated.rows()) =
      std::sqrt(1 + data.stepErrors().variance / measured) *
      raise(groups, simulated, deviationsOf({measuredRuns(data, pool, block).runs}),
            columns * measured);

  // What scatters together, in units of what scatters at all.
  Eigen::VectorXd scale = simulated.rowwise().squaredNorm() / columns;
  for (const FeatureGroup& group : groups) {
    scale.segment(group.offset, group.size).array() += group.floor * group.floor;
  }
  scale = scale.cwiseSqrt();
  const Eigen::MatrixXd scaled = scale.cwiseInverse().asDiagonal() * simulated;
  const ThinSvd svd = calcSvd(scaled, Right::Wanted);
  const Eigen::Index count = std::min(kDirections, svd.values.size() / 2);
  const Eigen::MatrixXd together =
      scale.asDiagonal() * svd.left.leftCols(count) * svd.values.head(count).asDiagonal();
  for (Eigen::Index i = 0; i < count; ++i) {
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(data.size());
    direction.segment(at, scaled.rows()) = of_mean / std::sqrt(columns) * together.col(i);
    directions.push_back(std::move(direction));
  }
  // Each direction takes a run's worth of scatter with it.
  const double free = columns - 1, left = std::max(1.0, free - static_cast<double>(count));
  addRest(groups, at, of_mean * std::sqrt(free / left),
          simulated - together * svd.right.leftCols(count).transpose());
}

void WholeNoise::addRest(const std::vector<FeatureGroup>& groups, Eigen::Index at, double of_mean,
                         const Eigen::MatrixXd& rest) {
  for (const FeatureGroup& group : groups) {
    const Eigen::MatrixXd part = rest.middleRows(group.offset, group.size);
    Eigen::VectorXd variance = part.rowwise().squaredNorm() / static_cast<double>(part.cols());
    if (group.dt > 0) variance = movingMean(variance, kSmooth);
    variance.array() += group.floor * group.floor;
    const double inflation = group.dt > 0 ? inflationOf(part) : 1;
    sd_.segment(at + group.offset, group.size) = of_mean * (inflation * variance).cwiseSqrt();
  }
}

}  // namespace nao::validation

#include "validation/diagnosis/maths/lag.h"

#include <algorithm>
#include <cmath>

namespace nao::validation {
namespace {

constexpr int kMostLate = 10;  // rows
constexpr double kStep = 0.1;  // of a row

}  // namespace

double atRow(const Eigen::VectorXd& rows, double place) {
  const double inside = std::clamp(place, 0.0, static_cast<double>(rows.size() - 1));
  const auto row = static_cast<Eigen::Index>(inside);
  const Eigen::Index next = std::min(row + 1, rows.size() - 1);
  return rows[row] + (inside - static_cast<double>(row)) * (rows[next] - rows[row]);
}

Eigen::VectorXd earlier(const Eigen::VectorXd& rows, double late) {
  Eigen::VectorXd moved(rows.size());
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    moved[i] = atRow(rows, static_cast<double>(i) + late);
  }
  return moved;
}

double rowsLate(const Eigen::VectorXd& told, const Eigen::VectorXd& course) {
  const Eigen::Index compared = std::max<Eigen::Index>(0, course.size() - kMostLate);
  double best = 0, least = (told - course).head(compared).squaredNorm();
  for (int i = 1; i <= std::lround(kMostLate / kStep); ++i) {
    const double off = (earlier(told, i * kStep) - course).head(compared).squaredNorm();
    if (off >= least) continue;
    least = off;
    best = i * kStep;
  }
  return best;
}

}  // namespace nao::validation

#include "validation/diagnosis/maths/chords.h"

#include <algorithm>

namespace nao::validation {
namespace {

// Where on the line through both, 0: first, 1: second.
double bestPart(const Response& first, const Response& second, const Eigen::VectorXd& residual) {
  const Eigen::VectorXd way = second.change - first.change;
  const double square = way.squaredNorm();
  return square > 0 ? (residual - first.change).dot(way) / square : 0;
}

}  // namespace

SizeGain bestOnChords(const std::vector<Response>& row, const Eigen::VectorXd& residual) {
  SizeGain best;
  for (std::size_t i = 0; i + 1 < row.size(); ++i) {
    const Response &a = row[i], &b = row[i + 1];
    const double part = std::clamp(bestPart(a, b, residual), 0.0, 1.0);
    const Eigen::VectorXd change = a.change + part * (b.change - a.change);
    const double gain = change.dot(residual) - change.squaredNorm() / 2;
    if (gain > best.gain) best = {a.size + part * (b.size - a.size), gain};
  }
  return best;
}

double alongChord(const Response& first, const Response& second, const Eigen::VectorXd& residual,
                  double reach) {
  const double part = std::clamp(bestPart(first, second, residual), -reach, reach);
  return first.size + part * (second.size - first.size);
}

}  // namespace nao::validation

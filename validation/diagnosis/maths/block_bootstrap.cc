#include "validation/diagnosis/maths/block_bootstrap.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "core/random.h"

namespace nao::validation {
namespace {

// Of the diagonal: a draw without the only log that shows a number leaves the number where it was.
constexpr double kRidge = 1e-9;

struct Normal {
  Eigen::MatrixXd square;  // J' W J
  Eigen::VectorXd side;    // J' W e
};

std::vector<Normal> normalsOf(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residual,
                              const Eigen::VectorXd& weights,
                              const std::vector<SampleBlock>& blocks) {
  std::vector<Normal> normals;
  for (const SampleBlock& block : blocks) {
    const Eigen::MatrixXd J = jacobian.middleRows(block.offset, block.size);
    const Eigen::MatrixXd WJ = weights.segment(block.offset, block.size).asDiagonal() * J;
    normals.push_back(
        {J.transpose() * WJ, WJ.transpose() * residual.segment(block.offset, block.size)});
  }
  return normals;
}

}  // namespace

Eigen::MatrixXd bootstrapMoves(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residual,
                               const Eigen::VectorXd& weights,
                               const std::vector<SampleBlock>& blocks, int sets,
                               std::uint64_t seed) {
  NAO_CHECK(!blocks.empty() && jacobian.rows() == residual.size());
  const Eigen::Index n = jacobian.cols();
  const std::vector<Normal> normals = normalsOf(jacobian, residual, weights, blocks);
  Eigen::VectorXd scale = Eigen::VectorXd::Zero(n);
  Normal whole{Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n)};
  for (const Normal& one : normals) {
    scale += one.square.diagonal();
    whole.square += one.square;
    whole.side += one.side;
  }
  whole.square += (kRidge * scale.array() + 1e-300).matrix().asDiagonal();
  const Eigen::VectorXd left = whole.square.ldlt().solve(whole.side);  // by the fit's tolerance
  Random random(seed, "blocks");
  Eigen::MatrixXd moves(sets, n);
  for (Eigen::Index s = 0; s < sets; ++s) {
    Eigen::MatrixXd square = (kRidge * scale.array() + 1e-300).matrix().asDiagonal();
    Eigen::VectorXd side = Eigen::VectorXd::Zero(n);
    for (std::size_t b = 0; b < normals.size(); ++b) {
      const auto drawn =
          static_cast<std::size_t>(random.uniform() * static_cast<double>(normals.size()));
      const Normal& one = normals[std::min(drawn, normals.size() - 1)];
      square += one.square;
      side += one.side;
    }
    moves.row(s) = (square.ldlt().solve(side) - left).transpose();
  }
  return moves;
}

double quantileOf(const Eigen::VectorXd& values, double q) {
  std::vector<double> sorted(values.data(), values.data() + values.size());
  if (sorted.empty()) return 0;
  std::sort(sorted.begin(), sorted.end());
  const double place = q * static_cast<double>(sorted.size() - 1);
  const auto low = static_cast<std::size_t>(place);
  const std::size_t high = std::min(low + 1, sorted.size() - 1);
  return sorted[low] + (place - std::floor(place)) * (sorted[high] - sorted[low]);
}

std::vector<SampleBlock> blocksOf(const std::vector<SampleBlock>& logs, std::size_t least,
                                  Eigen::Index rows) {
  if (logs.size() >= least) return logs;
  std::vector<SampleBlock> parts;
  for (const SampleBlock& log : logs) {
    const Eigen::Index count =
        std::max<Eigen::Index>(1, log.size / std::max<Eigen::Index>(1, rows));
    for (Eigen::Index i = 0; i < count; ++i) {
      const Eigen::Index begin = log.size * i / count, end = log.size * (i + 1) / count;
      parts.push_back({log.offset + begin, end - begin});
    }
  }
  return parts;
}

}  // namespace nao::validation

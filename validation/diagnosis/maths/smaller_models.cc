#include "validation/diagnosis/maths/smaller_models.h"

#include <Eigen/QR>
#include <algorithm>

namespace nao::validation {
namespace {

using Places = std::vector<std::size_t>;

constexpr double kUndone = 0.1;  // of the lesser one's squares: what two may leave of each other

Eigen::MatrixXd columnsOf(const std::vector<LinearCause>& model, const Places& kept) {
  Eigen::MatrixXd all(model.front().white.rows(), 0);
  for (const std::size_t place : kept) {
    const Eigen::MatrixXd& one = model[place].white;
    all.conservativeResize(Eigen::NoChange, all.cols() + one.cols());
    all.rightCols(one.cols()) = one;
  }
  return all;
}

// Causes whose bit is set.
Places placesOf(unsigned bits, std::size_t count) {
  Places places;
  for (std::size_t i = 0; i < count; ++i) {
    if ((bits >> i & 1u) != 0) places.push_back(i);
  }
  return places;
}

double fit(const std::vector<LinearCause>& model, const Eigen::VectorXd& whole,
           SmallerModel& smaller) {
  const Eigen::MatrixXd columns = columnsOf(model, smaller.kept);
  smaller.numbers = columns.colPivHouseholderQr().solve(whole);
  return (whole - columns * smaller.numbers).squaredNorm() / 2;
}

}  // namespace

std::vector<SmallerModel> smallerModels(const std::vector<LinearCause>& model,
                                        const Eigen::VectorXd& left, double most) {
  const std::size_t count = model.size();
  Eigen::VectorXd whole = left;  // what all causes together have to explain
  for (const LinearCause& one : model) whole += one.white * one.numbers;
  SmallerModel all{placesOf((1u << count) - 1, count), {}, 0};
  const double least = count > 0 ? fit(model, whole, all) : 0;
  std::vector<SmallerModel> found;
  for (unsigned bits = 1; bits < 1u << count; ++bits) {
    SmallerModel smaller{placesOf(bits, count), {}, 0};
    const Places gone = placesOf(~bits, count);
    const bool may_go = std::all_of(gone.begin(), gone.end(),
                                    [&](std::size_t place) { return model[place].linear; });
    if (gone.size() < 2 || !may_go) continue;
    smaller.cost = fit(model, whole, smaller) - least;
    if (smaller.cost <= most) found.push_back(std::move(smaller));
  }
  std::stable_sort(found.begin(), found.end(), [](const SmallerModel& a, const SmallerModel& b) {
    return a.kept.size() != b.kept.size() ? a.kept.size() < b.kept.size() : a.cost < b.cost;
  });
  return found;
}

std::vector<std::pair<std::size_t, std::size_t>> undoneByEachOther(
    const std::vector<LinearCause>& model) {
  std::vector<Eigen::VectorXd> acts;
  for (const LinearCause& one : model) acts.push_back(one.white * one.numbers);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < acts.size(); ++i) {
    for (std::size_t k = i + 1; k < acts.size(); ++k) {
      const double lesser = std::min(acts[i].squaredNorm(), acts[k].squaredNorm());
      if ((acts[i] + acts[k]).squaredNorm() < kUndone * lesser) pairs.emplace_back(i, k);
    }
  }
  return pairs;
}

}  // namespace nao::validation

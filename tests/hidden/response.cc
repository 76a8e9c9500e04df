#include "tests/hidden/response.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace nao::hidden {
namespace {

constexpr double kActs = 0.05;  // of the largest change: where it is less nothing acts

struct Moments {
  double mean = 0, variance = 0;  // of the repeats
};

Moments momentsAt(const Repeats& repeats, std::size_t i) {
  const auto n = static_cast<double>(repeats.size());
  Moments moments;
  for (const auto& one : repeats) moments.mean += one[i] / n;
  for (const auto& one : repeats) {
    const double off = one[i] - moments.mean;
    moments.variance += off * off / std::max(1.0, n - 1);
  }
  return moments;
}

std::vector<Moments> momentsOf(const Repeats& repeats) {
  NAO_CHECK(!repeats.empty());
  std::vector<Moments> all;
  all.reserve(repeats.front().size());
  for (std::size_t i = 0; i < repeats.front().size(); ++i) all.push_back(momentsAt(repeats, i));
  return all;
}

}  // namespace

Repeats repeatsOf(const validation::LogSet& set, const std::string& joint) {
  return repeatsOfColumn(set, "q." + joint);
}

Repeats repeatsOfColumn(const validation::LogSet& set, const std::string& name) {
  Repeats repeats;
  for (const validation::LogRun& run : set.runs) {
    const auto r = static_cast<std::size_t>(run.repeat);
    repeats.resize(std::max(repeats.size(), r + 1));
    const validation::Column& column = run.columns.at(name);
    repeats[r].insert(repeats[r].end(), column.begin(), column.end());
  }
  return repeats;
}

Repeats less(const Repeats& a, const Repeats& b, double factor) {
  NAO_CHECK(a.size() == b.size());
  Repeats difference = a;
  for (std::size_t r = 0; r < a.size(); ++r) {
    NAO_CHECK(a[r].size() == b[r].size());
    for (std::size_t i = 0; i < a[r].size(); ++i) difference[r][i] -= factor * b[r][i];
  }
  return difference;
}

double spreadOf(const Repeats& repeats) {
  double sum = 0;
  const std::vector<Moments> all = momentsOf(repeats);
  for (const Moments& one : all) sum += one.variance;
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, all.size())));
}

double rmsWhereActing(const Repeats& change) {
  const std::vector<Moments> all = momentsOf(change);
  double most = 0, squares = 0;
  long count = 0;
  for (const Moments& one : all) most = std::max(most, std::abs(one.mean));
  for (const Moments& one : all) {
    if (std::abs(one.mean) < kActs * most) continue;
    squares += one.mean * one.mean - one.variance / static_cast<double>(change.size());
    ++count;
  }
  return count == 0 ? 0 : std::sqrt(std::max(0.0, squares) / static_cast<double>(count));
}

double productOf(const Repeats& a, const Repeats& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.front().size(); ++i) {
    sum += momentsAt(a, i).mean * momentsAt(b, i).mean;
  }
  return sum;
}

}  // namespace nao::hidden

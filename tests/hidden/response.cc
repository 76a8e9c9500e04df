#include "tests/hidden/response.h"

#include <algorithm>
#include <cmath>

namespace nao::hidden {
namespace {

constexpr double kActs = 0.05;  // of the largest change: where it is less nothing acts

}  // namespace

std::vector<double> meansOf(const validation::LogSet& set, const std::string& joint) {
  std::vector<double> all;
  for (std::size_t first = 0; first < set.runs.size();) {
    std::size_t last = first;
    while (last < set.runs.size() && set.runs[last].motion == set.runs[first].motion) ++last;
    const std::size_t rows = set.runs[first].t.size();
    for (std::size_t k = 0; k < rows; ++k) {
      double sum = 0;
      for (std::size_t r = first; r < last; ++r) sum += set.runs[r].columns.at("q." + joint)[k];
      all.push_back(sum / static_cast<double>(last - first));
    }
    first = last;
  }
  return all;
}

double rmsOf(const std::vector<double>& a, const std::vector<double>& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, a.size())));
}

double rmsWhereActing(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  double squares = 0;
  long count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double change = a[i] - b[i];
    if (std::abs(change) < kActs * most) continue;
    squares += change * change;
    ++count;
  }
  return count == 0 ? 0 : std::sqrt(squares / static_cast<double>(count));
}

}  // namespace nao::hidden

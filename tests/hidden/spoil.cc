#include <cmath>

#include "core/check.h"
#include "tests/hidden/hidden_set.h"

namespace nao::hidden {
namespace {

using validation::LogRun;

std::vector<double>& angles(LogRun& run, const std::string& joint) {
  return run.columns.at("q." + joint);
}

}  // namespace

void spoilData(validation::LogSet& set, Spoil spoil) {
  if (spoil == Spoil::None) return;
  NAO_CHECK(!set.joints.empty());
  const std::string& first = set.joints.front().name;
  const std::string& last = set.joints.back().name;
  std::size_t place = 0;
  for (LogRun& run : set.runs) {
    switch (spoil) {
      case Spoil::None:
        break;
      case Spoil::SwapJoints:
        NAO_CHECK(first != last);
        std::swap(angles(run, first), angles(run, last));
        break;
      case Spoil::Negate:
        for (double& q : angles(run, first)) q = -q;
        break;
      case Spoil::Degrees:
        for (double& q : angles(run, first)) q *= 180 / M_PI;
        break;
      case Spoil::Clock:  // one run's clock is set back in its middle
        if (place != set.runs.size() / 2) break;
        for (std::size_t k = run.t.size() / 2; k < run.t.size(); ++k) run.t[k] -= 0.5;
        break;
      case Spoil::Freeze:
        for (double& q : angles(run, first)) q = angles(run, first).front();
        break;
    }
    ++place;
  }
}

}  // namespace nao::hidden

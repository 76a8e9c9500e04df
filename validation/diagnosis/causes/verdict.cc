#include "validation/diagnosis/causes/verdict.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "validation/diagnosis/causes/causes.h"

namespace nao::validation {
namespace {

int gravity(Verdict verdict) {
  switch (verdict) {
    case Verdict::NoDiscrepancy:
      return 0;
    case Verdict::Named:
      return 1;
    case Verdict::Ambiguous:
      return 2;
    case Verdict::PartlyExplained:
      return 3;
    case Verdict::Unknown:
      return 4;
    case Verdict::Unfinished:
      return 5;
    case Verdict::DataFault:
      return 6;
  }
  return 0;
}

std::string textOf(double value, const std::string& unit, int digits = 3) {
  const auto with = [digits](double number, const std::string& name) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    return name.empty() ? text : text + (" " + name);
  };
  if (unit == "rad") return with(value * 180 / M_PI, "deg");
  if (unit == "s") return with(value * 1000, "ms");
  return with(value, unit);
}

// By as many digits as tell its ends apart.
std::string textOf(double low, double high, const std::string& unit) {
  constexpr int kMost = 7;
  int digits = 3;
  while (digits < kMost && textOf(low, unit, digits) == textOf(high, unit, digits)) ++digits;
  return textOf(low, unit, digits) + " to " + textOf(high, unit, digits);
}

}  // namespace

std::vector<FoundNumber> foundNumbers(const Cause& cause, const std::vector<double>& x) {
  std::vector<FoundNumber> numbers;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const FreeNumber& free = cause.free[i];
    numbers.push_back(
        {free.parameter, free.unit, shownValue(free, x[i]), x[i], x[i], x[i], free.form});
  }
  return numbers;
}

double valueAt(const FoundNumber& number, double deviation) {
  if (number.form == Form::Offset) return number.value - number.deviation + deviation;
  return deviation > 0 ? 1 / deviation : INFINITY;
}

std::pair<double, double> valueInterval(const FoundNumber& number) {
  return std::minmax({valueAt(number, number.low), valueAt(number, number.high)});
}

bool mayBeSmall(double low, double high, double smallest) {
  return low < smallest && high > -smallest;
}

double smallestTogether(const std::string& cause, double smallest,
                        const std::vector<Rival>& rivals) {
  const auto same = std::count_if(rivals.begin(), rivals.end(), [&](const Rival& rival) {
    return rival.cause == cause && !rival.place.empty();
  });
  return smallest * std::sqrt(1.0 + static_cast<double>(same));
}

std::string valueText(const FoundNumber& number) { return textOf(number.value, number.unit); }

std::string intervalText(const FoundNumber& number) {
  const auto [low, high] = valueInterval(number);
  return textOf(low, high, number.unit);
}

std::string deviationIntervalText(const FoundNumber& number) {
  return textOf(number.low, number.high, number.unit);
}

std::string sizeIntervalText(const Finding& finding) {
  const std::string text = intervalText(finding.numbers[0]);
  if (finding.as_shaped.empty() || intervalText(finding.as_shaped[0]) == text) return text;
  return text + "; if all else is as found, " + intervalText(finding.as_shaped[0]);
}

bool JointVerdict::scattersOtherwise() const {
  constexpr double kHalf = 1.5;  // fits to six repeats differ by less
  if (noise <= 0 || nominal_noise <= 0) return false;
  return noise > kHalf * nominal_noise || noise < nominal_noise / kHalf;
}

std::vector<const Finding*> JointVerdict::named() const {
  std::vector<const Finding*> found;
  for (const Finding& one : findings) {
    if (!one.small) found.push_back(&one);
  }
  return found;
}

const char* wordOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::NoDiscrepancy:
      return "no_discrepancy";
    case Verdict::Named:
      return "named";
    case Verdict::Ambiguous:
      return "ambiguous";
    case Verdict::PartlyExplained:
      return "partly_explained";
    case Verdict::Unknown:
      return "unknown";
    case Verdict::DataFault:
      return "data_fault";
    case Verdict::Unfinished:
      return "unfinished";
  }
  return "";
}

int exitCodeOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::NoDiscrepancy:
      return 0;
    case Verdict::Named:
      return 10;
    case Verdict::Ambiguous:
      return 11;
    case Verdict::PartlyExplained:
    case Verdict::Unknown:
      return 12;
    case Verdict::Unfinished:
      return 13;
    case Verdict::DataFault:
      return 20;
  }
  return 1;
}

Verdict overall(const std::vector<JointVerdict>& joints) {
  Verdict worst = Verdict::NoDiscrepancy;
  for (const JointVerdict& joint : joints) {
    if (gravity(joint.verdict) > gravity(worst)) worst = joint.verdict;
  }
  return worst;
}

}  // namespace nao::validation

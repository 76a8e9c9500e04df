#include "ci/expectation.h"

#include <cmath>
#include <vector>

#include "ci/sentence.h"
#include "core/config_node.h"

namespace nao::ci {

bool Comparison::accepts(const std::string& text, const std::optional<double>& number) const {
  if ((min || max) && !number) return false;
  if (min && *number < *min) return false;
  if (max && *number > *max) return false;
  if (contains && text.find(*contains) == std::string::npos) return false;
  if (!equals) return true;
  const auto wanted = parseNumber(*equals);
  if (wanted && number) return std::abs(*number - *wanted) <= tolerance;
  return text == *equals;
}

std::string Comparison::described() const {
  std::vector<std::string> parts;
  if (equals) parts.push_back("is " + *equals);
  if (equals && tolerance > 0) parts.back() += " within " + shown(tolerance);
  if (contains) parts.push_back("contains '" + *contains + "'");
  if (min) parts.push_back("at least " + shown(*min));
  if (max) parts.push_back("at most " + shown(*max));
  std::string all;
  for (const std::string& part : parts) all += (all.empty() ? "" : " and ") + part;
  return all;
}

std::string When::described() const {
  const std::string window =
      from == Duration::zero() ? "until " + shown(to) : "from " + shown(from) + " to " + shown(to);
  switch (kind) {
    case Kind::At:
      return "at " + shown(to);
    case Kind::By:
      return from == Duration::zero() ? "by " + shown(to) : "once " + window;
    case Kind::Always:
      return "always " + window;
    case Kind::Never:
      return "never " + window;
  }
  return {};
}

}  // namespace nao::ci

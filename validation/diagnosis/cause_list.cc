#include "validation/diagnosis/cause_list.h"

#include <sstream>

#include "core/config.h"
#include "validation/diagnosis/causes.h"

namespace nao::validation {
namespace {

std::string scopeOf(const Cause& cause) {
  return cause.scope == Scope::Robot ? "all joints first, then each" : "each joint";
}

}  // namespace

std::string listCausesAsText() {
  std::ostringstream out;
  for (const Cause& cause : jointCauses()) {
    out << cause.id << "  [";
    for (std::size_t i = 0; i < cause.free.size(); ++i) {
      out << (i > 0 ? ", " : "") << cause.free[i].parameter;
    }
    out << "]  " << scopeOf(cause) << "\n";
  }
  return out.str();
}

std::string showCause(const std::string& id) {
  for (const Cause& cause : jointCauses()) {
    if (cause.id != id) continue;
    std::ostringstream out;
    const sim::EffectType& type = *sim::standardEffects().find(cause.effect);
    out << cause.id << ": " << type.summary << "\n";
    out << "said as: " << cause.fill("JOINT", "VALUE") << "\n";
    out << "tried on: " << scopeOf(cause) << "\n";
    for (const FreeNumber& number : cause.free) {
      for (const sim::Parameter& p : type.parameters) {
        if (p.name != number.parameter) continue;
        out << "fits " << p.name << (p.unit.empty() ? "" : " [" + p.unit + "]") << ": " << p.min
            << " to " << p.max << ", " << p.neutral << " does nothing, less than " << p.smallest
            << " matters to nobody\n";
      }
    }
    out << "told from its rivals by: " << cause.separate << "\n";
    return out.str();
  }
  throw InputError("no cause \"" + id + "\" in the catalogue; `usarnaoqi catalog` lists them");
}

}  // namespace nao::validation

#include "sim/effects/parameter.h"

#include <algorithm>

#include "core/check.h"

namespace nao::sim {

const Parameter& parameterOf(const EffectCatalogue& catalogue, std::string_view effect,
                             std::string_view parameter) {
  const EffectType* type = catalogue.find(effect);
  NAO_CHECK(type != nullptr);
  const auto found = std::find_if(type->parameters.begin(), type->parameters.end(),
                                  [&](const Parameter& one) { return one.name == parameter; });
  NAO_CHECK(found != type->parameters.end());
  return *found;
}

}  // namespace nao::sim

#include "validation/diagnosis/effects_key.h"

#include <sstream>

namespace nao::validation {

std::string keyOf(std::size_t motion, const std::vector<EffectSetting>& effects) {
  std::ostringstream key;
  key.precision(17);
  key << motion;
  for (const EffectSetting& effect : effects) {
    key << '|' << effect.name;
    for (const auto& [name, value] : effect.parameters) key << ' ' << name << '=' << value;
    for (const Joint joint : effect.joints) key << ' ' << index(joint);
  }
  return key.str();
}

}  // namespace nao::validation

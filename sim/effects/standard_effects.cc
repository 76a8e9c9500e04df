#include "sim/effects/catalogue.h"

namespace nao::sim {

// One line per effect; each is defined in the file of the same name.
EffectType encoderQuantum();

const EffectCatalogue& standardEffects() {
  static const EffectCatalogue catalogue = [] {
    EffectCatalogue all;
    all.add(encoderQuantum());
    return all;
  }();
  return catalogue;
}

}  // namespace nao::sim

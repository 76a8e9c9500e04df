#pragma once

#include <vector>

#include "core/robot_model.h"
#include "sim/effects/catalogue.h"

namespace nao::validation {

/// The effects of `model` with `causes` on top. A cause is a deviation from the model: where the
/// model has the same effect on a joint already, the two differences from neutral add up (a play of
/// 1.0 degree and a cause of -0.4 leave 0.6), kept within the parameter's bounds. A cause without
/// joints acts on all. Causes on joints without that effect are appended as they are.
std::vector<EffectSetting> mergedEffects(const RobotModel& model,
                                         const std::vector<EffectSetting>& causes,
                                         const sim::EffectCatalogue& catalogue);

/// The effect with every parameter at neutral: what is set on top is all that it does.
EffectSetting neutralSetting(const std::string& effect, const sim::EffectCatalogue& catalogue);

/// How far from neutral the model's own effect already is on this joint; 0 where it has none.
double presentDeviation(const RobotModel& model, std::size_t joint, const std::string& effect,
                        const std::string& parameter, const sim::EffectCatalogue& catalogue);

}  // namespace nao::validation

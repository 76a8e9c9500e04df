#include "validation/diagnosis/rig/run_load.h"

#include <cstddef>

#include "core/check.h"

namespace nao::validation {

std::optional<EffectSetting> effectOf(const LogLoad& load, const RobotModel& model) {
  const std::optional<int> link = model.findBody(load.link);
  if (!link) {
    throw InputError("load: expected a link of " + model.name + ", found '" + load.link + "'");
  }
  if (*link == 0 && model.fixed_base) return {};
  if (*link == 0) throw InputError("load: expected a link that moves, found the torso");
  const Vec3& p = load.p_BoBcm_B;
  const Joint joint = model.coordinates[static_cast<std::size_t>(*link) - 1].joint;
  return EffectSetting{
      "payload", {{"mass", load.mass}, {"x", p.x()}, {"y", p.y()}, {"z", p.z()}}, {joint}, ""};
}

}  // namespace nao::validation

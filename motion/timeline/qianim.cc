#include "motion/timeline/qianim.h"

#include <set>

#include "core/check.h"
#include "motion/timeline/xar_curve.h"
#include "motion/timeline/xar_element.h"

namespace nao::motion {
namespace {

// The joint of a curve that is to be played; warns where it can not be.
std::optional<Joint> jointOf(const XarElement& curve, const RobotModel& model,
                             TimelineBuilder& builder) {
  if (curve.flag("mute", false)) return std::nullopt;
  const std::string name = curve.text("actuator");
  if (curve.text("unit") == "meter") {
    builder.warn(curve.place() + ": " + name + " is in metres, not a joint of a Nao");
    return std::nullopt;
  }
  const auto joint = model.findJoint(name);
  if (!joint) builder.warn(curve.place() + ": this robot has no joint " + name);
  return joint;
}

}  // namespace

Timeline readQianim(const std::string& text, const std::string& source, const RobotModel& model) {
  tinyxml2::XMLDocument document;
  TimelineBuilder builder;
  for (std::string& sentence : parseXml(document, text, source)) {
    builder.addBroken(std::move(sentence));
  }
  const tinyxml2::XMLElement* root = document.FirstChildElement("Animation");
  if (root == nullptr) builder.failIfBroken();
  if (root == nullptr) throw InputError(source + ":1: expected an <Animation>");

  const XarElement animation(root, &source);
  std::set<std::size_t> done;
  // The robot's own name goes first: LHipYawPitch wins over its other name RHipYawPitch.
  for (const bool aliases : {false, true}) {
    for (const XarElement& curve : animation.children("ActuatorCurve")) {
      if ((model.aliases.count(curve.text("actuator")) != 0) != aliases) continue;
      const auto joint = jointOf(curve, model, builder);
      if (!joint || !done.insert(index(*joint)).second) continue;
      const bool is_hand = model.actuators[index(*joint)].coordinates.empty();
      builder.attempt(
          [&] { addXarCurve(curve, readXarClock(curve), *joint, is_hand, 0, builder); });
    }
  }
  if (builder.isEmpty()) builder.failIfBroken();
  if (builder.isEmpty()) animation.fail("no curve here moves a joint of this robot");
  return builder.take();
}

}  // namespace nao::motion

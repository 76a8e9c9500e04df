#pragma once

#include <string>
#include <vector>

#include "motion/timeline/timeline.h"

namespace nao::motion {

/// Reads a Choregraphe behavior (.xar, versions 1 and 3). Boxes play their timelines in the order
/// their links give, each as soon as what it is linked to has ended; scripts, sounds and texts in
/// boxes take no time and are left out with a warning, as are joints this robot has not.
///
///   time of a key [s] = (frame - start_frame) / fps of its timeline
///   value: degrees; hands 0 to 1 (unit 1, or any unit on a hand); percent if above 1
///   a key without a tangent is bezier_auto on both sides
///
/// What is broken is left out and told in `broken`; boxes whose links are lost play in their order.
///
/// `source` names the text in messages (a file, or what the client called it).
/// @throws InputError with source and line if the text is not such a behavior, or if nothing in it
/// starts by itself, or is left of it.
Timeline readXar(const std::string& text, const std::string& source, const RobotModel& model);

/// Whether a box of a behavior has code in it. @throws InputError if the text is no behavior.
bool hasCode(const std::string& text, const std::string& source);

/// A timeline of one box, as if that box were started alone.
struct BoxTimeline {
  std::string box;
  Timeline timeline;
};

/// Every box of a behavior with a timeline of its own that moves a joint of this robot, in the
/// order of the text: also those that only a script or a choice would start.
/// @throws InputError as readXar, but may return none.
std::vector<BoxTimeline> readXarBoxes(const std::string& text, const std::string& source,
                                      const RobotModel& model);

}  // namespace nao::motion

#pragma once

#include <optional>
#include <vector>

#include "core/robot_model.h"
#include "motion/motion_request.h"
#include "motion/timeline/timeline.h"
#include "motion/timeline/xar_element.h"

namespace nao::motion {

/// The clock of one timeline.
struct XarClock {
  double fps = 25;
  double start_frame = 0;
  std::optional<double> end_frame;

  double timeOf(double frame) const { return (frame - start_frame) / fps; }  // [s]
};

/// @throws InputError if the frame rate is not positive.
XarClock readXarClock(const XarElement& timeline);

/// One ActuatorCurve of a joint: keys between the first and the last frame, times from the start
/// of the timeline on. A key on the first frame itself counts half a frame later, since a motion
/// takes time. Tells `builder` of keys that can not be played as they are written, or not at all.
/// It is played from `start` [s] on. @returns when its last key is; `start` if it has none.
/// @throws InputError if its unit is unknown.
double addXarCurve(const XarElement& curve, const XarClock& clock, Joint joint, bool is_hand,
                   double start, TimelineBuilder& builder);

}  // namespace nao::motion

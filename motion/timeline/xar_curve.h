#pragma once

#include <optional>

#include "core/robot_model.h"
#include "motion/motion_request.h"
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
/// takes time.
Curve readXarCurve(const XarElement& curve, const XarClock& clock, Joint joint, bool is_hand);

}  // namespace nao::motion

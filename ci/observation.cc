#include "ci/observation.h"

#include <algorithm>
#include <cmath>

#include "camera/ground_truth.h"
#include "camera/renderer.h"
#include "ci/sentence.h"
#include "core/overloaded.h"
#include "runtime/ground_truth.h"

namespace nao::ci {
namespace {

constexpr double kDown = 60 * M_PI / 180;  // [rad] as validation/play_faults.h calls a fall
constexpr camera::ImageSize kPicture{160, 120};

double tiltOf(const Moment& moment, std::size_t robot) {
  const Pose& X_WT = moment.scene->robots[robot].X_WB.front();
  return std::acos(std::clamp(X_WT.linear()(2, 2), -1.0, 1.0));
}

Observation lookAt(const Upright& upright, const Moment& moment) {
  const double tilt = tiltOf(moment, upright.robot);
  return {tilt < kDown, tilt, "its torso tilts by " + shownDegrees(tilt)};
}

Observation lookAt(const Fallen& fallen, const Moment& moment) {
  const double tilt = tiltOf(moment, fallen.robot);
  return {tilt > kDown, -tilt, "its torso tilts by " + shownDegrees(tilt)};
}

Observation lookAt(const InPlace& place, const Moment& moment) {
  Eigen::Vector2d p_W;
  std::string seen;
  double turned = 0;
  if (place.is_ball) {
    p_W = moment.scene->balls[place.which].p_W.head<2>();
  } else {
    const SceneFrame::Robot& robot = moment.scene->robots[place.which];
    const Pose2 pose = runtime::calcFloorPose(*robot.model, robot.X_WB);
    p_W = {pose.x, pose.y};
    if (place.heading) {
      turned = std::abs(wrapAngle(pose.theta - *place.heading));
      seen = ", heading " + shownDegrees(pose.theta);
    }
  }
  const double away = (p_W - place.center).norm();
  const bool holds = away <= place.radius && turned <= place.heading_tolerance;
  return {holds, away / place.radius + (place.heading ? turned / place.heading_tolerance : 0),
          "at (" + shown(p_W.x()) + ", " + shown(p_W.y()) + ")" + seen};
}

Observation compared(const Comparison& wanted, const HeardValue& value) {
  const bool holds = wanted.accepts(value.text, value.number);
  double off = holds ? 0 : 1;
  if (!holds && value.number && wanted.min) off = std::abs(*wanted.min - *value.number);
  if (!holds && value.number && wanted.max) off = std::abs(*wanted.max - *value.number);
  return {holds, off, "it is " + value.text};
}

Observation lookAt(const MemoryIs& memory, const Moment& moment) {
  const auto found = moment.heard.memory.find({memory.robot, memory.key});
  if (found == moment.heard.memory.end()) return {false, 1e300, "there is no such key"};
  return compared(memory.value, found->second);
}

Observation lookAt(const EventRaised& event, const Moment& moment) {
  Observation best{false, 1e300, ""};
  for (const HeardEvent& heard : moment.heard.events) {
    if (heard.robot != event.robot || heard.key != event.key) continue;
    Observation one = compared(event.value, heard.value);
    one.seen = "raised with " + heard.value.text;
    if (one.holds) return one;
    best = one;
  }
  return best;
}

Observation lookAt(const TextSaid& said, const Moment& moment) {
  Observation best{false, 1e300, ""};
  for (const HeardEvent& heard : moment.heard.events) {
    const bool begins = heard.key == "ALTextToSpeech/CurrentSentence" && !heard.value.text.empty();
    if (heard.robot != said.robot || !begins) continue;
    best = {heard.value.text.find(said.text) != std::string::npos, 1,
            "said '" + heard.value.text + "'"};
    if (best.holds) return best;
  }
  return best;
}

Observation lookAt(const ClientEnded& end, const Moment& moment) {
  for (const EndedClient& ended : moment.ended) {
    if (ended.client != end.client) continue;
    return {ended.code == end.code, 1, "ended with exit code " + std::to_string(ended.code)};
  }
  return {false, 1e300, ""};
}

Observation lookAt(const JointIs& joint, const Moment& moment) {
  if (!moment.sensors[joint.robot]) return {false, 1e300, "nothing was measured yet"};
  const double angle = moment.sensors[joint.robot]->angle[joint.joint];
  const double off = std::abs(angle - joint.angle);
  return {off <= joint.tolerance, off, "at " + shown(angle) + " rad"};
}

Observation lookAt(const NoViolation& none, const Moment& moment) {
  for (const Violation& violation : moment.violations) {
    if (violation.robot != none.robot || none.allowed.count(violation.kind)) continue;
    return {false, 1, violation.kind + ": " + violation.text};
  }
  return {true, 0, ""};
}

}  // namespace

Observer::Observer() = default;
Observer::~Observer() = default;

Observation Observer::look(const Condition& condition, const Moment& moment) {
  return std::visit(
      [&](const auto& c) {
        if constexpr (std::is_same_v<std::decay_t<decltype(c)>, SeesBall>) {
          return this->lookAt(c, moment);
        } else {
          return ci::lookAt(c, moment);
        }
      },
      condition);
}

Observation Observer::lookAt(const SeesBall& image, const Moment& moment) {
  if (!renderer_) renderer_ = std::make_unique<camera::Renderer>();
  const camera::CameraPlace place{image.robot, image.camera};
  const auto view = camera::viewOf(*moment.scene, place, kPicture);
  const auto truth = camera::calcGroundTruth(*moment.scene, place, view, *renderer_);
  const camera::Pixel wanted = camera::Labels(*moment.scene).ofBall(image.ball);
  int pixels = 0;
  for (const camera::LabelBox& box : truth.boxes) {
    if (box.label == wanted) pixels = box.pixels;
  }
  return {pixels >= image.pixels, -1.0 * pixels, std::to_string(pixels) + " pixels of it are seen"};
}

}  // namespace nao::ci

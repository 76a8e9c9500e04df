#include "naoqi_api/services/ball_services.h"

#include <string>
#include <utility>

#include "naoqi_api/services/al_tracker.h"
#include "naoqi_api/services/ball_watch.h"
#include "naoqi_api/services/extractor.h"
#include "naoqi_api/services/make_module.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Answer;
using rpc::Argument;
using rpc::CallError;
using rpc::Value;
using Watch = std::shared_ptr<BallWatch>;

std::vector<float> asFloats(const Vec3& place) {
  return {static_cast<float>(place.x()), static_cast<float>(place.y()),
          static_cast<float>(place.z())};
}

ServicePointer makeDetection(const ServiceContext& context, const Watch& watch) {
  auto service = makeModule("ALRedBallDetection", "A red ball in the cameras' pictures.");
  const auto extractor = std::make_shared<Extractor>(context.store(), "ALRedBallDetection",
                                                     Extractor::Outputs{{"redBallDetected"}, {}});
  extractor->declare(*service);
  extractor->onWorking([watch](bool works) { watch->want("ALRedBallDetection", works); });
  service->owning(extractor);
  return service;
}

ServicePointer makeRedBallTracker(const Watch& watch) {
  auto service = makeModule("ALRedBallTracker", "Turns the head to a red ball.");
  addFunction(
      *service, "startTracker",
      [watch] {
        watch->want("ALRedBallTracker", true);
        watch->follow(true);
      },
      "The head follows the ball from now on.");
  addFunction(
      *service, "stopTracker",
      [watch] {
        watch->want("ALRedBallTracker", false);
        watch->follow(false);
      },
      "The head stays where it is.");
  addFunction(
      *service, "getPosition", [watch] { return asFloats(watch->position()); },
      "Where the ball was seen last, in the torso's frame [m]; zeros before.");
  addFunction(
      *service, "isNewData", [watch] { return watch->takeNews(); },
      "Whether the ball was seen since this was asked last.");
  addFunction(
      *service, "isActive", [watch] { return watch->isWanted("ALRedBallTracker"); },
      "Whether the tracker runs.");
  addFunction(
      *service, "setWholeBodyOn", [](bool) {}, "Is kept: the head alone follows.",
      Argument{"wholeBodyOn", "Ignored."})
      .answering(Answer::Simplified);
  return service;
}

// Nobody is there, so it follows nothing.
ServicePointer makeFaceTracker() {
  auto service = makeModule("ALFaceTracker", "Turns the head to a face; there are none.");
  const auto active = std::make_shared<bool>(false);
  addFunction(
      *service, "startTracker", [active] { *active = true; }, "Runs and sees no face.");
  addFunction(
      *service, "stopTracker", [active] { *active = false; }, "Ends it.");
  addFunction(
      *service, "isActive", [active] { return *active; }, "Whether the tracker runs.");
  addFunction(
      *service, "isNewData", [] { return false; }, "False: no face is seen.");
  addFunction(
      *service, "getPosition", [] { return asFloats(Vec3::Zero()); }, "Zeros: no face was seen.");
  addFunction(
      *service, "setWholeBodyOn", [](bool) {}, "Has no effect.",
      Argument{"wholeBodyOn", "Ignored."});
  service->allAnswering(Answer::Simplified);
  return service;
}

}  // namespace

std::vector<ServicePointer> makeBallServices(const ServiceContext& context,
                                             const std::shared_ptr<camera::ImageFeed>& images) {
  const auto watch = std::make_shared<BallWatch>(context, images);
  return {makeDetection(context, watch), makeRedBallTracker(watch), makeFaceTracker(),
          makeAlTracker(context, watch)};
}

}  // namespace nao::services

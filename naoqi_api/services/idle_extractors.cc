#include "naoqi_api/services/idle_extractors.h"

#include <string>
#include <utility>

#include "naoqi_api/al_module.h"
#include "naoqi_api/services/extractor.h"
#include "naoqi_api/services/naoqi_method.h"
#include "naoqi_api/services/settings.h"

namespace nao::services {
namespace {

using rpc::Value;

struct IdleExtractor {
  std::string name;
  std::string meaning;
  std::vector<std::string> events;
  SettingDefaults defaults;
};

// Events: event tables of the 1.14 and 2.1 documentation.
std::vector<IdleExtractor> idleExtractors() {
  const SettingDefaults camera = {
      {"ActiveCamera", 0}, {"FrameRate", 15}, {"Resolution", 1}, {"ColorSpace", 11}};
  return {
      {"ALFaceDetection", "Faces; there are none.", {"FaceDetected"}, camera},
      {"ALLandMarkDetection", "Naomarks; there are none.", {"LandmarkDetected"}, camera},
      {"ALMovementDetection",
       "What moves in the picture; nothing is looked for.",
       {"MovementDetection/MovementDetected", "MovementDetection/NoMovement"},
       camera},
      {"ALBarcodeReader", "Bar codes; there are none.", {"BarcodeReader/BarcodeDetected"}, camera},
      {"ALVisionRecognition", "Learnt pictures; there are none.", {"PictureDetected"}, camera},
      {"ALDarknessDetection",
       "How dark it is; nothing is looked for.",
       {"DarknessDetection/DarknessDetected"},
       camera},
      {"ALBacklightingDetection",
       "Light from behind; nothing is looked for.",
       {"BacklightingDetection/BacklightingDetected"},
       camera},
      {"ALPeoplePerception",
       "People; there are none.",
       {"PeoplePerception/PeopleDetected", "PeoplePerception/PeopleList",
        "PeoplePerception/JustArrived", "PeoplePerception/JustLeft",
        "PeoplePerception/VisiblePeopleList", "PeoplePerception/NonVisiblePeopleList",
        "PeoplePerception/PopulationUpdated"},
       {{"MaximumDetectionRange", 3.5F}, {"MinimumBodyHeight", 0.8F}, {"MaximumBodyHeight", 2.3F}}},
      {"ALSittingPeopleDetection",
       "People that sit; there are none.",
       {"SittingPeopleDetection/PersonSittingDown", "SittingPeopleDetection/PersonStandingUp"},
       {}},
      {"ALWavingDetection",
       "People that wave; there are none.",
       {"WavingDetection/Waving", "WavingDetection/PersonWaving"},
       {}},
      {"ALGazeAnalysis",
       "Where people look; there are none.",
       {"GazeAnalysis/PersonStartsLookingAtRobot", "GazeAnalysis/PersonStopsLookingAtRobot",
        "GazeAnalysis/PeopleLookingAtRobot"},
       {}},
      {"ALEngagementZones",
       "How near people are; there are none.",
       {"EngagementZones/PeopleInZonesUpdated", "EngagementZones/PersonApproached",
        "EngagementZones/PersonMovedAway"},
       {{"FirstLimitDistance", 1.5F}, {"SecondLimitDistance", 2.5F}, {"LimitAngle", 90.0F}}},
      {"ALSoundDetection",
       "Loud sounds; there are none.",
       {"SoundDetected"},
       {{"Sensitivity", 0.9F}}},
      {"ALSoundLocalization",
       "Where sounds come from; there are none.",
       {"ALSoundLocalization/SoundLocated"},
       {{"Sensitivity", 0.9F}}},
      {"ALAudioSourceLocalization",
       "Where sounds come from; there are none.",
       {"ALAudioSourceLocalization/SoundLocated"},
       {{"Sensitivity", 0.9F}}},
      {"ALAutomaticVolume", "Loudness that follows the noise; there is none.", {}, {}},
      {"ALFastPersonTracking", "People to follow; there are none.", {}, camera},
      {"ALFindPersonHead", "People's heads; there are none.", {}, camera},
      {"ALCloseObjectDetection",
       "Things close by, which needs a depth camera; a Nao has none.",
       {"CloseObjectDetection/ObjectDetected", "CloseObjectDetection/ObjectNotDetected"},
       camera},
  };
}

// Where a program looks for what was seen last: nothing, as a list.
void tellNothing(memory::MemoryStore& store, const IdleExtractor& idle) {
  for (const std::string& event : idle.events) {
    if (!store.find(event) || store.find(event)->last.value.isVoid()) {
      store.insert(event, Value::list({}));
    }
  }
}

std::shared_ptr<rpc::Service> make(const ServiceContext& context, const IdleExtractor& idle,
                                   const DocumentedService& documented) {
  auto service = std::make_shared<rpc::Service>(rpc::alModule(idle.name, idle.meaning));
  const auto extractor =
      std::make_shared<Extractor>(context.store(), idle.name, Extractor::Outputs{idle.events, {}});
  extractor->declare(*service);
  extractor->onWorking([&store = context.store(), idle](bool works) {
    if (works) tellNothing(store, idle);
  });
  service->owning(extractor);
  addSettings(*service, documented, idle.defaults);
  service->allAnswering(rpc::Answer::Simplified);
  return service;
}

}  // namespace

std::vector<std::shared_ptr<rpc::Service>> makeIdleExtractors(const ServiceContext& context) {
  std::vector<std::shared_ptr<rpc::Service>> services;
  for (const IdleExtractor& idle : idleExtractors()) {
    services.push_back(make(context, idle, documentedService(idle.name)));
  }
  return services;
}

}  // namespace nao::services

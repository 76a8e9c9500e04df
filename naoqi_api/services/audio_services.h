#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "naoqi_api/pending.h"
#include "naoqi_api/service.h"
#include "naoqi_api/services/service_context.h"

namespace nao::services {

/// How ALTextToSpeech says a text.
using Say = std::function<rpc::Pending<void>(const std::string& text)>;

/// ALAudioPlayer, ALAudioDevice, ALAudioRecorder, ALSpeechRecognition, ALAnimatedSpeech,
/// ALDialog: nothing sounds, and nobody speaks. What is played takes its time and is logged.
std::vector<std::shared_ptr<rpc::Service>> makeAudioServices(const ServiceContext& context,
                                                             const Say& say);

}  // namespace nao::services

#pragma once

#include "naoqi_api/services/make_module.h"
#include "naoqi_api/services/service_context.h"

namespace nao::services {

/// Adds startMicrophonesRecording and stopMicrophonesRecording of ALAudioDevice: four channels at
/// 48 kHz. The microphones hear nothing: below --data-dir comes a silent file as long as simulated
/// time went on; without that folder a recording is logged alone.
void declareRecording(rpc::Service& service, const ServiceContext& context);

/// ALAudioRecorder: the same with a rate and channels of one's choice.
ServicePointer makeAudioRecorder(const ServiceContext& context);

}  // namespace nao::services

#include <alaudio/alsoundextractor.h>
#include <alcommon/albroker.h>

#include <cstring>
#include <vector>

namespace AL {
namespace {

// Aligned for samples, as a value's bytes need not be.
std::vector<AL_SOUND_FORMAT> samplesOf(const std::string& module, int channels, int samples,
                                       const ALValue& buffer) {
  const auto count = static_cast<long long>(channels) * samples;
  const auto held = buffer.isBinary() ? buffer.getSize() / sizeof(AL_SOUND_FORMAT) : 0;
  if (channels < 0 || samples < 0 || !buffer.isBinary() || held < static_cast<std::size_t>(count))
    throw ALERROR(module, "processRemote", "expected channels * samples numbers of 16 bit");
  std::vector<AL_SOUND_FORMAT> all(static_cast<std::size_t>(count));
  if (count > 0) std::memcpy(all.data(), buffer.GetBinary(), all.size() * sizeof all[0]);
  return all;
}

}  // namespace

ALSoundExtractor::ALSoundExtractor(boost::shared_ptr<ALBroker> broker, std::string name)
    : ALModule(broker, name),
      fIsRunning(false),
      fbDebugMode(false),
      audioDevice(new ALProxy(broker, "ALAudioDevice")) {
  functionName("processRemote", name, "Takes a piece of sound.");
  addParam("nbOfChannels", "Channels in it.");
  addParam("nbrOfSamplesByChannel", "Samples of each.");
  addParam("timeStamp", "[s, us] of its end.");
  addParam("buffer", "Signed 16 bit samples.");
  BIND_METHOD(ALSoundExtractor::processRemote);
  functionName("processSoundRemote", name, "The same without a time.");
  addParam("nbOfChannels", "Channels in it.");
  addParam("nbrOfSamplesByChannel", "Samples of each.");
  addParam("buffer", "Signed 16 bit samples.");
  BIND_METHOD(ALSoundExtractor::processSoundRemote);
}

ALSoundExtractor::~ALSoundExtractor() { ALSoundExtractor::stopDetection(); }

void ALSoundExtractor::startDetection() {
  if (fIsRunning) return;
  audioDevice->callVoid("subscribe", getName());
  fIsRunning = true;
}

// Called by destructors, too.
void ALSoundExtractor::stopDetection() {
  if (!fIsRunning) return;
  fIsRunning = false;
  try {
    audioDevice->callVoid("unsubscribe", getName());
  } catch (const ALError&) {
    // The robot has gone, and the subscription with it.
  }
}

void ALSoundExtractor::process(const int& channels, const int& samples_per_channel,
                               const AL_SOUND_FORMAT* buffer, const ALValue& /*time_stamp*/) {
  processSound(channels, samples_per_channel, buffer);
}

void ALSoundExtractor::processSound(const int /*channels*/, const int /*samples_per_channel*/,
                                    const AL_SOUND_FORMAT* /*buffer*/) {}

void ALSoundExtractor::processRemote(const int& channels, const int& samples_per_channel,
                                     const ALValue& time_stamp, const ALValue& buffer) {
  const auto samples = samplesOf(getName(), channels, samples_per_channel, buffer);
  process(channels, samples_per_channel, samples.data(), time_stamp);
}

void ALSoundExtractor::processSoundRemote(const int& channels, const int& samples_per_channel,
                                          const ALValue& buffer) {
  processRemote(channels, samples_per_channel, fNullTimestamp, buffer);
}

}  // namespace AL

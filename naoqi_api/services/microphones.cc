#include "naoqi_api/services/microphones.h"

#include <algorithm>
#include <utility>

#include "naoqi_api/services/data_files.h"
#include "naoqi_api/services/naoqi_method.h"
#include "naoqi_api/services/wav_file.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::CallError;
using rpc::Value;

constexpr double kLongest = 60;  // [s] written of a recording; free

/// One recording at a time.
class Recorder {
 public:
  explicit Recorder(ServiceContext context) : context_(std::move(context)) {}

  void start(const std::string& file, int rate, int channels) {
    stop();  // as its client may have gone
    if (!context_.data_dir.empty()) dataPath(context_.data_dir, file);
    if (rate < 1000 || rate > 48000) throw CallError("expected a rate of 1000 to 48000 Hz");
    if (channels < 1 || channels > 4) throw CallError("expected 1 to 4 channels");
    file_ = file;
    rate_ = rate;
    channels_ = channels;
    began_ = context_.link.now();
    context_.log("records: " + file);
  }

  void stop() {
    const std::string file = std::exchange(file_, {});
    if (file.empty() || context_.data_dir.empty()) return;
    const double length = std::min(toSeconds(context_.link.now() - began_), kLongest);
    writeDataFile(context_.data_dir, file, wavFile(Sound::silence(length, rate_, channels_)));
  }

 private:
  ServiceContext context_;
  std::string file_;  // empty: none is under way
  int rate_ = 0;
  int channels_ = 0;
  SimTime began_{};
};

}  // namespace

void declareRecording(rpc::Service& service, const ServiceContext& context) {
  const auto recorder = std::make_shared<Recorder>(context);
  addFunction(
      service, "startMicrophonesRecording",
      [recorder](const std::string& file) { recorder->start(file, 48000, 4); },
      "Begins a recording below --data-dir; it is silent.", Argument{"fileName", "Its path."});
  addFunction(
      service, "stopMicrophonesRecording", [recorder] { recorder->stop(); },
      "Ends a recording and writes its file: a minute at most.");
}

ServicePointer makeAudioRecorder(const ServiceContext& context) {
  auto service = makeModule("ALAudioRecorder", "Records microphones that hear nothing.");
  const auto recorder = std::make_shared<Recorder>(context);
  addFunction(
      *service, "startMicrophonesRecording",
      [recorder](const std::string& file, const std::string& type, int rate,
                 const Value& channels) {
        if (type != "wav" && type != "ogg") throw CallError("expected wav or ogg, got " + type);
        const auto wanted = channels.to<std::vector<int>>();
        const auto count = std::count_if(wanted.begin(), wanted.end(), [](int on) { return on; });
        recorder->start(file, rate, static_cast<int>(count));
      },
      "Begins a recording below --data-dir; it is silent.", Argument{"fileName", "Its path."},
      Argument{"type", "wav or ogg; a WAV file either way."}, Argument{"sampleRate", "[Hz]"},
      Argument{"channels", "[left, right, front, rear], 1 for those that are wanted."});
  addFunction(
      *service, "stopMicrophonesRecording", [recorder] { recorder->stop(); },
      "Ends a recording and writes its file: a minute at most.");
  service->allAnswering(rpc::Answer::Simplified);
  return service;
}

}  // namespace nao::services

#include "naoqi_api/services/al_audio_player.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "naoqi_api/al_module.h"
#include "naoqi_api/services/data_files.h"
#include "naoqi_api/services/finite.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::CallError;

constexpr double kUnknownLength = 3;  // [s] free: of a sound whose file is not there
constexpr std::size_t kMostFiles = 1024;

std::uint32_t littleEndian(const char* bytes) {
  std::uint32_t number = 0;
  for (int i = 3; i >= 0; --i) number = number << 8U | static_cast<unsigned char>(bytes[i]);
  return number;
}

// Louder than all and quieter than nothing are the ends of the range.
float within(float loud) { return static_cast<float>(std::clamp(finite(loud), 0.0, 1.0)); }

// [s] of a plain WAV file (RIFF header of 44 bytes: bytes per second at 28, of data at 40).
double lengthOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::array<char, 44> head{};
  if (!stream.read(head.data(), head.size())) return kUnknownLength;
  if (std::string(head.data(), 4) != "RIFF") return kUnknownLength;
  const std::uint32_t rate = littleEndian(&head[28]);
  return rate == 0 ? kUnknownLength : static_cast<double>(littleEndian(&head[40])) / rate;
}

class AlAudioPlayer : public std::enable_shared_from_this<AlAudioPlayer> {
 public:
  explicit AlAudioPlayer(ServiceContext context) : context_(std::move(context)) {}

  void declare(rpc::Service& service) {
    declareFiles(service);
    declareLoaded(service);
    declarePlaces(service);
    declareSound(service);
  }

 private:
  struct File {
    std::string name;
    double length = 0;    // [s]
    double position = 0;  // [s] where it stands, or began to play
    float volume = 1;
    bool playing = false;
    bool loops = false;
    Duration began{};  // NaoQi's clock
    int run = 0;       // counts starts and jumps, so that old ends are known
    rpc::Pending<void> done;
  };

  File& at(std::int32_t id) {
    const auto found = files_.find(id);
    if (found == files_.end()) throw CallError("no sound has the number " + std::to_string(id));
    return found->second;
  }

  std::int32_t load(const std::string& name) {
    if (files_.size() >= kMostFiles) forgetOne();
    const auto file = findDataFile(context_.data_dir, name);
    File loaded;
    loaded.name = name;
    loaded.length = file ? lengthOf(*file) : kUnknownLength;
    files_.emplace(++last_id_, std::move(loaded));
    return last_id_;
  }

  // What does not play and is known for longest.
  void forgetOne() {
    const auto old = std::find_if(files_.begin(), files_.end(),
                                  [](const auto& entry) { return !entry.second.playing; });
    if (old == files_.end()) throw CallError("too many sounds play");
    files_.erase(old);
  }

  double positionOf(const File& file) const {
    if (!file.playing) return file.position;
    const double now = file.position + toSeconds(context_.store().now() - file.began);
    return file.loops ? std::fmod(now, file.length) : std::min(now, file.length);
  }

  rpc::Pending<void> play(std::int32_t id, double from, bool loops) {
    File& file = at(id);
    stop(file);
    context_.log("plays: " + file.name);
    file.done = {};
    file.done.onCancel([weak = weak_from_this(), id] {
      const auto self = weak.lock();
      if (self && self->files_.count(id) > 0) self->pause(id);
    });
    file.loops = loops;
    go(id, file, std::clamp(from, 0.0, file.length));
    return file.done;
  }

  void go(std::int32_t id, File& file, double from) {
    file.playing = true;
    file.position = from;
    file.began = context_.store().now();
    const int run = ++file.run;
    if (file.loops) return;
    context_.later(fromSeconds(file.length - from), [weak = weak_from_this(), id, run] {
      const auto self = weak.lock();
      if (!self) return;
      const auto found = self->files_.find(id);
      if (found == self->files_.end() || found->second.run != run) return;
      self->stop(found->second);
      found->second.position = 0;
    });
  }

  // Ends what plays, wherever it is.
  void stop(File& file) const {
    if (!file.playing) return;
    file.position = positionOf(file);
    file.playing = false;
    ++file.run;
    file.done.resolve();
  }

  void pause(std::int32_t id) { stop(at(id)); }

  void goTo(std::int32_t id, float position) {
    File& file = at(id);
    const double place = std::clamp(finite(position), 0.0, file.length);
    if (file.playing) {
      go(id, file, place);
    } else {
      file.position = place;
    }
  }

  void stopAll() {
    for (auto& [id, file] : files_) stop(file);
  }

  rpc::Pending<void> playNamed(const std::string& name, double from, bool loops) {
    const double place = finite(from);
    return play(load(name), place, loops);
  }

  void declareFiles(rpc::Service& service) {
    const Argument name{"fileName", "Its path."};
    const Argument volume{"volume", "0 to 1; no sound is heard."};
    const Argument pan{"pan", "-1 left to 1 right; no sound is heard."};
    const Argument from{"position", "[s] where to begin."};
    addFunction(
        service, "playFile", [this](const std::string& file) { return playNamed(file, 0, false); },
        "Plays a sound to its end.", name);
    addFunction(
        service, "playFile",
        [this](const std::string& file, float, float) { return playNamed(file, 0, false); },
        "Plays a sound to its end.", name, volume, pan);
    addFunction(
        service, "playFileFromPosition",
        [this](const std::string& file, float start) { return playNamed(file, start, false); },
        "Plays the rest of a sound.", name, from);
    addFunction(
        service, "playFileFromPosition",
        [this](const std::string& file, float start, float, float) {
          return playNamed(file, start, false);
        },
        "Plays the rest of a sound.", name, from, volume, pan);
    addFunction(
        service, "playFileInLoop",
        [this](const std::string& file) { return playNamed(file, 0, true); },
        "Plays a sound again and again until it is stopped.", name);
    addFunction(
        service, "playFileInLoop",
        [this](const std::string& file, float, float) { return playNamed(file, 0, true); },
        "Plays a sound again and again until it is stopped.", name, volume, pan);
    addFunction(
        service, "playWebStream",
        [this](const std::string& address, float, float) { context_.log("plays: " + address); },
        "Is logged; nothing is fetched.", Argument{"streamName", "Its address."}, volume, pan);
  }

  void declareLoaded(rpc::Service& service) {
    const Argument id{"id", "What loadFile() returned."};
    const Argument volume{"volume", "0 to 1; no sound is heard."};
    const Argument pan{"pan", "-1 left to 1 right; no sound is heard."};
    addFunction(
        service, "loadFile", [this](const std::string& name) { return load(name); },
        "Prepares a sound and returns its number.", Argument{"fileName", "Its path."});
    addFunction(
        service, "unloadFile",
        [this](std::int32_t number) {
          stop(at(number));
          files_.erase(number);
        },
        "Forgets a sound.", id);
    addFunction(
        service, "unloadAllFiles",
        [this] {
          stopAll();
          files_.clear();
        },
        "Forgets all sounds.");
    addFunction(
        service, "play",
        [this](std::int32_t number) { return play(number, at(number).position, false); },
        "Plays a sound to its end.", id);
    addFunction(
        service, "play",
        [this](std::int32_t number, float, float) {
          return play(number, at(number).position, false);
        },
        "Plays a sound to its end.", id, volume, pan);
    addFunction(
        service, "playInLoop", [this](std::int32_t number) { return play(number, 0, true); },
        "Plays a sound again and again until it is stopped.", id);
    addFunction(
        service, "playInLoop",
        [this](std::int32_t number, float, float) { return play(number, 0, true); },
        "Plays a sound again and again until it is stopped.", id, volume, pan);
    addFunction(
        service, "getLoadedFilesIds",
        [this] {
          std::vector<std::string> ids;
          for (const auto& [number, file] : files_) ids.push_back(std::to_string(number));
          return ids;
        },
        "The numbers of the sounds that are loaded, as texts.");
    addFunction(
        service, "getLoadedFilesNames",
        [this] {
          std::vector<std::string> names;
          for (const auto& [number, file] : files_) names.push_back(file.name);
          return names;
        },
        "The paths of the sounds that are loaded.");
  }

  void declarePlaces(rpc::Service& service) {
    const Argument id{"id", "What loadFile() returned."};
    addFunction(
        service, "pause", [this](std::int32_t number) { pause(number); },
        "Stops a sound where it is.", id);
    addFunction(
        service, "stopAll", [this] { stopAll(); }, "Stops all sounds.");
    addFunction(
        service, "goTo", [this](std::int32_t number, float position) { goTo(number, position); },
        "Goes on at another place of a sound.", id, Argument{"position", "[s]"});
    addFunction(
        service, "getCurrentPosition",
        [this](std::int32_t number) { return static_cast<float>(positionOf(at(number))); },
        "Where a sound is [s].", id);
    addFunction(
        service, "getFileLength",
        [this](std::int32_t number) { return static_cast<float>(at(number).length); },
        "How long a sound is [s].", id);
  }

  void declareSound(rpc::Service& service) {
    const Argument volume{"volume", "0 to 1; no sound is heard."};
    addFunction(
        service, "setVolume",
        [this](std::int32_t number, float loud) { at(number).volume = within(loud); }, "Is kept.",
        Argument{"id", "What loadFile() returned."}, volume);
    addFunction(
        service, "getVolume", [this](std::int32_t number) { return at(number).volume; },
        "What was kept; 1 at first.", Argument{"id", "What loadFile() returned."});
    addFunction(
        service, "setMasterVolume", [this](float loud) { master_ = within(loud); }, "Is kept.",
        volume);
    addFunction(
        service, "getMasterVolume", [this] { return master_; }, "What was kept; 1 at first.");
    addFunction(
        service, "setPanorama", [](float) {}, "Has no effect.",
        Argument{"pan", "-1 left to 1 right; no sound is heard."});
    addFunction(
        service, "playSine",
        [this](std::int32_t frequency, std::int32_t, std::int32_t, float duration) {
          context_.log("plays: a sine of " + std::to_string(frequency) + " Hz for " +
                       std::to_string(duration) + " s");
        },
        "Is logged; the call does not wait for its end.", Argument{"frequence", "[Hz]"},
        Argument{"gain", "0 to 100."}, Argument{"pan", "-1, 0 or 1."}, Argument{"duration", "[s]"});
  }

  ServiceContext context_;
  std::map<std::int32_t, File> files_;
  std::int32_t last_id_ = 0;
  float master_ = 1;
};

}  // namespace

std::shared_ptr<rpc::Service> makeAlAudioPlayer(const ServiceContext& context) {
  auto service = std::make_shared<rpc::Service>(
      rpc::alModule("ALAudioPlayer", "Sounds that take their time and are not heard."));
  const auto player = std::make_shared<AlAudioPlayer>(context);
  player->declare(*service);
  service->owning(player);
  service->allAnswering(rpc::Answer::Simplified);
  return service;
}

}  // namespace nao::services

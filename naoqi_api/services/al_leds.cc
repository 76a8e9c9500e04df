#include "naoqi_api/services/al_leds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/random.h"
#include "naoqi_api/al_module.h"
#include "naoqi_api/services/finite.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::CallError;
using rpc::Pending;
using rpc::Value;
using Lights = std::vector<std::size_t>;
/// One part of a show after the other, each a function that begins it.
using Steps = std::vector<std::function<Pending<void>()>>;

Rgb colorOf(std::int32_t rgb) {
  const auto part = [rgb](unsigned shift) {
    return static_cast<float>(static_cast<unsigned>(rgb) >> shift & 0xFFU) / 255.0F;
  };
  return {part(16), part(8), part(0)};
}

Rgb colorNamed(const std::string& name) {
  static const std::map<std::string, Rgb> colors = {
      {"white", {1, 1, 1}},  {"red", {1, 0, 0}},     {"green", {0, 1, 0}}, {"blue", {0, 0, 1}},
      {"yellow", {1, 1, 0}}, {"magenta", {1, 0, 1}}, {"cyan", {0, 1, 1}},  {"black", {0, 0, 0}}};
  const auto found = colors.find(name);
  if (found == colors.end()) throw CallError("unknown colour: " + name);
  return found->second;
}

// As many steps as a show of `seconds` has, each `step` long; the longest show has an end.
int countSteps(double seconds, double step) {
  return static_cast<int>(std::clamp(finite(seconds) / step + 0.5, 0.0, 10'000.0));
}

class AlLeds : public std::enable_shared_from_this<AlLeds> {
 public:
  explicit AlLeds(std::shared_ptr<LedBoard> board) : board_(std::move(board)) {}

  void declare(rpc::Service& service) {
    declareBrightness(service);
    declareColors(service);
    declareNames(service);
    declareShows(service);
  }

 private:
  // Runs steps one after the other; canceled between two of them.
  Pending<void> run(Steps steps) {
    Pending<void> done;
    const auto canceled = std::make_shared<bool>(false);
    done.onCancel([canceled] { *canceled = true; });
    next(std::make_shared<Steps>(std::move(steps)), 0, canceled, done);
    return done;
  }
  void next(const std::shared_ptr<Steps>& steps, std::size_t at,
            const std::shared_ptr<bool>& canceled, const Pending<void>& done) {
    if (*canceled || at == steps->size()) return done.resolve();
    (*steps)[at]().whenDone([weak = weak_from_this(), steps, at, canceled, done](const auto&) {
      const auto self = weak.lock();
      if (self) self->next(steps, at + 1, canceled, done);
    });
  }

  Pending<void> fade(const std::string& name, float brightness, double duration) {
    return board_->fade(board_->lightsOf(name), brightness, duration);
  }
  Pending<void> fadeRgb(const std::string& name, const Rgb& color, double duration) {
    return board_->fade(board_->lightsOf(name), color, duration);
  }

  Pending<void> fadeList(const std::string& name, const Value& colors, const Value& times) {
    const auto wanted = colors.to<std::vector<std::int32_t>>();
    const auto moments = times.to<std::vector<float>>();
    if (wanted.size() != moments.size()) throw CallError("expected as many times as colours");
    Steps steps;
    float before = 0;
    const Lights lights = board_->lightsOf(name);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const double duration = std::max(0.0F, moments[i] - before);
      before = moments[i];
      steps.push_back([board = board_, lights, color = colorOf(wanted[i]), duration] {
        return board->fade(lights, color, duration);
      });
    }
    return run(std::move(steps));
  }

  Value getIntensity(const std::string& name) {
    const Lights lights = board_->lightsOf(name);
    if (lights.size() == 1) return board_->brightness(lights.front());
    std::vector<Value> list;
    for (const std::size_t light : lights) list.emplace_back(board_->brightness(light));
    return Value::list(std::move(list));
  }

  // A light that goes round the eyes.
  Pending<void> rotateEyes(std::int32_t rgb, float turn, float total) {
    if (!(turn > 0)) throw CallError("expected a turn of more than 0 s");
    const double eighth = turn / 8.0;
    const int count = countSteps(total, eighth);
    Steps steps;
    for (int i = 0; i < count; ++i) {
      steps.push_back([this, rgb, i, eighth] {
        fadeRgb("FaceLeds", {0, 0, 0}, 0);
        fadeRgb("FaceLed" + std::to_string(i % 8), colorOf(rgb), 0);
        return board_->pass(eighth);
      });
    }
    return run(std::move(steps));
  }

  Pending<void> show(float duration, double step, const std::function<void(int)>& change) {
    const int count = countSteps(duration, step);
    Steps steps;
    for (int i = 0; i < count; ++i) {
      steps.push_back([board = board_, step, change, i] {
        change(i);
        return board->pass(step);
      });
    }
    return run(std::move(steps));
  }

  void randomFace() {
    for (int sector = 0; sector < 8; ++sector) {
      const auto part = [this] { return static_cast<float>(random_.uniform(0, 1)); };
      const Rgb color = {part(), part(), part()};
      fadeRgb("FaceLed" + std::to_string(sector), color, 0.2);
    }
  }

  // Lit up to an angle, counted as the ears' lights are named.
  Pending<void> earLeds(std::int32_t degrees, float duration, bool leave_on) {
    Lights lit;
    for (const std::size_t light : board_->lightsOf("EarLeds")) {
      const std::string& name = board_->names()[light];
      if (std::stoi(name.substr(name.rfind('/') + 1)) < std::abs(degrees)) lit.push_back(light);
    }
    Steps steps = {[board = board_, lit, duration] { return board->fade(lit, 1.0F, duration); }};
    if (!leave_on) steps.push_back([board = board_, lit] { return board->fade(lit, 0.0F, 0); });
    return run(std::move(steps));
  }

  void declareBrightness(rpc::Service& service) {
    const Argument name{"name", "A light or a group."};
    addFunction(
        service, "on", [this](const std::string& lights) { fade(lights, 1, 0); }, "Full bright.",
        name);
    addFunction(
        service, "off", [this](const std::string& lights) { fade(lights, 0, 0); }, "Dark.", name);
    addFunction(
        service, "setIntensity",
        [this](const std::string& lights, float brightness) { fade(lights, brightness, 0); },
        "Sets a brightness at once.", name, Argument{"intensity", "0 to 1."});
    addFunction(
        service, "getIntensity", [this](const std::string& lights) { return getIntensity(lights); },
        "The brightness of a light, or the list of a group's: 0 to 1.", name);
    addFunction(
        service, "fade",
        [this](const std::string& lights, float brightness, float duration) {
          return fade(lights, brightness, duration);
        },
        "Changes the brightness evenly and ends when it is done.", name,
        Argument{"intensity", "0 to 1."}, Argument{"duration", "[s]"});
    addFunction(
        service, "reset",
        [this](const std::string& lights) {
          fadeRgb(lights, {1, 1, 1}, 0);
        },
        "White and full bright, as after a start.", name);
  }

  void declareColors(rpc::Service& service) {
    const Argument name{"name", "A light or a group."};
    const Argument duration{"duration", "[s]"};
    addFunction(
        service, "fadeRGB",
        [this](const std::string& lights, float red, float green, float blue, float seconds) {
          return fadeRgb(lights, {red, green, blue}, seconds);
        },
        "Changes the colour evenly and ends when it is done.", name, Argument{"red", "0 to 1."},
        Argument{"green", "0 to 1."}, Argument{"blue", "0 to 1."}, duration);
    addFunction(
        service, "fadeRGB",
        [this](const std::string& lights, std::int32_t rgb, float seconds) {
          return fadeRgb(lights, colorOf(rgb), seconds);
        },
        "Changes the colour evenly and ends when it is done.", name, Argument{"rgb", "0x00RRGGBB."},
        duration);
    addFunction(
        service, "fadeRGB",
        [this](const std::string& lights, const std::string& color, float seconds) {
          return fadeRgb(lights, colorNamed(color), seconds);
        },
        "Changes the colour evenly and ends when it is done.", name,
        Argument{"colorName", "white, red, green, blue, yellow, magenta, cyan or black."},
        duration);
    addFunction(
        service, "fadeListRGB",
        [this](const std::string& lights, const Value& colors, const Value& times) {
          return fadeList(lights, colors, times);
        },
        "Fades from colour to colour and ends at the last.", name,
        Argument{"rgbList", "[0x00RRGGBB, ...]"}, Argument{"timeList", "[s] after the start."});
  }

  void declareNames(rpc::Service& service) {
    addFunction(
        service, "listGroups", [this] { return board_->groups(); }, "The names of the groups.");
    const auto device_names = [this](const std::string& name) {
      std::vector<std::string> names;
      for (const std::size_t light : board_->lightsOf(name)) {
        names.push_back(board_->names()[light] + "/Actuator/Value");
      }
      return names;
    };
    addFunction(service, "listGroup", device_names, "The lights of a group.",
                Argument{"groupName", "Its name."});
    addFunction(service, "listLED", device_names, "The lights of a name.",
                Argument{"name", "A light or a group."});
    addFunction(
        service, "listLEDs", [this] { return board_->names(); }, "The names of all lights.");
    addFunction(
        service, "createGroup",
        [this](const std::string& name, const std::vector<std::string>& lights) {
          board_->makeGroup(name, lights);
        },
        "Makes a group.", Argument{"groupName", "Its name."},
        Argument{"ledNames", "Lights and groups."});
  }

  void declareShows(rpc::Service& service) {
    const Argument duration{"duration", "[s]"};
    addFunction(
        service, "rotateEyes",
        [this](std::int32_t rgb, float turn, float total) { return rotateEyes(rgb, turn, total); },
        "A light goes round the eyes.", Argument{"rgb", "0x00RRGGBB."},
        Argument{"timeForRotation", "[s]"}, Argument{"totalDuration", "[s]"});
    addFunction(
        service, "randomEyes",
        [this](float seconds) { return show(seconds, 0.2, [this](int) { randomFace(); }); },
        "Random colours in the eyes.", duration);
    addFunction(
        service, "rasta",
        [this](float seconds) {
          return show(seconds, 0.5, [this](int i) {
            static const std::array<const char*, 3> colors = {"green", "yellow", "red"};
            fadeRgb("AllLeds", colorNamed(colors.at(static_cast<std::size_t>(i) % 3)), 0);
          });
        },
        "Green, yellow and red everywhere.", duration);
    addFunction(
        service, "earLedsSetAngle",
        [this](std::int32_t degrees, float seconds, bool leave_on) {
          return earLeds(degrees, seconds, leave_on);
        },
        "Lights the ears up to an angle.", Argument{"degrees", "0 to 360."}, duration,
        Argument{"leaveOnAtEnd", "Whether they stay lit."});
  }

  std::shared_ptr<LedBoard> board_;
  Random random_{1};  // of randomEyes(): the same in every run
};

}  // namespace

std::shared_ptr<rpc::Service> makeAlLeds(const ServiceContext& /*context*/,
                                         const std::shared_ptr<LedBoard>& board) {
  auto service = std::make_shared<rpc::Service>(
      rpc::alModule("ALLeds", "The lights in eyes, ears, chest, feet and head."));
  const auto leds = std::make_shared<AlLeds>(board);
  leds->declare(*service);
  service->owning(leds);
  return service;
}

}  // namespace nao::services

#include "naoqi_api/services/led_board.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "naoqi_api/call_error.h"
#include "naoqi_api/services/led_names.h"

namespace nao::services {
namespace {

constexpr std::chrono::milliseconds kTick{20};  // free: finer than an eye sees
constexpr std::size_t kMostFades = 1024;
constexpr std::size_t kMostGroups = 256;

bool contains(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

// The part of a colour that a light of this name shows.
float partOf(const Rgb& color, const std::string& light) {
  if (contains(light, "/Red")) return color[0];
  if (contains(light, "/Green")) return color[1];
  if (contains(light, "/Blue") || contains(light, "Ears/")) return color[2];
  return *std::max_element(color.begin(), color.end());
}

}  // namespace

LedBoard::LedBoard(RobotLink& link, rpc::CallLater later)
    : link_(link),
      later_(std::move(later)),
      names_(ledNames(link.model())),
      asked_(names_.size()),
      owner_(names_.size()) {}

std::vector<std::size_t> LedBoard::lightsOf(const std::string& name) const {
  const auto made = made_.find(name);
  if (made != made_.end()) return made->second;
  auto lights = findLedsNamed(names_, name);
  if (lights.empty()) throw rpc::CallError("unknown light or group: " + name);
  return lights;
}

std::vector<std::string> LedBoard::groups() const {
  std::vector<std::string> names;
  for (const std::string& name : ledGroupNames()) {
    if (!findLedsNamed(names_, name).empty()) names.push_back(name);
  }
  for (const auto& [name, lights] : made_) names.push_back(name);
  return names;
}

void LedBoard::makeGroup(const std::string& name, const std::vector<std::string>& lights) {
  if (made_.size() >= kMostGroups) throw rpc::CallError("too many groups");
  std::vector<std::size_t> all;
  for (const std::string& light : lights) {
    for (const std::size_t number : lightsOf(light)) {
      if (std::find(all.begin(), all.end(), number) == all.end()) all.push_back(number);
    }
  }
  made_[name] = std::move(all);
}

float LedBoard::brightness(std::size_t light) const { return link_.sensors()->leds.at(light); }

rpc::Pending<void> LedBoard::fade(const std::vector<std::size_t>& lights, float to,
                                  double duration) {
  std::vector<Target> targets;
  for (const std::size_t light : lights) targets.push_back({light, asked_[light], to});
  return begin(std::move(targets), duration);
}

rpc::Pending<void> LedBoard::fade(const std::vector<std::size_t>& lights, const Rgb& to,
                                  double duration) {
  std::vector<Target> targets;
  for (const std::size_t light : lights) {
    targets.push_back({light, asked_[light], partOf(to, names_[light])});
  }
  return begin(std::move(targets), duration);
}

rpc::Pending<void> LedBoard::begin(std::vector<Target> targets, double duration) {
  if (!std::isfinite(duration) || duration < 0) throw rpc::CallError("a duration of 0 s or more");
  if (fades_.size() >= kMostFades) throw rpc::CallError("too many fades under way");
  Fade fade;
  fade.id = ++last_fade_;
  fade.begin = link_.now();
  fade.duration = duration;
  for (Target& target : targets) {
    if (!std::isfinite(target.to)) throw rpc::CallError("expected a brightness of 0 to 1");
    target.to = std::clamp(target.to, 0.0F, 1.0F);
    owner_[target.light] = fade.id;
  }
  fade.targets = std::move(targets);
  if (duration == 0) {
    show(fade, 1);
    fade.done.resolve();
    return fade.done;
  }
  fades_.push_back(fade);
  if (!ticking_) tick();
  return fade.done;
}

void LedBoard::light(std::size_t light, float brightness) {
  if (asked_[light] == brightness) return;
  if (link_.light({names_[light], brightness})) asked_[light] = brightness;
}

void LedBoard::show(const Fade& fade, double part) {
  for (const Target& target : fade.targets) {
    if (owner_[target.light] != fade.id) continue;  // another has it now
    light(target.light, target.from + static_cast<float>(part) * (target.to - target.from));
  }
}

void LedBoard::tick() {
  std::vector<rpc::Pending<void>> ended;
  const SimTime now = link_.now();
  for (Fade& fade : fades_) {
    const double part = toSeconds(now - fade.begin) / fade.duration;
    show(fade, std::clamp(part, 0.0, 1.0));
    if (part >= 1 || fade.done.isDone()) ended.push_back(fade.done);
  }
  const auto over = [&](const Fade& fade) {
    return fade.done.isDone() || toSeconds(now - fade.begin) >= fade.duration;
  };
  fades_.erase(std::remove_if(fades_.begin(), fades_.end(), over), fades_.end());
  ticking_ = !fades_.empty();
  if (ticking_) {
    later_(kTick, [weak = weak_from_this()] {
      if (const auto self = weak.lock()) self->tick();
    });
  }
  for (const auto& done : ended) {
    later_(kTick, [done] { done.resolve(); });  // when its last colour is seen
  }
}

rpc::Pending<void> LedBoard::pass(double seconds) {
  rpc::Pending<void> done;
  constexpr double kForever = 1e9;  // [s] any later is beyond the clock's range
  later_(fromSeconds(std::clamp(seconds, 0.0, kForever)), [done] { done.resolve(); });
  return done;
}

}  // namespace nao::services

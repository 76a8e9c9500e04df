#include "motion/timeline/xar_curve.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

#include "motion/trajectory.h"

namespace nao::motion {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kSlowestFps = 0.01;

// What one unit of a value is inside: a radian part of a degree, or a hand's opening. A .xar
// numbers its units (-1 and 0 degrees, 1 dimensionless), a .qianim names them.
constexpr const char* kUnits[] = {"", "-1", "0", "1", "degree", "radian", "dimensionless"};

double unitOf(const XarElement& curve, bool is_hand, const std::vector<XarElement>& keys) {
  const std::string unit = curve.text("unit");
  if (std::find(std::begin(kUnits), std::end(kUnits), unit) == std::end(kUnits)) {
    curve.fail("unknown unit \"" + unit.substr(0, 40) +
               "\", expected degree, radian or dimensionless (0 or 1 in a .xar)");
  }
  if (unit == "radian" && !is_hand) return 1;
  const bool dimensionless = unit == "1" || unit == "dimensionless";
  if (!is_hand && !dimensionless) return kDegree;
  for (const XarElement& key : keys) {
    if (std::abs(std::strtod(key.text("value").c_str(), nullptr)) > 1) return 0.01;
  }
  return 1;
}

Handle readTangent(const XarElement& tangent, const XarClock& clock, double unit) {
  const std::string type =
      tangent.text("interpType", tangent.text("editor:interpType", "bezier_auto"));
  Handle handle;
  handle.dt = tangent.number("abscissaParam", 0) / clock.fps;
  handle.dangle = tangent.number("ordinateParam", 0) * unit;
  if (type == "bezier") {
    handle.kind = Handle::Kind::Bezier;
  } else if (type == "linear") {
    handle.kind = Handle::Kind::Linear;
  } else if (type == "constant") {
    handle.kind = Handle::Kind::Constant;
  } else if (type == "bezier_auto" || type == "bezier auto") {
    handle.kind = Handle::Kind::BezierAuto;
  } else {
    tangent.fail("unknown interpType \"" + type.substr(0, 40) +
                 "\", expected bezier_auto, bezier, linear or constant");
  }
  return handle;
}

// A key with the handles that are written down; the others are BezierAuto, to be filled in.
Key readKey(const XarElement& element, const XarClock& clock, double unit) {
  Key key;
  key.time = clock.timeOf(element.number("frame"));
  key.angle = element.number("value") * unit;
  key.before.kind = key.after.kind = Handle::Kind::BezierAuto;
  std::vector<XarElement> tangents = element.children("Tangent");
  if (const XarElement group = element.child("Tangents")) tangents = group.children("Tangent");
  for (const XarElement& tangent : tangents) {
    const std::string side = tangent.text("side");
    if (side != "left" && side != "right") tangent.fail("a Tangent's side is left or right");
    (side == "left" ? key.before : key.after) = readTangent(tangent, clock, unit);
  }
  return key;
}

void fillAutomaticHandles(std::vector<Key>& keys) {
  if (keys.empty()) return;
  std::vector<Key> automatic = keys;
  setAutoHandles(keys.front().angle, automatic);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i].before.kind == Handle::Kind::BezierAuto) keys[i].before = automatic[i].before;
    if (keys[i].after.kind == Handle::Kind::BezierAuto) keys[i].after = automatic[i].after;
  }
}

struct PlacedKey {
  Key key;
  XarElement element;
};

// Keys in order of time, one per frame, within the timeline; what is wrong with the others.
class KeyRow {
 public:
  KeyRow(const XarClock& clock, Joint joint, std::string name, std::vector<KeyFault>& faults)
      : clock_(clock), joint_(joint), name_(std::move(name)), faults_(faults) {}

  std::vector<Key> settle(std::vector<PlacedKey> keys) {
    const auto earlier = [](const PlacedKey& a, const PlacedKey& b) {
      return a.key.time < b.key.time;
    };
    if (!std::is_sorted(keys.begin(), keys.end(), earlier)) {
      tell(keys.front(), "the keys are not in order of their frames; they are played in order");
      std::stable_sort(keys.begin(), keys.end(), earlier);
    }
    for (const PlacedKey& key : keys) place(key);
    return std::move(kept_);
  }

 private:
  void place(PlacedKey placed) {
    Key& key = placed.key;
    if (clock_.end_frame && key.time > clock_.timeOf(*clock_.end_frame) + 1e-9) {
      return tell(placed, "this key is after the end of the timeline and is left out");
    }
    const double half_a_frame = 0.5 / clock_.fps;
    if (key.time < half_a_frame) {
      tell(placed, "this key is at time 0 or before; it is played half a frame later");
      key.time = half_a_frame;
    }
    if (!kept_.empty() && key.time - kept_.back().time < 1e-6) {
      tell(placed, "there are two keys on this frame; the last one is played");
      kept_.pop_back();
    }
    kept_.push_back(key);
  }

  void tell(const PlacedKey& key, const char* sentence) {
    faults_.push_back({joint_, key.key.time, key.element.place() + ": " + name_ + ": " + sentence});
  }

  const XarClock& clock_;
  Joint joint_;
  std::string name_;
  std::vector<KeyFault>& faults_;
  std::vector<Key> kept_;
};

}  // namespace

XarClock readXarClock(const XarElement& timeline) {
  XarClock clock;
  clock.fps = timeline.number("fps", 25);
  if (clock.fps < kSlowestFps) timeline.fail("fps must be positive");
  clock.start_frame = timeline.number("start_frame", 0);
  const double end = timeline.number("end_frame", -1);
  if (end >= 0) clock.end_frame = end;
  return clock;
}

double addXarCurve(const XarElement& curve, const XarClock& clock, Joint joint, bool is_hand,
                   double start, TimelineBuilder& builder) {
  std::vector<XarElement> elements = curve.children("Key");
  if (const XarElement group = curve.child("CurveKeys")) elements = group.children("Key");
  const double unit = unitOf(curve, is_hand, elements);
  std::vector<PlacedKey> placed;
  for (const XarElement& element : elements) {
    builder.attempt([&] { placed.push_back({readKey(element, clock, unit), element}); });
  }
  std::vector<KeyFault> faults;
  const std::string name = curve.text("actuator");
  if (elements.empty()) faults.push_back({joint, 0, curve.place() + ": " + name + " has no keys"});
  std::vector<Key> keys = KeyRow(clock, joint, name, faults).settle(std::move(placed));
  for (KeyFault& fault : faults) {
    fault.time += start;
    builder.addFault(std::move(fault));
  }
  if (keys.empty()) return start;
  fillAutomaticHandles(keys);
  const double end = start + keys.back().time;
  builder.add(start, {joint, std::move(keys)});
  builder.addClock({joint, start, clock.fps, clock.start_frame});
  return end;
}

}  // namespace nao::motion

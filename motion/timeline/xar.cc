#include "motion/timeline/xar.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/check.h"
#include "motion/timeline/xar_curve.h"
#include "motion/timeline/xar_element.h"

namespace nao::motion {
namespace {

constexpr int kDeepestNesting = 50;  // of boxes in boxes; the deepest found in the wild is 7

const char* const kStopInput = "3";  // `nature` of an input that ends a box
const char* const kDispatcher = "dispatcher_plugin";

struct Link {
  std::string from, from_output, to, to_input;  // ids; box "0" is the one around the diagram
};

// Walks through boxes and diagrams along their links and lays the timelines it meets one after
// the other.
class Player {
 public:
  // `whole`: the text was well-formed, so that boxes without links have none.
  Player(const RobotModel& model, TimelineBuilder& builder, bool whole)
      : model_(model), builder_(builder), whole_(whole) {}

  // Plays a box from `start` [s]; returns when it ends, or nothing if that can not be told.
  std::optional<double> playBox(const XarElement& box, double start, int depth);

  const std::string& undecided() const { return undecided_; }

 private:
  double playTimeline(const XarElement& timeline, double start, int depth);
  double playInOrder(const XarElement& diagram, double start, int depth);
  std::optional<double> playDiagram(const XarElement& diagram, double start, int depth);
  double playCurves(const XarElement& list, const XarClock& clock, double start);
  void warnOfScript(const XarElement& box);

  const RobotModel& model_;
  TimelineBuilder& builder_;
  bool whole_;
  std::string undecided_;  // the first box that chooses a branch
};

std::vector<Link> linksOf(const XarElement& diagram) {
  std::vector<Link> links;
  for (const XarElement& link : diagram.children("Link")) {
    links.push_back({link.text("outputowner"), link.text("indexofoutput"), link.text("inputowner"),
                     link.text("indexofinput")});
  }
  return links;
}

bool stops(const XarElement& box, const std::string& input_id) {
  for (const XarElement& input : box.children("Input")) {
    if (input.text("id") == input_id) return input.text("nature") == kStopInput;
  }
  return false;
}

std::optional<double> Player::playBox(const XarElement& box, double start, int depth) {
  if (depth > kDeepestNesting) box.fail("boxes are nested too deeply");
  if (box.text("plugin") == kDispatcher) {
    if (undecided_.empty()) undecided_ = box.text("name");
    builder_.warn(box.place() + ": the box \"" + box.text("name") +
                  "\" chooses what to play; nothing behind it is played");
    return std::nullopt;
  }
  warnOfScript(box);
  const XarElement timeline = box.child("Timeline");
  if (!timeline) return start;
  if (timeline.flag("enable", false)) return playTimeline(timeline, start, depth);

  // Without a timeline of its own a box is its first diagram.
  for (const XarElement& layer : timeline.children("BehaviorLayer")) {
    for (const XarElement& keyframe : layer.children("BehaviorKeyframe")) {
      if (const XarElement diagram = keyframe.child("Diagram")) {
        return playDiagram(diagram, start, depth);
      }
    }
  }
  return start;
}

double Player::playTimeline(const XarElement& timeline, double start, int depth) {
  XarClock clock;
  bool has_clock = false;
  builder_.attempt([&] {
    clock = readXarClock(timeline);
    has_clock = true;
  });
  if (!has_clock) return start;
  double end = start;
  if (clock.end_frame) end = std::max(end, start + clock.timeOf(*clock.end_frame));
  for (const XarElement& list : timeline.children("ActuatorList")) {
    end = std::max(end, playCurves(list, clock, start));
  }
  for (const XarElement& layer : timeline.children("BehaviorLayer")) {
    if (layer.flag("mute", false)) continue;
    for (const XarElement& keyframe : layer.children("BehaviorKeyframe")) {
      double at = start;
      builder_.attempt([&] { at += std::max(0.0, clock.timeOf(keyframe.number("index"))); });
      if (const XarElement diagram = keyframe.child("Diagram")) {
        end = std::max(end, playDiagram(diagram, at, depth).value_or(at));
      }
    }
  }
  builder_.lastUntil(end);
  return end;
}

double Player::playCurves(const XarElement& list, const XarClock& clock, double start) {
  double end = start;
  std::set<std::size_t> done;
  // The robot's own name goes first: LHipYawPitch wins over its other name RHipYawPitch.
  for (const bool aliases : {false, true}) {
    for (const XarElement& curve : list.children("ActuatorCurve")) {
      const std::string name = curve.text("actuator");
      if ((model_.aliases.count(name) != 0) != aliases || curve.flag("mute", false)) continue;
      const auto joint = model_.findJoint(name);
      if (!joint) {
        builder_.warn(curve.place() + ": this robot has no joint " + name);
        continue;
      }
      if (!done.insert(index(*joint)).second) continue;
      const bool is_hand = model_.actuators[index(*joint)].coordinates.empty();
      builder_.attempt([&] {
        end = std::max(end, addXarCurve(curve, clock, *joint, is_hand, start, builder_));
      });
    }
  }
  return end;
}

double Player::playInOrder(const XarElement& diagram, double start, int depth) {
  builder_.addBroken(diagram.place() +
                     ": the links between these boxes are lost; they are played in the order of "
                     "the text");
  double end = start;
  for (const XarElement& box : diagram.children("Box")) {
    end = playBox(box, end, depth + 1).value_or(end);
  }
  return end;
}

std::optional<double> Player::playDiagram(const XarElement& diagram, double start, int depth) {
  std::map<std::string, XarElement> boxes;
  for (const XarElement& box : diagram.children("Box")) boxes.emplace(box.text("id"), box);
  const std::vector<Link> links = linksOf(diagram);
  if (links.empty() && !whole_ && boxes.size() > 1) return playInOrder(diagram, start, depth);

  // Who starts when: first whoever is linked to the start, or everybody where nothing is linked.
  std::vector<std::pair<std::string, double>> due;
  const auto follow = [&](const std::string& from, double at) {
    for (const Link& link : links) {
      const auto box = boxes.find(link.to);
      if (link.from != from || (from == "0" && link.from_output == kStopInput)) continue;
      if (box != boxes.end() && !stops(box->second, link.to_input)) due.emplace_back(link.to, at);
    }
  };
  follow("0", start);
  if (links.empty()) {
    for (const auto& [id, box] : boxes) due.emplace_back(id, start);
  }

  double end = start;
  bool decided = true;
  std::set<std::string> played;  // once each, so that a loop ends
  while (!due.empty()) {
    const auto earliest = std::min_element(
        due.begin(), due.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    const auto [id, at] = *earliest;
    due.erase(earliest);
    if (!played.insert(id).second) continue;
    const auto ended = playBox(boxes.at(id), at, depth + 1);
    decided = decided && ended.has_value();
    if (!ended) continue;
    end = std::max(end, *ended);
    follow(id, *ended);
  }
  return decided ? std::optional(end) : std::nullopt;
}

bool hasOwnCode(const XarElement& box) {
  const XarElement script = box.child("script");
  return script && script.text("content").find_first_not_of(" \t\r\n") != std::string::npos;
}

void Player::warnOfScript(const XarElement& box) {
  if (!hasOwnCode(box)) return;
  builder_.warn(box.place() + ": the script of the box \"" + box.text("name") + "\" is not run");
}

// The root box of a document that has been parsed; `broken`: what was wrong with it.
XarElement rootBox(const tinyxml2::XMLDocument& document, const std::string& source,
                   const std::vector<std::string>& broken) {
  const tinyxml2::XMLElement* root = document.FirstChildElement("ChoregrapheProject");
  const bool is_whole = root != nullptr && root->FirstChildElement("Box") != nullptr;
  if (!is_whole && !broken.empty()) throw InputError(broken.front());
  if (root == nullptr) {
    throw InputError(source + ":1: expected a <ChoregrapheProject>, the root of a behavior");
  }
  const XarElement project(root, &source);
  const XarElement box = project.child("Box");
  if (!box) project.fail("expected a <Box> in the <ChoregrapheProject>");
  return box;
}

// All boxes in the diagrams of a box's timeline.
std::vector<XarElement> innerBoxes(const XarElement& timeline) {
  std::vector<XarElement> boxes;
  for (const XarElement& layer : timeline.children("BehaviorLayer")) {
    for (const XarElement& keyframe : layer.children("BehaviorKeyframe")) {
      for (const XarElement& box : keyframe.child("Diagram").children("Box")) boxes.push_back(box);
    }
  }
  return boxes;
}

bool hasCode(const XarElement& box, int depth) {
  if (depth > kDeepestNesting) box.fail("boxes are nested too deeply");
  if (hasOwnCode(box)) return true;
  const std::vector<XarElement> inner = innerBoxes(box.child("Timeline"));
  return std::any_of(inner.begin(), inner.end(),
                     [depth](const XarElement& b) { return hasCode(b, depth + 1); });
}

// `broken`: what was wrong with the whole text.
void collectTimelines(const XarElement& box, const RobotModel& model,
                      const std::vector<std::string>& broken, int depth,
                      std::vector<BoxTimeline>& found) {
  if (depth > kDeepestNesting) box.fail("boxes are nested too deeply");
  const XarElement timeline = box.child("Timeline");
  if (!timeline) return;
  if (timeline.flag("enable", false) && timeline.child("ActuatorList")) {
    TimelineBuilder builder;
    for (const std::string& sentence : broken) builder.addBroken(sentence);
    Player(model, builder, broken.empty()).playBox(box, 0, depth);
    if (!builder.isEmpty()) found.push_back({box.text("name"), builder.take()});
  }
  for (const XarElement& inner : innerBoxes(timeline)) {
    collectTimelines(inner, model, broken, depth + 1, found);
  }
}

}  // namespace

Timeline readXar(const std::string& text, const std::string& source, const RobotModel& model) {
  tinyxml2::XMLDocument document;
  TimelineBuilder builder;
  const std::vector<std::string> broken = parseXml(document, text, source);
  for (const std::string& sentence : broken) builder.addBroken(sentence);
  const XarElement box = rootBox(document, source, broken);

  Player player(model, builder, broken.empty());
  player.playBox(box, 0, 0);
  if (builder.isEmpty()) builder.failIfBroken();
  if (builder.isEmpty() && !player.undecided().empty()) {
    box.fail("nothing starts by itself: the box \"" + player.undecided() +
             "\" would have to choose what to play");
  }
  if (builder.isEmpty()) box.fail("no timeline here moves a joint of this robot");
  return builder.take();
}

bool hasCode(const std::string& text, const std::string& source) {
  tinyxml2::XMLDocument document;
  const std::vector<std::string> broken = parseXml(document, text, source);
  return hasCode(rootBox(document, source, broken), 0);
}

std::vector<BoxTimeline> readXarBoxes(const std::string& text, const std::string& source,
                                      const RobotModel& model) {
  tinyxml2::XMLDocument document;
  const std::vector<std::string> broken = parseXml(document, text, source);
  std::vector<BoxTimeline> found;
  collectTimelines(rootBox(document, source, broken), model, broken, 0, found);
  return found;
}

}  // namespace nao::motion

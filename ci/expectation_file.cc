#include <algorithm>

#include "ci/scenario_reader.h"
#include "ci/sentence.h"
#include "core/overloaded.h"

namespace nao::ci {
namespace {

using Presence = Config::Presence;
using Kind = When::Kind;

constexpr double kTurn = 6.2831853071795865;  // [rad]

const std::vector<std::string> kWhens = {"at", "by", "always", "never"};
const std::set<std::string> kViolations = {"joint_limit", "coupled_limit",  "velocity",
                                           "torque",      "self_collision", "heat"};

Comparison readComparison(Config& entry) {
  Comparison value;
  if (entry.has("equals")) value.equals = entry.text("equals");
  if (entry.has("contains")) value.contains = entry.text("contains");
  if (entry.has("min")) value.min = entry.number("min");
  if (entry.has("max")) value.max = entry.number("max");
  value.tolerance = entry.number("tolerance", kNotNegative, 0);
  return value;
}

// What holds for a moment only can not hold always.
bool isMomentary(const Condition& condition) {
  return std::holds_alternative<EventRaised>(condition) ||
         std::holds_alternative<TextSaid>(condition) ||
         std::holds_alternative<ClientEnded>(condition);
}

bool usuallyAlways(const Condition& condition) {
  return std::holds_alternative<Upright>(condition) ||
         std::holds_alternative<NoViolation>(condition);
}

}  // namespace

std::size_t ScenarioReader::client(Config& entry) {
  if (scenario_.clients.empty()) entry.fail("this scenario has no clients");
  const std::string name = entry.text("client", scenario_.clients.front().name);
  for (std::size_t i = 0; i < scenario_.clients.size(); ++i) {
    if (scenario_.clients[i].name == name) return i;
  }
  entry.reject("client", "the name of one of `clients`");
}

std::size_t ScenarioReader::camera(Config& entry, std::size_t robot) {
  const auto& cameras = scenario_.models[robot]->cameras;
  const std::string name = entry.text("camera", "top");
  const std::size_t camera = name == "bottom" ? 1 : 0;
  if ((name != "top" && name != "bottom") || camera >= cameras.size()) {
    entry.reject("camera", "top or bottom, that this robot has");
  }
  return camera;
}

Condition ScenarioReader::readUpright(Config& upright) { return Upright{robot(upright)}; }
Condition ScenarioReader::readFallen(Config& fallen) { return Fallen{robot(fallen)}; }

Condition ScenarioReader::readPlace(Config& entry) {
  InPlace place;
  place.is_ball = entry.has("ball");
  if (place.is_ball && entry.has("robot")) entry.fail("expected `robot` or `ball`, not both");
  place.which = place.is_ball ? ball(entry) : robot(entry);
  const auto center = entry.numbers("center", 2);
  place.center = {center[0], center[1]};
  place.radius = entry.number("radius", kPositive);
  if (entry.has("heading") && !place.is_ball) {
    place.heading = entry.number("heading", {-kTurn, kTurn});
    place.heading_tolerance = entry.number("heading_tolerance", kPositive);
  }
  return place;
}

Condition ScenarioReader::readMemory(Config& memory) {
  MemoryIs is{robot(memory), memory.text("key"), readComparison(memory)};
  if (is.value.described().empty()) memory.fail("expected equals, contains, min or max");
  return is;
}

Condition ScenarioReader::readEvent(Config& event) {
  return EventRaised{robot(event), event.text("key"), readComparison(event)};
}

Condition ScenarioReader::readSaid(Config& said) {
  return TextSaid{robot(said), said.text("text")};
}

Condition ScenarioReader::readExit(Config& exit) {
  return ClientEnded{client(exit), exit.integer("code", 0, 255, 0)};
}

Condition ScenarioReader::readImage(Config& image) {
  const std::size_t who = robot(image);
  return SeesBall{who, camera(image, who), ball(image), image.integer("pixels", 1, 19200, 10)};
}

Condition ScenarioReader::readJoint(Config& entry) {
  const std::size_t who = robot(entry);
  return JointIs{who, joint(entry, who), entry.number("angle"),
                 entry.number("tolerance", kPositive)};
}

Condition ScenarioReader::readLimits(Config& limits) {
  NoViolation none{robot(limits), {}};
  if (!limits.has("allow")) return none;
  for (const std::string& kind : limits.texts("allow")) {
    if (!kViolations.count(kind)) {
      limits.reject("allow",
                    "some of coupled_limit, heat, joint_limit, self_collision, torque, velocity");
    }
    none.allowed.insert(kind);
  }
  return none;
}

When ScenarioReader::readWhen(Config& entry, const Condition& condition) {
  When when{usuallyAlways(condition) ? Kind::Always : Kind::By, {}, scenario_.duration};
  std::string found;
  for (const std::string& key : kWhens) {
    if (!entry.has(key)) continue;
    if (!found.empty()) entry.fail("`" + key + "`: there is `" + found + "` already");
    found = key;
  }
  if (found.empty()) {
    if (isMomentary(condition) || usuallyAlways(condition)) return when;
    entry.fail("expected when: at, by, always or never");
  }
  if (isMomentary(condition) && (found == "at" || found == "always")) {
    entry.fail("`" + found + "`: this happens in a moment, expected by or never");
  }
  when.kind = found == "at"       ? Kind::At
              : found == "by"     ? Kind::By
              : found == "always" ? Kind::Always
                                  : Kind::Never;
  if (!entry.isList(found)) {
    when.to = moment(entry, found);
    return when;
  }
  const auto window = entry.numbers(found, 2, {0, toSeconds(scenario_.duration)});
  if (found == "at" || window[0] > window[1]) entry.reject(found, "a time, or [from, to]");
  when.from = fromSeconds(window[0]);
  when.to = fromSeconds(window[1]);
  return when;
}

std::string ScenarioReader::described(const Condition& condition) const {
  const auto whose = [this](std::size_t robot) { return nameOf(robot) + ": "; };
  return std::visit(
      Overloaded{
          [&](const Upright& c) { return nameOf(c.robot) + " upright"; },
          [&](const Fallen& c) { return nameOf(c.robot) + " fallen"; },
          [&](const InPlace& c) {
            std::string text = c.is_ball ? scenario_.world->balls[c.which].name : nameOf(c.which);
            text += " within " + shown(c.radius) + " m of (" + shown(c.center.x()) + ", " +
                    shown(c.center.y()) + ")";
            if (!c.heading) return text;
            return text + ", heading " + shownDegrees(*c.heading) + " within " +
                   shownDegrees(c.heading_tolerance);
          },
          [&](const MemoryIs& c) { return whose(c.robot) + c.key + " " + c.value.described(); },
          [&](const EventRaised& c) {
            const std::string value = c.value.described();
            return whose(c.robot) + "event " + c.key + (value.empty() ? "" : " " + value);
          },
          [&](const TextSaid& c) { return nameOf(c.robot) + " says '" + c.text + "'"; },
          [&](const ClientEnded& c) {
            return scenario_.clients[c.client].name + " ends with exit code " +
                   std::to_string(c.code);
          },
          [&](const SeesBall& c) {
            return nameOf(c.robot) + " has " + scenario_.world->balls[c.ball].name + " in its " +
                   (c.camera == 0 ? "top" : "bottom") + " camera's picture, " +
                   std::to_string(c.pixels) + " pixels";
          },
          [&](const JointIs& c) {
            const auto& actuator = scenario_.models[c.robot]->actuators[index(c.joint)];
            return whose(c.robot) + actuator.name + " at " + shown(c.angle) + " rad within " +
                   shown(c.tolerance);
          },
          [&](const NoViolation& c) { return nameOf(c.robot) + " within its limits"; }},
      condition);
}

void ScenarioReader::readExpectations(Config& file) {
  struct Topic {
    const char* name;
    Condition (ScenarioReader::*read)(Config&);
  };
  static constexpr Topic kTopics[] = {
      {"upright", &ScenarioReader::readUpright}, {"fallen", &ScenarioReader::readFallen},
      {"place", &ScenarioReader::readPlace},     {"memory", &ScenarioReader::readMemory},
      {"event", &ScenarioReader::readEvent},     {"said", &ScenarioReader::readSaid},
      {"exit", &ScenarioReader::readExit},       {"image", &ScenarioReader::readImage},
      {"joint", &ScenarioReader::readJoint},     {"limits", &ScenarioReader::readLimits}};
  std::vector<std::string> known;
  for (const Topic& topic : kTopics) known.emplace_back(topic.name);
  file.list("expect", Presence::Optional, [&](Config& entry) {
    const std::string about = kindOf(entry, kWhens, known);
    const auto topic = std::find(known.begin(), known.end(), about) - known.begin();
    Expectation expectation;
    entry.map(about, Presence::Required, [&](Config& details) {
      expectation.condition = (this->*kTopics[topic].read)(details);
    });
    expectation.when = readWhen(entry, expectation.condition);
    expectation.text = described(expectation.condition) + " " + expectation.when.described();
    expectation.line = entry.line();
    scenario_.expectations.push_back(std::move(expectation));
  });
}

}  // namespace nao::ci

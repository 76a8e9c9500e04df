#include "validation/diagnosis/whole/handed_on.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/config.h"
#include "validation/diagnosis/report/report_file.h"

namespace nao::validation {
namespace {

using Json = nlohmann::json;

int heightOf(const std::string& level) { return level == "joint" ? 0 : level == "limb" ? 1 : 2; }

void add(const Json& cause, const ReportedPlace& place, bool alone, std::vector<HandedOn>& all) {
  const ReportedCause what(cause.at("cause"));
  HandedOn one{what.place.empty() ? place.name : what.place, what.id, {}, alone, place.robot_id};
  for (const Json& number : cause.at("numbers")) one.x.push_back(number.at("deviation"));
  if (!one.x.empty()) all.push_back(std::move(one));  // "unknown" has none
}

void addAll(const Json& finding, const ReportedPlace& place, std::vector<HandedOn>& all) {
  if (finding.value("below_size_of_interest", false)) return;
  add(finding, place, finding.at("rivals").empty(), all);
  for (const Json& rival : finding.at("rivals")) add(rival, place, false, all);
}

bool contains(const std::vector<Joint>& all, const std::vector<Joint>& some) {
  return std::all_of(some.begin(), some.end(), [&](Joint joint) {
    return std::find(all.begin(), all.end(), joint) != all.end();
  });
}

std::size_t indexOf(const std::vector<PlacedCause>& causes, const HandedOn& one) {
  const auto same = [&](const PlacedCause& other) {
    return other.cause.id == one.cause && other.place == one.place;
  };
  return static_cast<std::size_t>(std::find_if(causes.begin(), causes.end(), same) -
                                  causes.begin());
}

// One look is enough: it is fitted in any case.
Cause lookedAt(Cause cause, const std::vector<double>& x) {
  for (std::size_t i = 0; i < cause.free.size() && i < x.size(); ++i) cause.free[i].starts = {x[i]};
  return cause;
}

// Second numbers may be no concern of this level, or of it alone.
std::vector<double> numbersFor(const Cause& cause, std::vector<double> x) {
  if (x.size() > cause.free.size()) x.resize(cause.free.size());
  while (x.size() < cause.free.size() && cause.free[x.size()].stays) {
    x.push_back(cause.free[x.size()].starts.front());
  }
  return x;
}

const Cause* ofJoints(const std::string& id) {
  const auto& all = jointCauses();
  const auto at = std::find_if(all.begin(), all.end(), [&](const Cause& c) { return c.id == id; });
  return at == all.end() ? nullptr : &*at;
}

}  // namespace

std::vector<HandedOn> readHandedOn(const std::string& report_file, const std::string& level) {
  std::vector<HandedOn> all;
  readReport(report_file, [&](const Json& report) {
    const std::string from = report.at("level");
    if (heightOf(from) >= heightOf(level)) {
      throw InputError(report_file + ": is of the " + from + " level, expected one below " + level);
    }
    for (const Json& finding : report.at("shared")) {
      ReportedPlace place("robot");
      place.robot_id = finding.value("robot_id", "");
      addAll(finding, place, all);
    }
    for (const Json& entry : report.at("joints")) {
      const ReportedPlace place(entry.at("joint"));
      for (const Json& finding : entry.at("findings")) addAll(finding, place, all);
    }
  });
  if (all.empty()) throw InputError(report_file + ": names no cause that could be handed on");
  return all;
}

std::vector<HandedOn> handedOnTo(const std::string& robot, const std::vector<HandedOn>& all) {
  std::vector<HandedOn> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some),
               [&](const HandedOn& one) { return one.robot.empty() || one.robot == robot; });
  return some;
}

void requireRobots(const std::vector<HandedOn>& all, const std::vector<std::string>& robots) {
  for (const HandedOn& one : all) {
    if (one.robot.empty()) continue;
    if (std::find(robots.begin(), robots.end(), one.robot) == robots.end()) {
      throw InputError("the report handed on is of robot " + one.robot +
                       " too, of which the set has no run");
    }
  }
}

std::vector<Provisional> provisionalAmong(std::vector<PlacedCause>& causes,
                                          const std::vector<HandedOn>& handed_on,
                                          const std::vector<Joint>& joints, const RobotModel& model,
                                          const std::vector<Joint>& measured) {
  std::vector<Provisional> found;
  for (const HandedOn& one : handed_on) {
    const std::vector<Joint> there = jointsAt(one.place, "the report handed on", model);
    if (!contains(measured, there)) continue;
    if (!joints.empty() && (there.empty() || !contains(joints, there))) continue;
    const std::size_t at = indexOf(causes, one);
    if (at == causes.size() || !causes[at].isTried()) {
      const Cause* cause = ofJoints(one.cause);
      if (cause == nullptr) continue;
      if (at == causes.size()) causes.emplace_back();
      causes[at] = placedCause(lookedAt(*cause, one.x), one.place, there, model, measured);
    }
    const bool again = std::any_of(found.begin(), found.end(), [&](const Provisional& other) {
      return other.chosen.cause == at;
    });
    const std::vector<double> x = numbersFor(causes[at].cause, one.x);
    if (!again && causes[at].cause.free.size() == x.size()) found.push_back({one, {at, x}});
  }
  return found;
}

std::vector<HandedOnFate> notTriedAmong(const std::vector<HandedOn>& handed_on, bool whole_robot,
                                        const RobotModel& model,
                                        const std::vector<Joint>& measured) {
  std::vector<HandedOnFate> fates;
  for (const HandedOn& one : handed_on) {
    const std::vector<Joint> there = jointsAt(one.place, "the report handed on", model);
    const Cause* cause = ofJoints(one.cause);
    HandedOnFate fate{one, {}, {}, 0, ""};
    if (cause == nullptr || cause->free.size() != one.x.size()) {
      fate.before.deviation = fate.before.value = one.x.front();
      fate.outcome = "not tried: this program has no such cause";
    } else {
      fate.before =
          foundNumbers(placedCause(*cause, one.place, there, model, measured).cause, one.x).front();
      if (!contains(measured, there)) fate.outcome = "not tried: not judged at this level";
      if (!whole_robot && there.empty()) fate.outcome = "not tried: of more than a limb";
    }
    if (!fate.outcome.empty()) fates.push_back(std::move(fate));
  }
  return fates;
}

}  // namespace nao::validation

#include "naoqi_api/services/al_autonomous_life.h"

#include <algorithm>
#include <array>
#include <deque>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "naoqi_api/al_module.h"
#include "naoqi_api/services/naoqi_method.h"
#include "naoqi_api/services/settings.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::CallError;
using rpc::Value;

constexpr std::array<const char*, 4> kStates = {"solitary", "interactive", "safeguard", "disabled"};
constexpr std::size_t kLongestHistory = 100;  // free

class AlAutonomousLife {
 public:
  explicit AlAutonomousLife(memory::MemoryStore& store) : store_(store), began_(store.now()) {
    for (const char* event :
         {"AutonomousLife/State", "AutonomousLife/FocusedActivity", "AutonomousLife/NextActivity",
          "AutonomousLife/LaunchSuggestions", "AutonomousLife/CompletedActivity"}) {
      store_.declareEvent(event, "ALAutonomousLife");
    }
    enter(state_);
  }

  void declare(rpc::Service& service) {
    declareState(service);
    declareFocus(service);
    declareAbilities(service);
  }

 private:
  using History = std::vector<std::tuple<std::string, std::int32_t>>;

  void enter(const std::string& state) {
    state_ = state;
    const auto now = std::chrono::duration_cast<std::chrono::seconds>(store_.now()).count();
    history_.push_front({state, static_cast<std::int32_t>(now)});
    if (history_.size() > kLongestHistory) history_.pop_back();
    store_.raiseEvent("AutonomousLife/State", state);
  }

  // From solitary only an activity leads to interactive, and there is none here.
  void setState(const std::string& state) {
    if (std::find(kStates.begin(), kStates.end(), state) == kStates.end()) {
      throw CallError("unknown state: " + state +
                      ", expected solitary, interactive, safeguard or disabled");
    }
    if (state == state_) return;
    if (state == "interactive" && state_ == "solitary") {
      throw CallError("solitary can not become interactive without an activity");
    }
    enter(state);
  }

  History history(std::size_t depth) const {
    const auto end = history_.begin() + static_cast<long>(std::min(depth, history_.size()));
    return {history_.begin(), end};
  }

  void declareState(rpc::Service& service) {
    addFunction(
        service, "getState", [this] { return state_; },
        "solitary, interactive, safeguard or disabled; disabled at first.");
    addFunction(
        service, "setState", [this](const std::string& state) { setState(state); },
        "Changes the state.", Argument{"state", "Any, but from solitary not interactive."});
    addFunction(
        service, "getStateHistory", [this] { return history(kLongestHistory); },
        "[(state, when it began [s]), ...], the newest first.");
    addFunction(
        service, "getStateHistory",
        [this](std::int32_t depth) {
          return history(static_cast<std::size_t>(std::max(0, depth)));
        },
        "[(state, when it began [s]), ...], the newest first.",
        Argument{"depth", "How many at most."});
    addFunction(
        service, "getLifeTime",
        [this] {
          const auto age = std::chrono::duration_cast<std::chrono::seconds>(store_.now() - began_);
          return static_cast<std::int32_t>(age.count());
        },
        "How long the robot lives [s] of simulated time.");
    addFunction(
        service, "stopAll", [this] { focus_.clear(); }, "Ends the activity in focus.");
  }

  void declareFocus(rpc::Service& service) {
    addFunction(
        service, "focusedActivity", [this] { return focus_; }, "The activity in focus; none.");
    addFunction(
        service, "stopFocus", [this] { focus_.clear(); }, "Ends the activity in focus.");
    addFunction(
        service, "switchFocus",
        [](const std::string& activity) {
          throw CallError("unknown activity: " + activity + "; none is installed");
        },
        "Starts an activity; none is installed.", Argument{"activity", "Its name."});
    addFunction(
        service, "switchFocus",
        [](const std::string& activity, std::int32_t) {
          throw CallError("unknown activity: " + activity + "; none is installed");
        },
        "Starts an activity; none is installed.", Argument{"activity", "Its name."},
        Argument{"flags", "Ignored."});
    const auto none = [] { return History(); };
    addFunction(service, "getFocusHistory", none, "Which activities were in focus: none.");
    addFunction(
        service, "getFocusHistory", [](std::int32_t) { return History(); },
        "Which activities were in focus: none.", Argument{"depth", "How many at most."});
    addFunction(
        service, "startMonitoringLaunchpadConditions", [this] { monitors_ = true; }, "Is kept.");
    addFunction(
        service, "stopMonitoringLaunchpadConditions", [this] { monitors_ = false; }, "Is kept.");
    addFunction(
        service, "isMonitoringLaunchpadConditions", [this] { return monitors_; }, "What was kept.");
  }

  void declareAbilities(rpc::Service& service) {
    const Argument name{"name", "Its name."};
    const Argument enabled{"enabled", "True: on, false: off."};
    addFunction(
        service, "setAutonomousAbilityEnabled",
        [this](const std::string& ability, bool on) { set(disabled_abilities_, ability, !on); },
        "Is kept.", name, enabled);
    addFunction(
        service, "getAutonomousAbilityEnabled",
        [this](const std::string& ability) { return disabled_abilities_.count(ability) == 0; },
        "What was kept; on at first.", name);
    addFunction(
        service, "setSafeguardEnabled",
        [this](const std::string& safeguard, bool on) {
          set(disabled_safeguards_, safeguard, !on);
        },
        "Is kept.", name, enabled);
    addFunction(
        service, "isSafeguardEnabled",
        [this](const std::string& safeguard) { return disabled_safeguards_.count(safeguard) == 0; },
        "What was kept; on at first.", name);
  }

  static void set(std::set<std::string>& names, const std::string& name, bool member) {
    constexpr std::size_t kMost = 256;
    if (!member) {
      names.erase(name);
    } else if (names.size() < kMost) {
      names.insert(name);
    }
  }

  memory::MemoryStore& store_;
  Duration began_;
  std::string state_ = "disabled";
  std::string focus_;
  bool monitors_ = true;
  std::deque<std::tuple<std::string, std::int32_t>> history_;
  std::set<std::string> disabled_abilities_;
  std::set<std::string> disabled_safeguards_;
};

}  // namespace

std::shared_ptr<rpc::Service> makeAlAutonomousLife(const ServiceContext& context) {
  auto service = std::make_shared<rpc::Service>(
      rpc::alModule("ALAutonomousLife", "The states of a life without activities."));
  const auto life = std::make_shared<AlAutonomousLife>(context.store());
  life->declare(*service);
  service->owning(life);
  addSettings(*service, documentedService("ALAutonomousLife"));
  service->allAnswering(rpc::Answer::Simplified);
  return service;
}

}  // namespace nao::services

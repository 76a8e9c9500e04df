#include "naoqi_api/services/version_shapes.h"

#include <string>
#include <utility>
#include <vector>

namespace nao::services {
namespace {

using rpc::Method;
using rpc::Pending;
using rpc::Value;
using Change = void (*)(Method&, const rpc::Personality&);

// The same call with another result.
template <class Then>
void changeResult(Method& method, Then then) {
  method.call = [call = method.call, then](const rpc::Caller& caller,
                                           const std::vector<Value>& arguments) {
    const Pending<Value> before = call(caller, arguments);
    Pending<Value> result;
    before.whenDone([result, then](const auto& outcome) {
      if (outcome.isCanceled()) return result.cancelNow();
      if (outcome.error) return result.fail(*outcome.error);
      result.resolve(then(*outcome.value));
    });
    result.cancelsWith(before);
    return result;
  };
}

void tellSuccess(Method& method, const rpc::Personality& /*personality*/) {
  method.setReturns("b");
  method.return_meaning = "True: errors come as such.";
  changeResult(method, [](const Value&) { return Value(true); });
}

void tellNothing(Method& method, const rpc::Personality& /*personality*/) {
  method.setReturns("v");
  changeResult(method, [](const Value&) { return Value(); });
}

// [[min, max, velocity, torque], ...] without the torques.
void withoutTorque(Method& method, const rpc::Personality& /*personality*/) {
  changeResult(method, [](const Value& limits) {
    std::vector<Value> joints;
    for (const Value& joint : *limits.findItems()) {
      auto items = *joint.findItems();
      items.resize(3);
      joints.push_back(Value::list(std::move(items)));
    }
    return Value::list(std::move(joints));
  });
}

void tellVersion(Method& method, const rpc::Personality& personality) {
  changeResult(method, [version = personality.version](const Value&) { return Value(version); });
}

struct Difference {
  const char* service;  // null: all
  const char* method;
  std::size_t arguments;
  int from, to;  // releases, as Personality::release
  Change change;
};

// Sources: ALMotion 1.12's generated proxy, and the API pages of 1.14, 2.1 and 2.8.
constexpr Difference kDifferences[] = {
    {nullptr, "version", 0, 0, 999, tellVersion},
    {"ALSystem", "systemVersion", 0, 0, 999, tellVersion},
    {"ALMotion", "getLimits", 1, 0, 112, withoutTorque},
    {"ALMotion", "wakeUp", 0, 208, 999, tellSuccess},
    {"ALMotion", "stopMove", 0, 208, 999, tellSuccess},
    {"ALMotion", "stopWalk", 0, 208, 999, tellSuccess},
    {"ALMotion", "moveTo", 2, 208, 999, tellSuccess},
    {"ALMotion", "moveTo", 3, 208, 999, tellSuccess},
    {"ALMotion", "moveTo", 4, 208, 999, tellSuccess},
    {"ALMotion", "moveTo", 5, 208, 999, tellSuccess},
    {"ALMotion", "walkTo", 1, 208, 999, tellSuccess},
    {"ALMotion", "walkTo", 2, 208, 999, tellSuccess},
    {"ALMotion", "walkTo", 3, 208, 999, tellSuccess},
    {"ALMotion", "walkTo", 4, 208, 999, tellSuccess},
    {"ALVideoDevice", "unsubscribe", 1, 0, 114, tellNothing},
};

bool applies(const Difference& difference, const std::string& service, const Method& method,
             int release) {
  if (release < difference.from || release > difference.to) return false;
  if (difference.service && difference.service != service) return false;
  return method.name == difference.method &&
         rpc::Signature::of(method.parameters_signature).children().size() == difference.arguments;
}

}  // namespace

void applyVersion(rpc::ServiceHub& hub, const rpc::Personality& personality) {
  for (const auto& [id, entry] : hub.entries()) {
    if (!entry.service) continue;
    for (const Difference& difference : kDifferences) {
      entry.service->change([&](Method& method) {
        if (applies(difference, entry.name, method, personality.release)) {
          difference.change(method, personality);
        }
      });
    }
  }
}

}  // namespace nao::services

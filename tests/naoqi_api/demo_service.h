#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "naoqi_api/service.h"

namespace nao::rpc {

/// The service of the captures: one member of every kind, in the captured order.
class Demo {
 public:
  Service describe() {
    return Service("Demo", "")
        .method("say", this, &Demo::say, "", Argument{})
        .method("add", this, &Demo::addInts, "", Argument{}, Argument{})
        .method("add", this, &Demo::addFloats, "", Argument{}, Argument{})
        .method("nothing", this, &Demo::nothing, "")
        .method("echo", this, &Demo::echo, "", Argument{})
        .method("getAngles", this, &Demo::getAngles, "", Argument{}, Argument{})
        .method("amap", this, &Demo::amap, "")
        .method("raw", this, &Demo::raw, "")
        .method("fail", this, &Demo::fail, "")
        .method("slow", this, &Demo::slow, "", Argument{})
        .method("helper", this, &Demo::helper, "")
        .method("fire", this, &Demo::fire, "", Argument{})
        .signal("tick", tick)
        .property("level", level);
  }

  /// Ends the calls of slow() as if their time had passed.
  void finishSlowCalls() {
    for (const auto& [call, milliseconds] : std::exchange(slow_calls, {})) {
      call.resolve(milliseconds);
    }
  }

  int calls_of_nothing = 0;
  std::vector<std::pair<Pending<int>, int>> slow_calls;
  std::weak_ptr<Service> last_helper;
  Signal<int, std::string> tick;
  Property<float> level{0.5F};

 private:
  std::string say(const std::string& text) { return "hello " + text; }
  int addInts(int a, int b) {  // wraps around: any bytes may come
    return static_cast<int>(static_cast<unsigned>(a) + static_cast<unsigned>(b));
  }
  float addFloats(float a, float b) { return a + b; }
  void nothing() { ++calls_of_nothing; }
  Value echo(const Value& value) { return value; }
  std::vector<float> getAngles(const std::vector<std::string>& names, bool /*use_sensors*/) {
    return std::vector<float>(names.size(), 0.25F);
  }
  std::map<std::string, int> amap() { return {{"a", 1}, {"b", 2}}; }
  SharedBytes raw() { return std::make_shared<const Bytes>(Bytes{1, 2, 3, 4}); }
  void fail() { throw CallError("deliberate failure"); }
  Pending<int> slow(int milliseconds) {
    Pending<int> result;
    milliseconds == 0 ? result.onlyWaits() : result.onCancel([] {});
    slow_calls.emplace_back(result, milliseconds);
    return result;
  }
  std::shared_ptr<Service> helper() {
    const std::function<std::string()> who = [] { return "helper"; };
    auto made = std::make_shared<Service>(Service("Helper", "").method("who", who, ""));
    last_helper = made;
    return made;
  }
  void fire(int number) { tick(number, "tick"); }
};

}  // namespace nao::rpc

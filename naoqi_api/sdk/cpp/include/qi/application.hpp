#pragma once

#include <functional>

#include <usarnaoqi_sdk/export.h>

namespace qi {

/// As far as remote modules use it: their main function is ALTools::mainFunction().
class USARNAOQI_SDK_API Application {
 public:
  /// `act` is called once, when the main function has been told to end, while the robot can still
  /// be called; in the order in which they came. True: it will be.
  static bool atStop(std::function<void()> act);
};

}  // namespace qi

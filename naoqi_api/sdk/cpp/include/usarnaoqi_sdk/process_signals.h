#pragma once

#include <functional>
#include <memory>

#include <usarnaoqi_sdk/export.h>

namespace AL {

/// Calls of a function at every cycle, until disconnect() or the end of the module's process.
class USARNAOQI_SDK_API ProcessSignalConnection {
 public:
  struct Slot;
  ProcessSignalConnection() {}
  explicit ProcessSignalConnection(std::shared_ptr<Slot> slot) : slot_(slot) {}

  /// When it returns the function does not run, unless it is what calls, and is not called again.
  void disconnect();
  bool connected() const;

 private:
  std::weak_ptr<Slot> slot_;
};

/// The DCM's loop as a local module sees it: functions called every 10 ms of simulated time, while
/// that time stands still. Only in a process that hosts the robot (`usarnaoqi serve --module`).
class USARNAOQI_SDK_API ALProcessSignals {
 public:
  typedef AL::ProcessSignalConnection ProcessSignalConnection;
  typedef std::function<void()> ProcessSignalSlot;

  /// Before the cycle's commands go to the motors. @throws ALError in another process
  static ProcessSignalConnection atPreProcess(const ProcessSignalSlot& slot);
  /// After the sensors were read. @throws ALError in another process
  static ProcessSignalConnection atPostProcess(const ProcessSignalSlot& slot);
};

}  // namespace AL

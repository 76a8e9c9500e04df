#include "naoqi_api/sdk/cpp/src/process_signals.h"

#include <alerror/alerror.h>
#include <usarnaoqi_sdk/process_signals.h>

#include <algorithm>
#include <mutex>
#include <utility>

#include "naoqi_api/sdk/cpp/src/addresses.h"

namespace AL {

struct ProcessSignalConnection::Slot {
  std::recursive_mutex mutex;  // held while it runs: it may disconnect itself
  std::function<void()> call;  // none: disconnected
};

namespace {

using Slot = ProcessSignalConnection::Slot;

struct Phases {
  std::mutex mutex;
  std::vector<std::shared_ptr<Slot>> before;
  std::vector<std::shared_ptr<Slot>> after;
};

// Never destroyed: the host's thread may call until the very end.
Phases& phases() {
  static Phases* the_phases = new Phases;
  return *the_phases;
}

ProcessSignalConnection connect(std::vector<std::shared_ptr<Slot>>& slots, const char* method,
                                const std::function<void()>& call) {
  if (!nao::client::isOwnRobotSet()) {
    throw ALError("ALProcessSignals", method,
                  "only a local module hears of the cycle: usarnaoqi serve --module FILE");
  }
  const auto slot = std::make_shared<Slot>();
  slot->call = call;
  const std::lock_guard<std::mutex> lock(phases().mutex);
  slots.push_back(slot);
  return ProcessSignalConnection(slot);
}

void run(std::vector<std::shared_ptr<Slot>>& slots, std::vector<std::string>& errors) {
  std::vector<std::shared_ptr<Slot>> all;
  {
    const std::lock_guard<std::mutex> lock(phases().mutex);
    const auto is_over = [](const std::shared_ptr<Slot>& slot) {
      const std::lock_guard<std::recursive_mutex> hold(slot->mutex);
      return !slot->call;
    };
    slots.erase(std::remove_if(slots.begin(), slots.end(), is_over), slots.end());
    all = slots;
  }
  for (const std::shared_ptr<Slot>& slot : all) {
    const std::lock_guard<std::recursive_mutex> hold(slot->mutex);
    const std::function<void()> call = slot->call;
    try {
      if (call) call();
    } catch (const std::exception& error) {
      errors.emplace_back(error.what());
    }
  }
}

}  // namespace

void ProcessSignalConnection::disconnect() {
  const std::shared_ptr<Slot> slot = slot_.lock();
  if (!slot) return;
  const std::lock_guard<std::recursive_mutex> hold(slot->mutex);
  slot->call = nullptr;
}

bool ProcessSignalConnection::connected() const {
  const std::shared_ptr<Slot> slot = slot_.lock();
  if (!slot) return false;
  const std::lock_guard<std::recursive_mutex> hold(slot->mutex);
  return static_cast<bool>(slot->call);
}

ProcessSignalConnection ALProcessSignals::atPreProcess(const ProcessSignalSlot& slot) {
  return connect(phases().before, "atPreProcess", slot);
}

ProcessSignalConnection ALProcessSignals::atPostProcess(const ProcessSignalSlot& slot) {
  return connect(phases().after, "atPostProcess", slot);
}

}  // namespace AL

namespace nao::client {

std::vector<std::string> runCycle() {
  std::vector<std::string> errors;
  AL::run(AL::phases().after, errors);
  AL::run(AL::phases().before, errors);
  return errors;
}

}  // namespace nao::client

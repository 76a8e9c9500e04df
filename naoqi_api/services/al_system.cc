#include "naoqi_api/services/al_system.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <system_error>
#include <utility>

#include "naoqi_api/al_module.h"
#include "naoqi_api/call_error.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::CallError;
using rpc::Value;

constexpr char kVersion[] = "2.1.4.13";  // the NAOqi whose behaviour is followed

// A line "MemTotal:  16384 kB" of Linux' /proc/meminfo, in kB; 0 if there is none.
std::int32_t hostMemory(const std::string& name) {
  std::ifstream file("/proc/meminfo");
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string label;
    std::int64_t kilobytes = 0;
    if (words >> label >> kilobytes && label == name + ":") {
      constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
      return static_cast<std::int32_t>(std::min(kilobytes, kMost));
    }
  }
  return 0;
}

// Names with directories, such as Europe/Amsterdam, UTC or Etc/GMT+1.
bool isTimezone(const std::string& text) {
  constexpr std::size_t kLongest = 64;
  return !text.empty() && text.size() <= kLongest &&
         std::all_of(text.begin(), text.end(), [](unsigned char letter) {
           return std::isalnum(letter) != 0 || letter == '/' || letter == '_' || letter == '+' ||
                  letter == '-';
         });
}

}  // namespace

AlSystem::AlSystem(memory::MemoryStore& memory, std::string name)
    : memory_(memory), name_(std::move(name)) {
  memory_.declareEvent("ALSystem/RobotNameChanged", "ALSystem");
}

bool AlSystem::setRobotName(const std::string& name) {
  constexpr std::size_t kLongest = 64;
  if (name.empty() || name.size() > kLongest) return false;
  name_ = name;
  memory_.insert("Device/DeviceList/ChestBoard/BodyNickName", name);
  memory_.raiseEvent("ALSystem/RobotNameChanged", name);
  return true;
}

std::string AlSystem::systemVersion() { return kVersion; }

// [[name, value], ...]; its shape on a robot is not documented.
Value AlSystem::systemInfo() {
  return Value::list({Value::list({"robotName", name_}), Value::list({"systemVersion", kVersion}),
                      Value::list({"timezone", timezone_}),
                      Value::list({"totalMemory", totalMemory()}),
                      Value::list({"freeMemory", freeMemory()})});
}

bool AlSystem::setTimezone(const std::string& timezone) {
  if (!isTimezone(timezone)) return false;
  timezone_ = timezone;
  return true;
}

std::int32_t AlSystem::freeMemory() { return hostMemory("MemAvailable"); }

std::int32_t AlSystem::totalMemory() { return hostMemory("MemTotal"); }

// The fields of PartitionInfo; the host's other file systems are nobody's business.
std::vector<Value> AlSystem::diskFree(bool /*all*/) {
  std::error_code failed;
  const auto space = std::filesystem::space("/", failed);
  if (failed) throw CallError("the disk can not be asked: " + failed.message());
  return {Value::tuple("(ssLL)<PartitionInfo,filesystem,path,size,free>",
                       {"rootfs", "/", static_cast<std::uint64_t>(space.capacity),
                        static_cast<std::uint64_t>(space.available)})};
}

rpc::Service AlSystem::describe() {
  using Self = AlSystem;
  rpc::Service service = rpc::alModule("ALSystem", "Name, versions and resources of the robot.");
  addMethod(service, "robotName", this, &Self::robotName, "The robot's name.");
  addMethod(service, "setRobotName", this, &Self::setRobotName,
            "Renames the robot; false if the name is empty or too long.",
            Argument{"name", "1 to 64 bytes."});
  addMethod(service, "systemVersion", this, &Self::systemVersion, "The version of NAOqi.");
  addMethod(service, "previousSystemVersion", this, &Self::previousSystemVersion,
            "The version before an update; always empty.");
  addMethod(service, "systemInfo", this, &Self::systemInfo, "[[name, value], ...]");
  addMethod(service, "timezone", this, &Self::timezone, "The robot's time zone.");
  addMethod(service, "setTimezone", this, &Self::setTimezone,
            "Changes the time zone that timezone() tells; no clock follows it.",
            Argument{"timezone", "Such as Europe/Amsterdam."});
  addMethod(service, "freeMemory", this, &Self::freeMemory, "Available memory of the host [kB].");
  addMethod(service, "totalMemory", this, &Self::totalMemory, "Memory of the host [kB].");
  addMethod(service, "diskFree", this, &Self::diskFree,
            "[(file system, path, size, free)] of the host's root, in bytes.",
            Argument{"all", "Has no effect."});
  return service;
}

}  // namespace nao::services

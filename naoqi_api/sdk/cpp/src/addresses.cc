#include "naoqi_api/sdk/cpp/src/addresses.h"

#include <cstdlib>
#include <mutex>
#include <optional>

namespace nao::client {
namespace {

struct OwnRobot {
  std::mutex mutex;
  std::optional<Endpoint> endpoint;
  const UsarnaoqiPictures* pictures = nullptr;
};

OwnRobot& ownRobot() {
  static OwnRobot robot;
  return robot;
}

std::string environment(const char* name) {
  const char* text = std::getenv(name);
  return text ? text : "";
}

// "tcp://host:port", "host:port" or "host".
void redirect(Endpoint& endpoint, std::string address) {
  const std::string scheme = "tcp://";
  if (address.rfind(scheme, 0) == 0) address.erase(0, scheme.size());
  const std::size_t colon = address.rfind(':');
  endpoint.host = address.substr(0, colon);
  if (colon == std::string::npos) return;
  const int port = std::atoi(address.c_str() + colon + 1);
  if (port > 0 && port <= 65535) endpoint.port = static_cast<std::uint16_t>(port);
}

}  // namespace

Endpoint endpointFor(const std::string& host, int port) {
  {
    const std::lock_guard lock(ownRobot().mutex);
    if (ownRobot().endpoint) return *ownRobot().endpoint;
  }
  constexpr int kUsualPort = 9559;
  const bool usable = port > 0 && port <= 65535;
  Endpoint endpoint{host.empty() ? "127.0.0.1" : host,
                    static_cast<std::uint16_t>(usable ? port : kUsualPort),
                    environment("USARNAOQI_USER"), environment("USARNAOQI_TOKEN")};
  if (const std::string ip = environment("NAO_IP"); !ip.empty()) endpoint.host = ip;
  if (const std::string all = environment("NAOQI_ADDRESS"); !all.empty()) redirect(endpoint, all);
  return endpoint;
}

void setOwnRobot(const Endpoint& endpoint) {
  const std::lock_guard lock(ownRobot().mutex);
  ownRobot().endpoint = endpoint;
}

bool isOwnRobotSet() {
  const std::lock_guard lock(ownRobot().mutex);
  return ownRobot().endpoint.has_value();
}

void setOwnPictures(const UsarnaoqiPictures* pictures) {
  const std::lock_guard lock(ownRobot().mutex);
  ownRobot().pictures = pictures;
}

const UsarnaoqiPictures* ownPictures() {
  const std::lock_guard lock(ownRobot().mutex);
  return ownRobot().pictures;
}

}  // namespace nao::client

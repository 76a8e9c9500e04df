#include "naoqi_api/sdk/cpp/src/addresses.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

namespace nao::client {
namespace {

constexpr int kUsualPort = 9559;

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

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> parts;
  std::istringstream in(list);
  for (std::string part; std::getline(in, part, ',');) parts.push_back(part);
  return parts;
}

// This machine has several names.
std::string plainHost(std::string host) {
  std::transform(host.begin(), host.end(), host.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return host == "localhost" || host == "0.0.0.0" ? "127.0.0.1" : host;
}

// Which address this is of those that the program has named, the first one first.
std::size_t orderOf(const std::string& host, int port) {
  static std::mutex mutex;
  static std::vector<std::pair<std::string, int>> named;
  if (host.empty()) return 0;
  const std::pair<std::string, int> one{plainHost(host), port};
  const std::lock_guard lock(mutex);
  const auto found = std::find(named.begin(), named.end(), one);
  const auto order = static_cast<std::size_t>(found - named.begin());
  if (found == named.end()) named.push_back(one);
  return order;
}

// Of several robots the one with that number behind the usual port, or of that address.
std::string robotFor(const std::vector<std::string>& robots, const std::string& host, int port) {
  if (robots.size() == 1) return robots.front();
  const int number = port - kUsualPort;
  if (number > 0 && number < static_cast<int>(robots.size())) {
    return robots[static_cast<std::size_t>(number)];
  }
  return robots[std::min(orderOf(host, port), robots.size() - 1)];
}

}  // namespace

Endpoint endpointFor(const std::string& host, int port) {
  {
    const std::lock_guard lock(ownRobot().mutex);
    if (ownRobot().endpoint) return *ownRobot().endpoint;
  }
  const bool usable = port > 0 && port <= 65535;
  Endpoint endpoint{host.empty() ? "127.0.0.1" : host,
                    static_cast<std::uint16_t>(usable ? port : kUsualPort),
                    environment("USARNAOQI_USER"), environment("USARNAOQI_TOKEN")};
  if (const std::string ip = environment("NAO_IP"); !ip.empty()) endpoint.host = ip;
  const std::vector<std::string> robots = split(environment("NAOQI_ADDRESS"));
  if (!robots.empty()) redirect(endpoint, robotFor(robots, host, endpoint.port));
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

#include "daemon/options.h"

#include <algorithm>
#include <boost/asio/ip/address.hpp>
#include <charconv>
#include <limits>

#include "core/check.h"

namespace nao::daemon {

RobotOption parseRobot(const std::string& text) {
  const std::size_t equals = text.find('=');
  RobotOption robot;
  robot.name = text.substr(0, equals);
  robot.model = equals == std::string::npos ? text : text.substr(equals + 1);
  if (robot.name.empty() || robot.model.empty()) {
    throw InputError("--robot: expected MODEL or NAME=MODEL, found '" + text + "'");
  }
  return robot;
}

LolaOption parseLola(const std::string& text) {
  LolaOption lola;
  if (text.empty()) return lola;
  const std::size_t equals = text.find('=');
  const bool named = equals != std::string::npos && text.find('/') > equals;
  if (named) lola.robot = text.substr(0, equals);
  lola.path = named ? text.substr(equals + 1) : text;
  if (lola.path.empty() || (named && lola.robot.empty())) {
    throw InputError("--lola: expected PATH or ROBOT=PATH, found '" + text + "'");
  }
  return lola;
}

std::vector<std::string> lolaPaths(const std::vector<LolaOption>& lola,
                                   const std::vector<std::string>& robots) {
  std::vector<std::string> paths(robots.size());
  // Those that say whose they are, first.
  for (const bool named : {true, false}) {
    for (const LolaOption& option : lola) {
      if (option.robot.empty() == named) continue;
      const auto robot =
          named ? std::find(robots.begin(), robots.end(), option.robot)
                : robots.begin() + (std::find(paths.begin(), paths.end(), "") - paths.begin());
      if (robot == robots.end()) {
        throw InputError(named ? "--lola: there is no robot '" + option.robot + "'"
                               : "--lola: " + option.path + " is one more than there are robots");
      }
      std::string& path = paths[static_cast<std::size_t>(robot - robots.begin())];
      if (!path.empty()) throw InputError("--lola: robot '" + *robot + "' has two sockets");
      if (std::find(paths.begin(), paths.end(), option.path) != paths.end()) {
        throw InputError("--lola: two robots have the socket " + option.path);
      }
      path = option.path;
    }
  }
  return paths;
}

wire::LolaBattery parseLolaBattery(const std::string& text) {
  if (text == "status-first") return wire::LolaBattery::StatusFirst;
  if (text == "current-first") return wire::LolaBattery::CurrentFirst;
  throw InputError("--lola-battery: expected status-first or current-first, found '" + text + "'");
}

void checkSecurity(const Options& options) {
  if (options.listen.empty()) throw InputError("--listen: expected an IP address, found none");
  for (const std::string& host : options.listen) {
    boost::system::error_code error;
    const auto address = boost::asio::ip::make_address(host, error);
    if (error) throw InputError("--listen: expected an IP address, found '" + host + "'");
    if (address.is_loopback() || !options.auth.empty() || options.insecure) continue;
    throw InputError("--listen: others can reach " + host +
                     ", expected --auth FILE with a line 'user token' for each of them, or "
                     "--insecure to let everybody in");
  }
}

std::uint16_t portOf(std::uint16_t first, std::size_t robot, const std::string& option) {
  if (first == 0) return 0;
  const std::size_t port = first + robot;
  if (port > std::numeric_limits<std::uint16_t>::max()) {
    throw InputError(option + ": robot " + std::to_string(robot) + " would listen on port " +
                     std::to_string(port) + ", expected " + option +
                     " and the number of robots to stay at or below 65535");
  }
  return static_cast<std::uint16_t>(port);
}

double parseSpeed(const std::string& text) {
  if (text == "max") return std::numeric_limits<double>::infinity();
  double speed = 0;
  const auto end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, speed);
  if (read.ec != std::errc() || read.ptr != end || !(speed > 0) || speed > 1e6) {
    throw InputError("--speed: expected 'max' or a number above 0, found '" + text + "'");
  }
  return speed;
}

}  // namespace nao::daemon

#pragma once

#include <map>
#include <string>

#include "naoqi_api/services/service_info.h"

namespace nao::rpc {

/// What one end of a connection says it can do; what is not named, it can not.
using Capabilities = std::map<std::string, bool>;

/// Which server the endpoint behaves like where versions differ.
struct Personality {
  std::string version = "2.1.4.13";  // in full, as ALSystem.systemVersion tells it
  int release = 201;                 // 100 * major + minor, for tables of differences

  Capabilities capabilities;

  /// A first message that is no authentication: NAOqi 2.1 to 2.8 answer it (and send their
  /// capabilities), libqi 4 refuses every call until the client has authenticated.
  bool needs_authentication = false;

  /// Whether a walk stops before what the sonar hears: from 2.0 on.
  bool has_obstacle_reflex = true;

  /// Whether ALVideoDevice numbers the first window of a name, too (name_0); 1.x did not.
  bool numbers_first_window = true;

  /// Whether it has no services and methods that came later. A user who asks for a version gets
  /// it so; one who only chose a robot keeps them, for programs of all times.
  bool hides_newer = false;

  services::ServiceInfoFields service_info = services::ServiceInfoFields::Six;

  /// Whether metaobjects carry the texts about members; libqi's own have none.
  bool documents_members = true;

  /// The robot's NAOqi 2.1 to 2.8: the default.
  static Personality naoqi();
  /// A NAOqi by its version: 1.12, 1.14, 2.1, 2.5, 2.8 or 2.9, or a longer text that begins so.
  /// 1.x changes names and shapes; its wire is that of 2.1. @throws InputError for any other.
  static Personality naoqi(const std::string& version);
  /// The NAOqi that ran on a robot of this hardware version, such as "V3.3", with capabilities
  /// that are of use to clients of every version.
  static Personality naoqiOf(const std::string& robot_version);
  /// A libqi 4 server, as the captures show it.
  static Personality libqi4();
};

}  // namespace nao::rpc

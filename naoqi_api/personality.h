#pragma once

#include <map>
#include <string>

#include "naoqi_api/services/service_info.h"

namespace nao::rpc {

/// What one end of a connection says it can do; what is not named, it can not.
using Capabilities = std::map<std::string, bool>;

/// Which server the endpoint behaves like where versions differ.
struct Personality {
  Capabilities capabilities;

  /// A first message that is no authentication: NAOqi 2.1 to 2.8 answer it (and send their
  /// capabilities), libqi 4 refuses every call until the client has authenticated.
  bool needs_authentication = false;

  services::ServiceInfoFields service_info = services::ServiceInfoFields::Six;

  /// Whether metaobjects carry the texts about members; libqi's own have none.
  bool documents_members = true;

  /// The robot's NAOqi 2.1 to 2.8: the default.
  static Personality naoqi();
  /// A libqi 4 server, as the captures show it.
  static Personality libqi4();
};

}  // namespace nao::rpc

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "naoqi_api/credentials.h"

namespace nao::daemon {

/// What a browser says about where a request goes and comes from.
struct WebAddress {
  std::string host;    // the header Host
  std::string origin;  // the header Origin; empty: none
};

/// Whether a request may be answered. Its host must be an IP address, localhost, or `own_name`:
/// another name that leads here is a trick (DNS rebinding). Its origin, if it has one, must be the
/// page's own host or one of `origins`: other sites' pages may not use a visitor's robot.
bool isAllowed(const WebAddress& address, const std::string& own_name,
               const std::vector<std::string>& origins);

/// Whether the header Authorization holds a user and token of `credentials` (HTTP's Basic).
bool isAuthorized(std::string_view header, const rpc::Credentials& credentials);

/// What the path of a request asks for.
struct WebRequest {
  enum class Kind { Page, Script, Handshake, Socket, Poll, Unknown };
  Kind kind = Kind::Unknown;
  std::string session;  // of Socket and Poll
};

WebRequest readTarget(std::string_view target);

}  // namespace nao::daemon

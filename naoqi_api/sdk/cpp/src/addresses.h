#pragma once

#include <usarnaoqi_sdk/local_host.h>

#include <string>

#include "naoqi_api/sdk/cpp/src/connection.h"

namespace nao::client {

/// Where a program that names `host` and `port` is to connect to: there, unless the environment
/// says NAOQI_ADDRESS=[tcp://]host[:port] or NAO_IP=host. Of several robots, with commas between
/// them, robot i is meant by port 9559 + i, or else by the i-th address that was named. User and
/// token are those of USARNAOQI_USER and USARNAOQI_TOKEN, and a module's host may have set all
/// (setOwnRobot).
Endpoint endpointFor(const std::string& host, int port);

/// From now on every address means this robot: the one whose process this is.
void setOwnRobot(const Endpoint& endpoint);
bool isOwnRobotSet();

/// How a module gets that robot's pictures, or null.
void setOwnPictures(const UsarnaoqiPictures* pictures);
const UsarnaoqiPictures* ownPictures();

}  // namespace nao::client

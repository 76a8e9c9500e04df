#pragma once

#include <string>

#include "naoqi_api/service.h"

namespace nao::rpc {

/// A service with the members every NaoQi module has at ids 100 to 112: exit, __pCall (that is
/// ALProxy's .post), pCall, version, ping, getMethodList, getMethodHelp, getModuleHelp, wait,
/// isRunning, stop, getBrokerName, getUsage. Its own members follow from 113.
Service alModule(std::string name, std::string meaning);

}  // namespace nao::rpc

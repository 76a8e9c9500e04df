#pragma once

#include <string>

#include "naoqi_api/service.h"

namespace nao::rpc {

/// A service with the members every NaoQi module has at ids 100 to 112: exit, __pCall (that is
/// ALProxy's .post), pCall, version, ping, getMethodList, getMethodHelp, getModuleHelp, wait,
/// isRunning, stop, getBrokerName, getUsage. Its own members follow from 113.
Service alModule(std::string name, std::string meaning);

/// Adds to a module wait(id) without a time-out, as NAOqi 2.8 has it, after its own members, whose
/// ids stay those of older versions. Nothing for a service that is no module.
void addShortWait(Service& service);

}  // namespace nao::rpc

#pragma once

#include <map>
#include <string>

#include "naoqi_api/documented/documented_services.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// What a setting is before anybody sets it, by its name: what follows get, set or is.
using SettingDefaults = std::map<std::string, rpc::Value>;

/// Adds the methods of `documented` that only keep a value: pairs such as getX/setX and
/// isXEnabled with setXEnabled or enableX, and getParameter/setParameter by name. What is not in
/// `defaults` begins as 0, false or nothing. They count as simplified.
void addSettings(rpc::Service& service, const DocumentedService& documented,
                 const SettingDefaults& defaults = {});

}  // namespace nao::services

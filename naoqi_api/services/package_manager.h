#pragma once

#include "naoqi_api/services/behavior_runner.h"
#include "naoqi_api/services/make_module.h"

namespace nao::services {

/// PackageManager: packages are the folders of the installed behaviors. Their methods' arguments
/// are not published; here each takes the name of a package. I/O thread.
ServicePointer makePackageManager(const std::shared_ptr<BehaviorRunner>& behaviors);

}  // namespace nao::services

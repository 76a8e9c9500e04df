#pragma once

#include <string>

#include <boost/shared_ptr.hpp>

#include <alcommon/albroker.h>
#include <usarnaoqi_sdk/export.h>

/// What a module's library offers: makes the modules, returns 0.
typedef int (*TMainType)(boost::shared_ptr<AL::ALBroker> broker);

namespace ALTools {

/// The main function of a remote module: --pip and --pport name the robot (127.0.0.1, 9559), -b,
/// -p,
/// --bip and --bport are accepted. Makes the modules and serves them until Ctrl-C, SIGTERM, or the
/// robot is gone. Returns the exit code.
USARNAOQI_SDK_API int mainFunction(const std::string& name, int argc, char* argv[],
                                   TMainType create_module);

}  // namespace ALTools

namespace AL {
namespace ALTools = ::ALTools;
}  // namespace AL

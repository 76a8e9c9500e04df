#pragma once

namespace nao::daemon {

/// Lets this process open as many files and sockets as its hard limit allows: a thousand clients
/// need more than the usual soft limit of 1,024.
void raiseDescriptorLimit();

}  // namespace nao::daemon

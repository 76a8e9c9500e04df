#pragma once

namespace nao::daemon {

/// Asks the kernel to let this thread, which works little and often, run soon after it wakes,
/// before those that have long work to do. Linux 6.12 or newer does so; others may ignore it. False
/// if the kernel knows no such thing, or the thread runs by other rules, which it keeps.
bool makeThreadPrompt();

}  // namespace nao::daemon

#pragma once

#include <sys/types.h>
#include <cstdint>

namespace nao::clock {

/// The program's connections to the world, and how many bytes went each way: neither side goes on
/// while bytes are on their way, so that the kernel's speed decides nothing.

/// After connect(): if the other end is the world's.
void openLink(int descriptor);
void closeLink(int descriptor);
/// The process ends.
void closeLinks();
/// The second descriptor is the same connection as the first one, or none any more.
void copyLink(int descriptor, int copy);
void countSent(int descriptor, ssize_t bytes);
void countTaken(int descriptor, ssize_t bytes);

/// Returns when of what the world has given and was not read yet something is here, to be read.
void settleLinks();

}  // namespace nao::clock

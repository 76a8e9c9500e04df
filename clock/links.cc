#include "clock/links.h"

#include <netinet/in.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include "clock/futex.h"
#include "clock/real.h"
#include "clock/registry.h"
#include "clock/turn.h"

namespace nao::clock {
namespace {

constexpr int kDescriptors = 65536;
constexpr int kLooks = 20000;  // of 100 us: bytes that do not come by then were read unseen

std::uint16_t links_of[kDescriptors];  // by descriptor: number + 1 of the link; 0: none
int highest = -1;

std::uint16_t portOf(const sockaddr_storage& address) {
  if (address.ss_family == AF_INET)
    return ntohs(reinterpret_cast<const sockaddr_in&>(address).sin_port);
  if (address.ss_family == AF_INET6)
    return ntohs(reinterpret_cast<const sockaddr_in6&>(address).sin6_port);
  return 0;
}

std::uint16_t portOf(int descriptor, decltype(&::getsockname) ask) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (ask(descriptor, reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
  return portOf(address);
}

bool isWorlds(std::uint16_t port) {
  for (const std::uint16_t own : page()->ports) {
    if (own == 0) return false;
    if (own == port) return true;
  }
  return false;
}

Link* linkOf(int descriptor) {
  if (descriptor < 0 || descriptor >= kDescriptors || links_of[descriptor] == 0) return nullptr;
  return &page()->links[links_of[descriptor] - 1];
}

std::uint16_t makeLink(std::uint16_t from, std::uint16_t to) {
  const Registry registry(*page());
  for (std::uint32_t i = 0; i < kLinks; ++i) {
    Link& link = page()->links[i];
    if (link.used.load() != kLinkFree) continue;
    link.process = ::getpid();
    link.from_port = from;
    link.to_port = to;
    link.sent = link.received = link.given = link.taken = 0;
    link.used = kLinkOpen;
    return static_cast<std::uint16_t>(i + 1);
  }
  return 0;
}

// The world may have closed it before.
void shut(Link& link) {
  std::uint32_t open = kLinkOpen;
  if (!link.used.compare_exchange_strong(open, kLinkClosed)) link.used = kLinkFree;
}

bool isUsedElsewhere(int descriptor) {
  for (int other = 0; other <= highest; ++other)
    if (other != descriptor && links_of[other] == links_of[descriptor]) return true;
  return false;
}

// Some of what is on its way is enough: there is more of it than a socket holds.
bool isSettled(const Link& link, int descriptor) {
  int waiting = 0;
  return link.taken.load() >= link.given.load() || ::ioctl(descriptor, FIONREAD, &waiting) != 0 ||
         waiting > 0;
}

void settle(Link& link, int descriptor) {
  for (int i = 0; i < kLooks; ++i) {
    if (isSettled(link, descriptor)) return;
    const timespec moment{0, 100000};
    rawCall(SYS_clock_nanosleep, CLOCK_MONOTONIC, 0, reinterpret_cast<long>(&moment), 0);
  }
  link.taken = link.given.load();  // and not waited for again
  page()->strayed.fetch_add(1);
}

}  // namespace

void closeLinks() {
  for (Link& link : page()->links)
    if (link.used.load() != kLinkFree && link.process.load() == ::getpid()) shut(link);
}

void openLink(int descriptor) {
  if (!page() || descriptor < 0 || descriptor >= kDescriptors) return;
  const std::uint16_t to = portOf(descriptor, ::getpeername);
  if (to == 0 || !isWorlds(to)) return;
  links_of[descriptor] = makeLink(portOf(descriptor, ::getsockname), to);
  if (descriptor > highest) highest = descriptor;
}

void closeLink(int descriptor) {
  Link* link = linkOf(descriptor);
  if (!link) return;
  if (link->process.load() == ::getpid() && !isUsedElsewhere(descriptor)) shut(*link);
  links_of[descriptor] = 0;
}

void copyLink(int descriptor, int copy) {
  if (copy < 0 || copy >= kDescriptors) return;
  links_of[copy] = linkOf(descriptor) ? links_of[descriptor] : 0;
  if (copy > highest) highest = copy;
}

void countSent(int descriptor, ssize_t bytes) {
  Link* link = bytes > 0 ? linkOf(descriptor) : nullptr;
  if (link) link->sent += static_cast<std::uint64_t>(bytes);
}

void countTaken(int descriptor, ssize_t bytes) {
  Link* link = bytes > 0 ? linkOf(descriptor) : nullptr;
  if (link) link->taken += static_cast<std::uint64_t>(bytes);
}

void settleLinks() {
  for (int i = 0; i <= highest; ++i) {
    Link* link = linkOf(i);
    if (link && link->used.load() == kLinkOpen && !isSettled(*link, i)) settle(*link, i);
  }
}

}  // namespace nao::clock

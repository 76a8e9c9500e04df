#include "daemon/lola_meeting.h"

#include <linux/sockios.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>

namespace nao::daemon {

LolaPeer::LolaPeer(int socket) : descriptor_(::dup(socket)) {}

LolaPeer::~LolaPeer() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

LolaPeer::Sent LolaPeer::send(const std::string& frame) {
  const std::lock_guard lock(mutex_);
  const auto sent = ::send(descriptor_, frame.data(), frame.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  if (sent == static_cast<ssize_t>(frame.size())) {
    ++frames_;
    return Sent::Whole;
  }
  const int error = sent < 0 ? errno : 0;
  left_some_ = left_some_ || error == ECONNRESET;
  return error != 0 && error != EAGAIN ? Sent::Gone : Sent::Not;
}

std::uint64_t LolaPeer::framesSent() const {
  const std::lock_guard lock(mutex_);
  return frames_;
}

// Linux drops what a client leaves unread when it closes; an error, told once, is what remains.
bool LolaPeer::hasReadAll() const {
  const std::lock_guard lock(mutex_);
  int unread = 0;
  if (::ioctl(descriptor_, SIOCOUTQ, &unread) == 0 && unread > 0) return false;
  int error = 0;
  socklen_t size = sizeof error;
  ::getsockopt(descriptor_, SOL_SOCKET, SO_ERROR, &error, &size);
  left_some_ = left_some_ || error == ECONNRESET;
  return !left_some_;
}

}  // namespace nao::daemon

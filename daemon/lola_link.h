#pragma once

#include <memory>
#include <string>

namespace nao::daemon {

/// The client's end of a NAO V6's LoLA socket: the robot sends a frame every 12 ms and waits for
/// one back. What is in them is not known here. Blocking, for one thread.
class LolaLink {
 public:
  static constexpr std::size_t kSensorFrame = 896;  // bytes, always

  /// `path`: of the socket, /tmp/robocup on a robot. @throws InputError if nobody answers there.
  explicit LolaLink(const std::string& path);
  ~LolaLink();
  LolaLink(const LolaLink&) = delete;
  LolaLink& operator=(const LolaLink&) = delete;

  /// The next sensor frame. @throws InputError once the robot closed the connection.
  std::string receive();
  void send(const std::string& frame);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace nao::daemon

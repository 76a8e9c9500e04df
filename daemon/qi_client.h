#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "naoqi_api/value.h"

namespace nao::daemon {

/// A client of a robot's NaoQi, real or simulated: calls methods of its services over the qi wire.
/// Blocking, for one thread. A silence of 20 s is an error.
class QiClient {
 public:
  /// @throws InputError if nobody answers there.
  QiClient(const std::string& host, std::uint16_t port);
  ~QiClient();
  QiClient(const QiClient&) = delete;
  QiClient& operator=(const QiClient&) = delete;

  /// Calls and waits. The overload for exactly these types is taken, else the first that they can
  /// be bent to as NaoQi does. @throws rpc::CallError with the robot's words if it refuses or has
  /// no such service or method; InputError if it falls silent.
  rpc::Value call(const std::string& service, const std::string& method,
                  const std::vector<rpc::Value>& arguments = {});

  /// A call under way.
  struct Ticket {
    std::size_t connection = 0;
    std::uint32_t id = 0;
    std::string result;  // signature
  };
  /// Calls and does not wait.
  Ticket begin(const std::string& service, const std::string& method,
               const std::vector<rpc::Value>& arguments = {});
  /// Whether a call has ended.
  bool isAnswered(const Ticket& ticket);
  /// Waits for the end of a call; once for each.
  rpc::Value finish(const Ticket& ticket);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace nao::daemon

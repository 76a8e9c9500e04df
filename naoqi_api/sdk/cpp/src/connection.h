#pragma once

#include <cstdint>
#include <functional>
#include <future>
#include <map>
#include <mutex>
#include <string>
#include <thread>

#include "naoqi_api/value.h"
#include "naoqi_api/wire/frame.h"

namespace nao::client {

/// Where a robot listens, and who says so; without a user nobody is asked.
struct Endpoint {
  std::string host;
  std::uint16_t port = 0;
  std::string user;
  std::string token;

  std::string text() const { return "tcp://" + host + ":" + std::to_string(port); }
};

/// One socket to a robot, open from its making until close() or until the robot goes. Thread-safe;
/// a thread of its own reads.
class Connection {
 public:
  using Incoming = std::function<void(const wire::Message&)>;

  /// `incoming` is told of calls and posts from the robot, on the reading thread: it must not wait.
  /// @throws std::runtime_error if nobody answers there, or it does not let us in.
  Connection(const Endpoint& endpoint, Incoming incoming);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Calls and waits for the answer, read as `returns`.
  /// @throws rpc::CallError with the robot's words, or if it is gone.
  rpc::Value call(const wire::Address& address, const rpc::Value& arguments,
                  const std::string& returns);

  void send(const wire::Message& message);

  bool isOpen() const;
  void close();

 private:
  void connect(const Endpoint& endpoint);
  void authenticate(const Endpoint& endpoint);
  std::future<wire::Message> begin(const wire::Address& address, rpc::Bytes payload);
  void read();
  void take(wire::Message message);
  void lose();

  Incoming incoming_;
  int socket_ = -1;
  std::mutex sending_;
  mutable std::mutex mutex_;  // of what follows
  std::map<std::uint32_t, std::promise<wire::Message>> open_calls_;
  std::uint32_t next_id_ = 1;
  bool lost_ = false;
  bool closing_ = false;
  std::thread reader_;
};

}  // namespace nao::client

#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <cstdint>
#include <map>
#include <string>

#include "naoqi_api/value.h"
#include "naoqi_api/wire/frame.h"

namespace nao::daemon {

/// One socket to a robot, open from its making on: frames out, frames in, answers kept until they
/// are asked for. Waits at most kPatience for each.
class QiClientConnection {
 public:
  static constexpr int kPatience = 20;  // [s]

  /// @throws InputError if nobody answers there.
  QiClientConnection(const std::string& host, std::uint16_t port);

  const std::string& name() const { return name_; }

  /// Sends a call; the number to ask for its answer with.
  std::uint32_t send(const wire::Address& address, const rpc::Value& arguments);

  /// Whether the answer to a call has come.
  bool hasAnswer(std::uint32_t id);

  wire::Message receive(std::uint32_t id);

  /// The answer to a call, read as `signature`. @throws rpc::CallError
  rpc::Value answer(std::uint32_t id, const std::string& signature);

 private:
  void authenticate();
  void take(wire::Message message);
  wire::Message receiveNext();

  std::string name_;
  boost::asio::io_context io_;
  boost::asio::ip::tcp::socket socket_;
  wire::FrameReader reader_;
  std::map<std::uint32_t, wire::Message> answers_;
  std::uint32_t next_id_ = 1;
};

}  // namespace nao::daemon

#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <string>

#include "daemon/stream.h"

namespace nao::daemon {

/// Sends without delay, and notices within about 30 s that the other end has gone: it is probed
/// after 30 s of silence, and what it does not acknowledge for 30 s ends it.
void tuneSocket(boost::asio::ip::tcp::socket& socket);

/// "tcp" -> tcp://192.168.1.2:9559 for the socket's own end.
std::string dialledAddress(const char* scheme, const boost::asio::ip::tcp::socket& socket);

/// Plain TCP.
class TcpStream : public Stream {
 public:
  TcpStream(boost::asio::ip::tcp::socket socket, ReadBuffer& buffer);

  void open(Done done) override;
  void read(Got got) override;
  void write(const rpc::Bytes& bytes, Done done) override;
  void close() override;
  bool isOpen() const override { return socket_.is_open(); }
  std::string endpoint() const override { return dialledAddress("tcp", socket_); }

 private:
  boost::asio::ip::tcp::socket socket_;
  ReadBuffer& buffer_;
};

}  // namespace nao::daemon

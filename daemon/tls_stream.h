#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <memory>
#include <string>
#include <vector>

#include "daemon/stream.h"

namespace nao::daemon {

/// The server's side of TLS 1.2 or newer with the certificate and key kept in `folder`; at the
/// first start it makes them: self-signed, as robots have it, whose clients do not check it.
/// @throws InputError when the folder can not be used.
std::shared_ptr<boost::asio::ssl::context> makeTlsContext(const std::string& folder);

/// TLS over TCP: qi's scheme `tcps`.
class TlsStream : public Stream {
 public:
  TlsStream(boost::asio::ip::tcp::socket socket,
            std::shared_ptr<boost::asio::ssl::context> context);

  void open(Done done) override;
  void read(Got got) override;
  void write(const rpc::Bytes& bytes, Done done) override;
  void close() override;
  bool isOpen() const override { return stream_.lowest_layer().is_open(); }
  std::string endpoint() const override;

 private:
  std::shared_ptr<boost::asio::ssl::context> context_;  // outlives the stream
  boost::asio::ssl::stream<boost::asio::ip::tcp::socket> stream_;
  std::vector<std::uint8_t> buffer_;
};

}  // namespace nao::daemon

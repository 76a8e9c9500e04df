#include "daemon/tls_stream.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/write.hpp>
#include <filesystem>
#include <utility>

#include "core/check.h"
#include "daemon/certificate.h"
#include "daemon/tcp_stream.h"

namespace nao::daemon {

namespace ssl = boost::asio::ssl;

std::shared_ptr<ssl::context> makeTlsContext(const std::string& folder) {
  const CertificateFiles files = findOrMakeCertificate(folder);
  auto context = std::make_shared<ssl::context>(ssl::context::tls_server);
  context->set_options(ssl::context::default_workarounds | ssl::context::no_sslv2 |
                       ssl::context::no_sslv3 | ssl::context::no_tlsv1 | ssl::context::no_tlsv1_1);
  try {
    context->use_certificate_chain_file(files.certificate);
    context->use_private_key_file(files.key, ssl::context::pem);
  } catch (const boost::system::system_error& error) {
    throw InputError(files.certificate +
                     ": expected a certificate, and its key beside it: " + error.code().message());
  }
  return context;
}

TlsStream::TlsStream(boost::asio::ip::tcp::socket socket, std::shared_ptr<ssl::context> context)
    : context_(std::move(context)), stream_(std::move(socket), *context_), buffer_(16384) {
  tuneSocket(stream_.next_layer());
}

void TlsStream::open(Done done) {
  stream_.async_handshake(ssl::stream_base::server, std::move(done));
}

void TlsStream::read(Got got) {
  stream_.async_read_some(boost::asio::buffer(buffer_),
                          [this, got = std::move(got)](const Error& error, std::size_t count) {
                            got(error, buffer_.data(), count);
                          });
}

void TlsStream::write(const rpc::Bytes& bytes, Done done) {
  boost::asio::async_write(
      stream_, boost::asio::buffer(bytes),
      [done = std::move(done)](const Error& error, std::size_t /*count*/) { done(error); });
}

void TlsStream::close() {
  Error ignored;
  stream_.lowest_layer().close(ignored);
}

std::string TlsStream::endpoint() const { return dialledAddress("tcps", stream_.next_layer()); }

}  // namespace nao::daemon

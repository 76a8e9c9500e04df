#include "daemon/robot_endpoints.h"

#include <fstream>
#include <sstream>
#include <utility>

#include "core/check.h"
#include "daemon/certificate.h"
#include "daemon/tcp_stream.h"
#include "daemon/tls_stream.h"
#include "naoqi_api/wire/msgpack_connection.h"
#include "naoqi_api/wire/qi_connection.h"

namespace nao::daemon {
namespace {

using boost::asio::ip::tcp;

MakeStream plainStreams(TurnGate* gate, WireDelay* wire) {
  return [gate, wire](tcp::socket socket, Stream::ReadBuffer& buffer) -> std::unique_ptr<Stream> {
    boost::system::error_code gone;
    const std::uint16_t from = socket.remote_endpoint(gone).port();
    const std::uint16_t to = socket.local_endpoint(gone).port();
    std::unique_ptr<Stream> stream = std::make_unique<TcpStream>(std::move(socket), buffer);
    if (gate) stream = gate->guard(std::move(stream), from, to);
    if (wire) stream = wire->over(std::move(stream));
    return stream;
  };
}

MakeStream tlsStreams(const Options& options) {
  const std::string& folder = options.tls_dir;
  const auto context = makeTlsContext(folder.empty() ? defaultCertificateFolder() : folder);
  return [context](tcp::socket socket, Stream::ReadBuffer& /*buffer*/) {
    return std::make_unique<TlsStream>(std::move(socket), context);
  };
}

template <class T>
MakeConnection connectionsTo(rpc::ServiceHub& hub) {
  return [&hub](const std::string& endpoint, wire::Connection::Send send) {
    return std::make_unique<T>(hub, endpoint, std::move(send));
  };
}

std::string readFile(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw InputError(path + ": can not be read, expected what --http-port serves");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string urlOf(const std::string& scheme, const std::string& host, std::uint16_t port) {
  const bool is_v6 = host.find(':') != std::string::npos;
  return scheme + "://" + (is_v6 ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

}  // namespace

RobotEndpoints::RobotEndpoints(boost::asio::io_context& io, const Options& options,
                               std::size_t robot, rpc::ServiceHub& hub, TurnGate* gate,
                               WireDelay* wire)
    : hosts_(options.listen) {
  checkSecurity(options);
  const auto address = [&](std::uint16_t first, const char* option) {
    return Address{options.listen, portOf(first, robot, option), option};
  };
  const auto budget = std::make_shared<ByteBudget>();
  const auto qi = connectionsTo<wire::QiConnection>(hub);
  qi_ = std::make_unique<Server>(io, address(options.port, "--port"), plainStreams(gate, wire), qi,
                                 budget);
  if (const auto port = options.tls_port) {
    tls_ =
        std::make_unique<Server>(io, address(*port, "--tls-port"), tlsStreams(options), qi, budget);
  }
  if (const auto port = options.msgpack_port) {
    msgpack_ =
        std::make_unique<Server>(io, address(*port, "--msgpack-port"), plainStreams(gate, wire),
                                 connectionsTo<wire::MsgpackConnection>(hub), budget);
  }
  if (const auto port = options.http_port) {
    const WebContent content{readFile(options.pages + "/index.html"),
                             readFile(options.pages + "/qi.js"), options.origins};
    web_ = std::make_unique<WebServer>(io, address(*port, "--http-port"), hub, content, budget);
  }
}

std::vector<std::string> RobotEndpoints::otherAddresses() const {
  std::vector<std::string> addresses;
  const auto add = [&](const char* scheme, std::uint16_t port) {
    for (const std::string& host : hosts_) addresses.push_back(urlOf(scheme, host, port));
  };
  add("tcp", qi_->port());
  addresses.erase(addresses.begin());
  if (tls_) add("tcps", tls_->port());
  if (msgpack_) add("msgpack-rpc", msgpack_->port());
  if (web_) add("http", web_->port());
  return addresses;
}

std::vector<std::uint16_t> RobotEndpoints::gatedPorts() const {
  std::vector<std::uint16_t> ports = {qi_->port()};
  if (msgpack_) ports.push_back(msgpack_->port());
  return ports;
}

void RobotEndpoints::close() {
  qi_->close();
  if (tls_) tls_->close();
  if (msgpack_) msgpack_->close();
  if (web_) web_->close();
}

}  // namespace nao::daemon

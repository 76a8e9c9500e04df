// The daemon's wires beside plain qi, on loopback: TLS, msgpack-RPC, HTTP with qi.js.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <boost/asio/connect.hpp>
#include <boost/asio/ssl.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "core/check.h"
#include "naoqi_api/wire/msgpack_codec.h"
#include "tests/core/temporary_folder.h"
#include "tests/daemon/running_daemon.h"
#include "tests/daemon/tcp_client.h"

namespace nao::daemon {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using rpc::Value;
using tcp = asio::ip::tcp;

tcp::endpoint local(std::uint16_t port) { return {asio::ip::make_address("127.0.0.1"), port}; }

Options everyWire() {
  Options options = optionsForOne();
  options.tls_port = 0;
  options.msgpack_port = 0;
  options.http_port = 0;
  options.pages = NAO_SOURCE_DIR "/naoqi_api/sdk/js";
  static const TemporaryFolder keys;  // one key for all: making one takes a while
  options.tls_dir = keys.path();
  return options;
}

class OtherWires : public testing::Test {
 protected:
  // "msgpack-rpc://127.0.0.1:4711" -> 4711
  std::uint16_t portOf(const std::string& scheme) const {
    for (const std::string& address : running_.addresses()) {
      if (address.rfind(scheme + "://", 0) != 0) continue;
      return static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1)));
    }
    throw std::runtime_error("no " + scheme);
  }

  http::response<http::string_body> get(const std::string& target, const std::string& host,
                                        const std::string& origin = {}) {
    beast::tcp_stream stream(io_);
    stream.connect(local(portOf("http")));
    http::request<http::empty_body> request(http::verb::get, target, 11);
    request.set(http::field::host, host);
    if (!origin.empty()) request.set(http::field::origin, origin);
    http::write(stream, request);
    beast::flat_buffer buffer;
    http::response<http::string_body> response;
    http::read(stream, buffer, response);
    return response;
  }

  asio::io_context io_;
  Running running_{everyWire()};
};

TEST_F(OtherWires, TlsCarriesQi) {
  asio::ssl::context context(asio::ssl::context::tls_client);
  asio::ssl::stream<tcp::socket> stream(io_, context);
  stream.next_layer().connect(local(portOf("tcps")));
  stream.handshake(asio::ssl::stream_base::client);
  EXPECT_GE(SSL_version(stream.native_handle()), TLS1_2_VERSION);
  wire::Message message;
  message.id = 9;
  message.address = {1, 1, 100};
  wire::encode(message.payload, Value::tuple({"ALMotion"}), rpc::Signature::of("(s)"));
  asio::write(stream, asio::buffer(encodeFrame(message)));
  wire::FrameReader reader;
  reader.setMaxPayload(wire::kMaxPayload);
  std::optional<wire::Message> answer;
  while (!answer || answer->id != 9) {  // the daemon's capabilities come first
    answer = reader.next();
    if (answer) continue;
    std::uint8_t buffer[4096];
    reader.push(buffer, stream.read_some(asio::buffer(buffer)));
  }
  const Value info = wire::Decoder(answer->payload)
                         .read(services::serviceInfoSignature(services::ServiceInfoFields::Six));
  EXPECT_EQ(services::serviceInfoOf(info).endpoints.back(),
            "tcps://127.0.0.1:" + std::to_string(portOf("tcps")));
}

TEST_F(OtherWires, TheKeyIsForItsUserAlone) {
  const std::string key = everyWire().tls_dir + "/key.pem";
  struct stat status {};
  ASSERT_EQ(::stat(key.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600U);
}

TEST_F(OtherWires, OldTlsIsRefused) {
  asio::ssl::context context(asio::ssl::context::tls_client);
  SSL_CTX_set_max_proto_version(context.native_handle(), TLS1_1_VERSION);
  asio::ssl::stream<tcp::socket> stream(io_, context);
  stream.next_layer().connect(local(portOf("tcps")));
  boost::system::error_code error;
  stream.handshake(asio::ssl::stream_base::client, error);
  EXPECT_TRUE(error);
}

TEST_F(OtherWires, MsgpackRpcCallsServices) {
  tcp::socket socket(io_);
  socket.connect(local(portOf("msgpack-rpc")));
  wire::Bytes request;
  const Value call = Value::list({0, 1, "ALMotion.getBodyNames", Value::list({"Head"})});
  wire::packValue(request, call, {});
  asio::write(socket, asio::buffer(request));
  wire::MsgpackReader reader;
  std::optional<Value> answer;
  while (!(answer = reader.next())) {
    std::uint8_t buffer[4096];
    reader.push(buffer, socket.read_some(asio::buffer(buffer)));
  }
  EXPECT_EQ(*answer, Value::list({1, 1, Value(), Value::list({"HeadYaw", "HeadPitch"})}));
}

TEST_F(OtherWires, HttpServesItsPageAndScriptToThoseWhoMay) {
  EXPECT_EQ(get("/", "localhost").result_int(), 200U);
  const auto script = get("/libs/qi/2/qi.js", "127.0.0.1:8002");
  EXPECT_EQ(script.result_int(), 200U);
  EXPECT_NE(script.body().find("function QiSession"), std::string::npos);
  EXPECT_EQ(get("/", "evil.example").result_int(), 403U);
  EXPECT_EQ(get("/", "localhost", "http://evil.example").result_int(), 403U);
  EXPECT_EQ(get("/nothing", "localhost").result_int(), 404U);
}

TEST_F(OtherWires, APageTalksToARobotOverItsWebSocket) {
  const std::string base = "/libs/qimessaging/2/socket.io/1/";
  const std::string handshake = get(base + "?t=1", "localhost").body();
  const std::string session = handshake.substr(0, handshake.find(':'));
  EXPECT_EQ(handshake, session + ":15:25:websocket,xhr-polling");
  beast::websocket::stream<beast::tcp_stream> socket(io_);
  beast::get_lowest_layer(socket).connect(local(portOf("http")));
  socket.handshake("localhost", base + "websocket/" + session);
  const auto next = [&socket] {
    beast::flat_buffer buffer;
    socket.read(buffer);
    return beast::buffers_to_string(buffer.data());
  };
  EXPECT_EQ(next(), "1::");
  const auto call = [&](const std::string& object, const std::string& member,
                        const std::string& arguments) {
    socket.write(
        asio::buffer("5:::{\"name\":\"call\",\"args\":[{\"idm\":1,\"params\":{\"obj\":" + object +
                     ",\"member\":\"" + member + "\",\"args\":" + arguments + "}}]}"));
    return next();
  };
  const std::string motion = call("\"ServiceDirectory\"", "service", "[\"ALMotion\"]");
  EXPECT_EQ(motion.rfind("5:::{\"name\":\"reply\",\"args\":[{\"result\":{\"pyobject\":0,", 0), 0U);
  EXPECT_EQ(
      call("0", "getBodyNames", "[\"Head\"]"),
      "5:::{\"name\":\"reply\",\"args\":[{\"result\":[\"HeadYaw\",\"HeadPitch\"],\"idm\":1}]}");

  // A session is taken up once.
  beast::websocket::stream<beast::tcp_stream> second(io_);
  beast::get_lowest_layer(second).connect(local(portOf("http")));
  beast::error_code error;
  second.handshake("localhost", base + "websocket/" + session, error);
  EXPECT_TRUE(error);
}

TEST_F(OtherWires, APageWithoutAWebSocketPolls) {
  const std::string base = "/libs/qimessaging/2/socket.io/1/";
  const std::string handshake = get(base + "?t=1", "localhost").body();
  const std::string poll = base + "xhr-polling/" + handshake.substr(0, handshake.find(':'));
  const auto say = [&](const std::string& text) {
    beast::tcp_stream stream(io_);
    stream.connect(local(portOf("http")));
    http::request<http::string_body> request(http::verb::post, poll, 11);
    request.set(http::field::host, "localhost");
    request.set(http::field::content_type, "text/plain;charset=UTF-8");
    request.body() = text;
    request.prepare_payload();
    http::write(stream, request);
    beast::flat_buffer buffer;
    http::response<http::string_body> response;
    http::read(stream, buffer, response);
    return response;
  };
  EXPECT_EQ(get(poll, "localhost").body(), "1::");
  const std::string service =
      R"(5:::{"name":"call","args":[{"idm":1,"params":{"obj":"ServiceDirectory",)"
      R"("member":"service","args":["ALMotion"]}}]})";
  EXPECT_EQ(say(service).result_int(), 200U);
  EXPECT_EQ(get(poll + "?t=2", "localhost").body().rfind("5:::{\"name\":\"reply\"", 0), 0U);
  EXPECT_EQ(get(poll, "localhost", "http://evil.example").result_int(), 403U);
  EXPECT_EQ(say("no packet").result_int(), 400U);
  EXPECT_EQ(say(service).result_int(), 404U);  // it has gone
  EXPECT_EQ(get(base + "xhr-polling/0123", "localhost").result_int(), 404U);
}

TEST(Endpoints, ListenOnThePortOfEveryAddress) {
  Options options = optionsForOne();
  options.listen = {"127.0.0.1", "127.0.0.2"};
  const Running running(options);
  asio::io_context io;
  for (const std::string& host : options.listen) {
    tcp::socket socket(io);
    boost::system::error_code error;
    socket.connect({asio::ip::make_address(host), running.port()}, error);
    EXPECT_FALSE(error) << host;
  }
  EXPECT_EQ(running.addresses(),
            std::vector<std::string>{"tcp://127.0.0.2:" + std::to_string(running.port())});
}

TEST(Security, BeyondThisMachineNeedsAuthOrInsecure) {
  Options options = optionsForOne();
  options.listen = {"0.0.0.0"};
  EXPECT_THROW(Daemon{options}, InputError);
  options.insecure = true;
  EXPECT_NO_THROW(Daemon{options});
}

TEST(Security, EveryWireAsksForTheToken) {
  const TemporaryFolder folder;
  Options options = everyWire();
  options.auth = folder.write("auth", "nao secret\n");
  Running running(options);
  TcpClient client(running.port());
  const Value refused = client.answer(client.call({1, 1, 100}, Value::tuple({"ALMotion"})), "m");
  EXPECT_EQ(*refused.findText(), "The call request could not be handled.");

  asio::io_context io;
  for (const std::string& address : running.addresses()) {
    const auto port = static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1)));
    if (address.rfind("http", 0) == 0) {
      for (const std::string user : {"", "Basic bmFvOndyb25n", "Basic bmFvOnNlY3JldA=="}) {
        beast::tcp_stream stream(io);
        stream.connect(local(port));
        http::request<http::empty_body> request(http::verb::get, "/", 11);
        request.set(http::field::host, "localhost");
        if (!user.empty()) request.set(http::field::authorization, user);
        http::write(stream, request);
        beast::flat_buffer buffer;
        http::response<http::string_body> response;
        http::read(stream, buffer, response);
        EXPECT_EQ(response.result_int(), user == "Basic bmFvOnNlY3JldA==" ? 200U : 401U) << user;
      }
    }
  }
}

}  // namespace
}  // namespace nao::daemon

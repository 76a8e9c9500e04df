// Replays the client side of captured sessions with a real libqi 4.0.5 server and compares what
// ours answers with what it answered: type, flags, service, object, action, number and payload,
// except what differs by nature (machine, process and session id, uids, times, server links).

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "naoqi_api/wire/bytes.h"
#include "tests/naoqi_api/captured_robot.h"
#include "tests/naoqi_api/test_client.h"

namespace nao::wire {
namespace {

struct Line {
  bool from_client = false;
  Bytes bytes;
};

struct Connection {
  std::vector<Line> lines;
  bool closed_by_server = false;
};

Bytes fromHex(const std::string& text) {
  Bytes bytes;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(text.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

std::vector<Connection> loadCapture(const std::string& name) {
  std::ifstream file(std::string(NAO_SOURCE_DIR) + "/tests/data/captures/" + name + ".txt");
  std::vector<Connection> connections;
  for (std::string line; std::getline(file, line);) {
    if (line == "connection") connections.emplace_back();
    if (line == "closed by server") connections.back().closed_by_server = true;
    if (line[0] == '<' || line[0] == '>') {
      connections.back().lines.push_back({line[0] == '>', fromHex(line.substr(2))});
    }
  }
  return connections;
}

Message parse(const Bytes& frame) {
  FrameReader reader;
  reader.setMaxPayload(kMaxPayload);
  reader.push(frame.data(), frame.size());
  return reader.next().value();
}

constexpr char kInfo[] =
    "(sIsI[s]ss)<ServiceInfo,name,serviceId,machineId,processId,endpoints,sessionId,objectUid>";

// Fields that no two servers share become their length.
Value masked(const Value& info) {
  auto items = *info.findItems();
  for (int i : {2, 5, 6}) items[i] = std::to_string(items[i].findText()->size());
  items[3] = std::uint32_t{0};
  return Value::tuple(kInfo, std::move(items));
}

Bytes blanked(Bytes bytes, std::size_t start) {
  for (std::size_t i = start; i < bytes.size(); ++i) bytes[i] = 0;
  return bytes;
}

// Errors whose text is about the insides of libqi (C++ type names, a null pointer).
bool saysItInOtherWords(const Message& message) {
  const Address& address = message.address;
  return message.type == MessageType::Error && ((address.service == 2 && address.action == 6) ||
                                                (address.service == 1 && address.action == 109));
}

// The payload without what differs by nature. `ends_in_uid`: objects carry 20 bytes of uid.
Bytes comparable(const Message& message, bool ends_in_uid) {
  const Address& address = message.address;
  const Bytes& payload = message.payload;
  if (saysItInOtherWords(message)) return {};
  if (message.type == MessageType::Event && address.action == 86) {  // times, threads
    constexpr std::size_t kTimes = 2 * 8 + 2 * 8 + 2 * 4;
    return blanked(payload, payload.size() - kTimes);
  }
  if (message.type != MessageType::Reply) return payload;
  if (address.service != 0 && (address.action == 0 || address.action == 8)) {
    return blanked(payload, 0);  // server link
  }
  if (address.action == 82) return blanked(payload, 12);                          // durations
  if (address.service == 1 && address.action == 108) return blanked(payload, 4);  // machine id
  if (address.service == 2 && address.action == 110 && ends_in_uid) {
    return blanked(payload, payload.size() - 20);
  }
  Bytes bytes;
  if (address.service == 1 && address.action == 100) {
    encodeDynamic(bytes, masked(Decoder(payload).read(kInfo)));
    return bytes;
  }
  if (address.service == 1 && address.action == 101) {
    const Value infos = Decoder(payload).read("[" + std::string(kInfo) + "]");
    for (const Value& info : *infos.findItems()) encodeDynamic(bytes, masked(info));
    return bytes;
  }
  return payload;
}

void expectSame(const Message& ours, const Message& theirs, bool ends_in_uid) {
  SCOPED_TRACE("answer to " + std::to_string(theirs.id) + " of action " +
               std::to_string(theirs.address.action));
  EXPECT_EQ(ours.type, theirs.type);
  EXPECT_EQ(ours.flags, theirs.flags);
  EXPECT_EQ(ours.address.service, theirs.address.service);
  EXPECT_EQ(ours.address.object, theirs.address.object);
  EXPECT_EQ(ours.address.action, theirs.address.action);
  if (theirs.type != MessageType::Event) {
    EXPECT_EQ(ours.id, theirs.id);
  }
  EXPECT_EQ(comparable(ours, ends_in_uid), comparable(theirs, ends_in_uid));
}

// Returns how many messages of the server were compared.
int replay(const Connection& connection, rpc::ServiceHub& hub,
           const std::function<void()>& finish_slow_calls, bool ends_in_uid) {
  TestClient client(hub);
  int compared = 0;
  for (const Line& line : connection.lines) {
    if (line.from_client) {
      client.sendBytes(line.bytes);
      continue;
    }
    const Message theirs = parse(line.bytes);
    if (client.received.empty()) finish_slow_calls();
    const auto ours = client.next();
    if (!ours) {
      ADD_FAILURE() << "no answer to " << theirs.id;
      return compared;
    }
    expectSame(*ours, theirs, ends_in_uid);
    ++compared;
  }
  EXPECT_TRUE(client.received.empty()) << "more answers than the real server gave";
  // Where the real server waits for ever, after an HTTP request, ours closes.
  EXPECT_TRUE(client.connection->wantsClose() || !connection.closed_by_server);
  return compared;
}

int replayAll(const std::string& name, const rpc::Personality& personality, bool ends_in_uid) {
  int compared = 0;
  for (const Connection& connection : loadCapture(name)) {
    DemoHub demo(personality);  // like the captured ones, each starts from the same state
    compared += replay(
        connection, demo.hub, [&demo] { demo.demo.finishSlowCalls(); }, ends_in_uid);
  }
  return compared;
}

TEST(Capture, CppClientGetsTheAnswersOfARealServer) {
  EXPECT_EQ(replayAll("cpp_client", rpc::Personality::libqi4(), true), 34);
}

TEST(Capture, PyClientGetsTheAnswersOfARealServer) {
  EXPECT_EQ(replayAll("py_client", rpc::Personality::libqi4(), true), 39);
}

TEST(Capture, ClientWithTheCapabilitiesOf25GetsTheAnswersOfARealServer) {
  // The captured server ran with the same capabilities as its client.
  rpc::Personality personality = rpc::Personality::libqi4();
  personality.capabilities = {{"ClientServerSocket", true},
                              {"MessageFlags", true},
                              {"MetaObjectCache", true},
                              {"RemoteCancelableCalls", true}};
  EXPECT_EQ(replayAll("cpp_client_naoqi25caps", personality, false), 34);
}

TEST(Capture, OddOpeningsAndErrorsGetTheAnswersOfARealServer) {
  EXPECT_EQ(replayAll("legacy_probe", rpc::Personality::libqi4(), true), 48);
}

TEST(Capture, QiloopGetsTheAnswersOfARealServer) {
  EXPECT_EQ(replayAll("qiloop", rpc::Personality::libqi4(), false), 16);
}

// Programs for robots, in Go and in Python. The Go client cancels in a way that libqi does not
// take.
TEST(Capture, ClientsOfMotionAndCamerasGetTheAnswersOfARealServer) {
  int compared = 0;
  for (const Connection& connection : loadCapture("nao_clients")) {
    CapturedRobot robot;
    compared += replay(
        connection, robot.hub, [&robot] { robot.endMoves(); }, false);
  }
  EXPECT_EQ(compared, 35);
}

TEST(Capture, ConversionsAreThoseOfARealServer) {
  EXPECT_EQ(replayAll("conv_probe", rpc::Personality::libqi4(), true), 56);
  EXPECT_EQ(replayAll("conv_probe2", rpc::Personality::libqi4(), true), 22);
}

// Sessions at the same time: each line is marked with its connection, in the order of capture.
int replayTogether(const std::string& name) {
  std::ifstream file(std::string(NAO_SOURCE_DIR) + "/tests/data/captures/" + name + ".txt");
  DemoHub demo(rpc::Personality::libqi4());
  std::map<char, std::unique_ptr<TestClient>> clients;
  int compared = 0;
  for (std::string line; std::getline(file, line);) {
    auto& client = clients[line[0]];
    if (!client) client = std::make_unique<TestClient>(demo.hub);
    const Bytes bytes = fromHex(line.substr(3));
    if (line[1] == '>') {
      client->sendBytes(bytes);
      continue;
    }
    const auto ours = client->next();
    if (!ours) {
      ADD_FAILURE() << "no answer: " << line.substr(0, 60);
      return compared;
    }
    expectSame(*ours, parse(bytes), true);
    ++compared;
  }
  return compared;
}

TEST(Capture, QicliGetsTheAnswersOfARealServer) { EXPECT_EQ(replayTogether("qicli"), 68); }

TEST(Capture, AServiceInAnotherProcessIsRegisteredAndFoundAsInARealDirectory) {
  EXPECT_EQ(replayTogether("two_process"), 15);
}

}  // namespace
}  // namespace nao::wire

// Whatever bytes come, the connection answers with errors or closes: no crash, no endless growth.
// Mutations of real sessions, from a seeded generator.

#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "naoqi_api/wire/bytes.h"
#include "tests/naoqi_api/test_client.h"

namespace nao::wire {
namespace {

using Random = std::mt19937;

std::size_t below(Random& random, std::size_t bound) { return random() % bound; }

// Everything that one captured client sent, message by message.
std::vector<Bytes> clientMessages(const std::string& name) {
  std::ifstream file(std::string(NAO_SOURCE_DIR) + "/tests/data/captures/" + name + ".txt");
  std::vector<Bytes> messages;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("> ", 0) != 0) continue;
    Bytes bytes;
    for (std::size_t i = 2; i + 1 < line.size(); i += 2) {
      bytes.push_back(static_cast<std::uint8_t>(std::stoi(line.substr(i, 2), nullptr, 16)));
    }
    messages.push_back(std::move(bytes));
  }
  return messages;
}

// Changes a few bytes; the size of the payload is kept true so that the rest is looked at too.
Bytes mutated(Bytes message, Random& random) {
  const std::size_t changes = 1 + below(random, 4);
  for (std::size_t i = 0; i < changes && message.size() > 14; ++i) {
    const std::size_t at = 12 + below(random, message.size() - 12);
    message[at] = static_cast<std::uint8_t>(below(random, 3) == 0 ? 0xFF : random());
  }
  return message;
}

Bytes cut(Bytes message, Random& random) {
  if (message.size() <= kHeaderSize) return message;
  message.resize(kHeaderSize + below(random, message.size() - kHeaderSize));
  const auto size = static_cast<std::uint32_t>(message.size() - kHeaderSize);
  std::copy_n(reinterpret_cast<const std::uint8_t*>(&size), 4, message.begin() + 8);
  return message;
}

class Fuzz : public testing::TestWithParam<const char*> {};

TEST_P(Fuzz, MutatedSessionsAreAnsweredOrClosed) {
  const auto messages = clientMessages(GetParam());
  ASSERT_FALSE(messages.empty());
  for (unsigned seed = 0; seed < 300; ++seed) {
    Random random(seed);
    DemoHub demo(seed % 2 == 0 ? rpc::Personality::naoqi() : rpc::Personality::libqi4());
    TestClient client(demo.hub);
    client.authenticate();
    for (const Bytes& message : messages) {
      const std::size_t kind = below(random, 4);
      client.sendBytes(kind == 0   ? message
                       : kind == 1 ? cut(message, random)
                                   : mutated(message, random));
      if (client.connection->wantsClose()) break;
    }
    // Whatever happened, the next client is served.
    TestClient next(demo.hub);
    next.authenticate();
    next.call({2, 1, 101}, Value::tuple({1, 2}));
    ASSERT_EQ(next.nextValue("i"), Value(3)) << "seed " << seed;
    demo.demo.finishSlowCalls();
  }
}

INSTANTIATE_TEST_SUITE_P(Captures, Fuzz,
                         testing::Values("cpp_client", "py_client", "legacy_probe", "qiloop",
                                         "conv_probe", "cpp_client_naoqi25caps"));

TEST(Fuzz, RandomPayloadsAreErrorsAtMost) {
  DemoHub demo;
  TestClient client(demo.hub);
  client.authenticate();
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    Message message;
    message.id = static_cast<std::uint32_t>(i);
    message.type = MessageType::Call;
    message.flags = static_cast<std::uint8_t>(below(random, 4));
    message.address = {static_cast<std::uint32_t>(1 + below(random, 2)), 1,
                       static_cast<std::uint32_t>(below(random, 115))};
    message.payload.resize(below(random, 40));
    for (auto& byte : message.payload) byte = static_cast<std::uint8_t>(below(random, 128));
    client.send(message);
    if (message.address.action == 109) demo.demo.finishSlowCalls();
    ASSERT_FALSE(client.connection->wantsClose());
    client.received.clear();
  }
}

TEST(Fuzz, RandomSignaturesAreErrorsAtMost) {
  const std::string letters = "bcCwWiIlLfdsrmov_X*[]{}()<>,+#~";
  Random random(11);
  int readable = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string signature;
    for (std::size_t n = below(random, 12); n > 0; --n) {
      signature += letters[below(random, letters.size())];
    }
    Bytes bytes;
    appendText(bytes, signature);
    for (int n = 0; n < 40; ++n) bytes.push_back(static_cast<std::uint8_t>(below(random, 3)));
    try {
      const Value value = Decoder(bytes).read("m");
      Bytes again;
      encodeDynamic(again, value);
      EXPECT_LE(again.size(), bytes.size()) << signature;
      ++readable;
    } catch (const CodecError&) {
      continue;
    }
  }
  EXPECT_GT(readable, 1000);  // or nothing was tested
}

TEST(Fuzz, GarbageClosesWithoutAnAnswer) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    DemoHub demo;
    TestClient client(demo.hub);
    Bytes bytes(1 + below(random, 200));
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
    bytes[0] = 0x41;  // not the magic's
    client.sendBytes(bytes);
    ASSERT_TRUE(client.connection->wantsClose());
    ASSERT_FALSE(client.next());
  }
}

}  // namespace
}  // namespace nao::wire

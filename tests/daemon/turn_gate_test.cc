#include "daemon/turn_gate.h"

#include <gtest/gtest.h>

#include <boost/asio/error.hpp>
#include <string>
#include <utility>
#include <vector>

namespace nao::daemon {
namespace {

/// A socket that the test feeds.
class FakeStream final : public Stream {
 public:
  struct Wire {
    Got got;
    std::string written;
    bool closed = false;

    void come(const std::string& text, const Error& error = {}) {
      const Got to = std::exchange(got, {});
      ASSERT_TRUE(to) << "nobody reads";
      to(error, reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    }
  };

  explicit FakeStream(std::shared_ptr<Wire> wire) : wire_(std::move(wire)) {}
  void open(Done done) override { done({}); }
  void read(Got got) override { wire_->got = std::move(got); }
  void write(const rpc::Bytes& bytes, Done done) override {
    wire_->written.append(bytes.begin(), bytes.end());
    done({});
  }
  void close() override { wire_->closed = true; }
  bool isOpen() const override { return !wire_->closed; }
  std::string endpoint() const override { return "tcp://127.0.0.1:1"; }

 private:
  std::shared_ptr<Wire> wire_;
};

class TurnGateTest : public testing::Test {
 protected:
  struct Client {
    std::shared_ptr<FakeStream::Wire> wire;
    std::unique_ptr<Stream> stream;
  };

  // Reads that nothing came for, dropped as a loop of sockets that ends drops them.
  ~TurnGateTest() override {
    for (const auto& wire : wires_) wire->got = {};
  }

  std::shared_ptr<FakeStream::Wire> makeWire() {
    wires_.push_back(std::make_shared<FakeStream::Wire>());
    return wires_.back();
  }

  // Whose session notes what it hears under its name.
  Client connect(const std::string& name, std::uint16_t port) {
    Client client{makeWire(), nullptr};
    client.stream = gate_.guard(std::make_unique<FakeStream>(client.wire), port, 9559);
    listen(*client.stream, name);
    return client;
  }

  void listen(Stream& stream, const std::string& name) {
    stream.read([this, name, &stream](const Stream::Error& error, const std::uint8_t* bytes,
                                      std::size_t count) {
      heard_ += name + (error ? "!" : ":" + std::string(bytes, bytes + count)) + " ";
      if (!error) listen(stream, name);
    });
  }

  clock::Link& link(std::uint16_t port, std::uint64_t sent) {
    clock::Link& made = page_->links[links_++];
    made.from_port = port;
    made.to_port = 9559;
    made.sent = sent;
    made.used = clock::kLinkOpen;
    return made;
  }

  std::unique_ptr<clock::ClockPage> page_ = std::make_unique<clock::ClockPage>();
  TurnGate gate_{*page_};
  std::string heard_;
  std::size_t links_ = 0;
  std::vector<std::shared_ptr<FakeStream::Wire>> wires_;
};

TEST_F(TurnGateTest, ClientsAreHeardInTheOrderTheyCameHoweverTheirBytesDo) {
  const Client a = connect("a", 1);
  const Client b = connect("b", 2);
  b.wire->come("second");
  a.wire->come("fir");
  a.wire->come("st");
  EXPECT_EQ(heard_, "");
  EXPECT_TRUE(gate_.open());
  EXPECT_EQ(heard_, "a:first b:second ");
  EXPECT_FALSE(gate_.open());
}

TEST_F(TurnGateTest, ItHasAllOnceEveryByteSentIsHere) {
  clock::Link& sent = link(1, 3);
  EXPECT_FALSE(gate_.hasAll()) << "the connection is not accepted yet";
  const Client client = connect("a", 1);
  client.wire->come("ab");
  EXPECT_FALSE(gate_.hasAll());
  client.wire->come("c");
  EXPECT_TRUE(gate_.hasAll());
  sent.used = clock::kLinkClosed;
  EXPECT_FALSE(gate_.hasAll()) << "its end is not known yet";
  client.wire->come("", boost::asio::error::eof);
  EXPECT_TRUE(gate_.hasAll());
  gate_.open();
  gate_.open();
  EXPECT_EQ(heard_, "a:abc a! ");
}

TEST_F(TurnGateTest, CountsWhatClientsAreGiven) {
  const clock::Link& made = link(1, 0);
  const Client client = connect("a", 1);
  client.stream->write({'x', 'y'}, [](const auto&) {});
  EXPECT_EQ(client.wire->written, "xy");
  EXPECT_EQ(made.given.load(), 2u);
  EXPECT_EQ(gate_.given(), 2u);
}

TEST_F(TurnGateTest, ALinkIsFreeOnceBothSidesHaveClosedIt) {
  clock::Link& ours = link(1, 0);
  Client client = connect("a", 1);
  client.stream->close();
  EXPECT_EQ(ours.used.load(), clock::kLinkClosedByWorld);
  EXPECT_TRUE(gate_.hasAll());
  clock::Link& theirs = link(2, 0);
  Client other = connect("b", 2);
  theirs.used = clock::kLinkClosed;
  other.stream->close();
  EXPECT_EQ(theirs.used.load(), clock::kLinkFree);
}

TEST_F(TurnGateTest, WhatComesAfterTheSessionHasGoneIsNobodys) {
  const auto wire = makeWire();
  {
    const auto stream = gate_.guard(std::make_unique<FakeStream>(wire), 1, 9559);
    listen(*stream, "a");
  }
  wire->come("late");
  EXPECT_FALSE(gate_.open());
  EXPECT_EQ(heard_, "");
}

}  // namespace
}  // namespace nao::daemon

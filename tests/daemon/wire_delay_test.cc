#include "daemon/wire_delay.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace nao::daemon {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

/// The other end of a stream: what it was written, and a reader that waits.
struct FarEnd {
  std::vector<std::string> written;
  Stream::Got reader;

  void say(const std::string& text) {
    const auto to = std::exchange(reader, {});
    to({}, reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  }
};

class FakeStream final : public Stream {
 public:
  explicit FakeStream(FarEnd& end) : end_(end) {}
  void open(Done done) override { done({}); }
  void read(Got got) override { end_.reader = std::move(got); }
  void write(const rpc::Bytes& bytes, Done done) override {
    end_.written.emplace_back(bytes.begin(), bytes.end());
    done({});
  }
  void close() override {}
  bool isOpen() const override { return true; }
  std::string endpoint() const override { return {}; }

 private:
  FarEnd& end_;
};

class WireDelayTest : public testing::Test {
 protected:
  void advance(Duration time) { wire_.advance(SimTime(time)); }
  void write(const char* text) {
    sent_.push_back(std::make_unique<rpc::Bytes>(text, text + std::string(text).size()));
    stream_->write(*sent_.back(), [](const Stream::Error&) {});
  }
  void listen() {
    stream_->read([this](const Stream::Error&, const std::uint8_t* bytes, std::size_t count) {
      heard_.emplace_back(bytes, bytes + count);
    });
  }

  WireDelay wire_{1};
  FarEnd end_;
  std::unique_ptr<Stream> stream_ = wire_.over(std::make_unique<FakeStream>(end_));
  std::vector<std::unique_ptr<rpc::Bytes>> sent_;
  std::vector<std::string> heard_;
};

TEST_F(WireDelayTest, WithoutAFaultAllPassesAtOnce) {
  advance(1s);
  write("a");
  listen();
  end_.say("b");
  EXPECT_EQ(end_.written, std::vector<std::string>{"a"});
  EXPECT_EQ(heard_, std::vector<std::string>{"b"});
}

TEST_F(WireDelayTest, ADelayHoldsBothWaysBackAndEnds) {
  advance(1s);
  wire_.set({100ms, 0, SimTime(2s)});
  write("a");
  listen();
  end_.say("b");
  advance(1090ms);
  EXPECT_TRUE(end_.written.empty());
  EXPECT_TRUE(heard_.empty());
  advance(1100ms);
  EXPECT_EQ(end_.written, std::vector<std::string>{"a"});
  EXPECT_EQ(heard_, std::vector<std::string>{"b"});
  advance(2s);
  write("c");
  EXPECT_EQ(end_.written.size(), 2u);
}

TEST_F(WireDelayTest, NothingOvertakesWhatIsLate) {
  advance(1s);
  wire_.set({500ms, 0, SimTime(1100ms)});
  write("a");
  advance(1200ms);  // the fault is over
  write("b");
  EXPECT_TRUE(end_.written.empty());
  advance(1500ms);
  EXPECT_EQ(end_.written, (std::vector<std::string>{"a", "b"}));
}

TEST_F(WireDelayTest, WhatIsLostComesAgainLaterAndNothingIsMissing) {
  wire_.set({0ms, 0.5, SimTime(100s)});
  int late = 0;
  for (int i = 0; i < 200; ++i) {
    advance(Duration(10s * i));
    const std::size_t before = end_.written.size();
    write("x");
    if (end_.written.size() > before) continue;
    ++late;
    advance(Duration(10s * i) + 190ms);
    EXPECT_EQ(end_.written.size(), before);
    advance(Duration(10s * i) + 9s);
    if (i < 9) {
      EXPECT_EQ(end_.written.size(), before + 1);
    }
  }
  advance(std::chrono::hours(1));
  EXPECT_EQ(end_.written.size(), 200u);
  EXPECT_GT(late, 0);
  EXPECT_LT(late, 11);  // faults last 100 s: ten packets
}

TEST_F(WireDelayTest, AClosedStreamHearsNothingMore) {
  advance(1s);
  wire_.set({100ms, 0, SimTime(2s)});
  write("a");
  listen();
  end_.say("b");
  stream_.reset();
  advance(2s);
  EXPECT_TRUE(end_.written.empty());
  EXPECT_TRUE(heard_.empty());
}

}  // namespace
}  // namespace nao::daemon

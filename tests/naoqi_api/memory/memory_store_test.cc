#include "naoqi_api/memory/memory_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "naoqi_api/call_error.h"
#include "naoqi_api/memory/value_size.h"
#include "naoqi_api/service.h"

namespace nao::memory {
namespace {

using rpc::Value;
using std::chrono::milliseconds;
using ::testing::ElementsAre;

class MemoryStoreTest : public ::testing::Test {
 protected:
  std::shared_ptr<void> listenTo(MemoryStore& store, const std::string& key) {
    return store.listen(key, [this](const std::string& raised, const Value& value) {
      heard_.push_back(raised + " " + value.print());
    });
  }

  Duration now_{};
  MemoryStore store_{[this] { return now_; }};
  std::vector<std::string> heard_;
};

TEST_F(MemoryStoreTest, KeepsTypeAndTimeOfWhatIsInserted) {
  now_ = milliseconds(1500);
  store_.insert("answer", 42);
  const Entry* entry = store_.find("answer");
  ASSERT_NE(entry, nullptr);
  EXPECT_EQ(entry->type, KeyType::Data);
  EXPECT_EQ(entry->last.value, Value(42));
  EXPECT_EQ(entry->last.time, milliseconds(1500));
  EXPECT_EQ(store_.find("question"), nullptr);
}

TEST_F(MemoryStoreTest, TellsListenersOfRaisesNotOfInserts) {
  const auto token = listenTo(store_, "ball");
  store_.insert("ball", 1);
  EXPECT_THAT(heard_, ElementsAre());
  store_.raiseEvent("ball", 2);
  store_.raiseMicroEvent("ball", 3);
  EXPECT_THAT(heard_, ElementsAre("ball 2", "ball 3"));
}

TEST_F(MemoryStoreTest, TellsListenersThoughTheValueIsTheSame) {
  const auto token = listenTo(store_, "ball");
  store_.raiseEvent("ball", 1);
  store_.raiseEvent("ball", 1);
  EXPECT_THAT(heard_, ElementsAre("ball 1", "ball 1"));
}

TEST_F(MemoryStoreTest, AListenerWithoutItsTokenHearsNothingAndIsForgotten) {
  auto token = listenTo(store_, "ball");
  EXPECT_EQ(store_.listenerCount("ball"), 1U);
  token.reset();
  EXPECT_EQ(store_.listenerCount("ball"), 0U);
  store_.raiseEvent("ball", 1);
  EXPECT_THAT(heard_, ElementsAre());
}

TEST_F(MemoryStoreTest, ListeningMakesNoKey) {
  const auto token = listenTo(store_, "ball");
  EXPECT_EQ(store_.find("ball"), nullptr);
}

TEST_F(MemoryStoreTest, ATokenMayOutliveTheStore) {
  std::shared_ptr<void> token;
  {
    MemoryStore store([] { return Duration(); });
    token = listenTo(store, "ball");
  }
  token.reset();
  EXPECT_THAT(heard_, ElementsAre());
}

TEST_F(MemoryStoreTest, AListenerMayRemoveTheEventItHearsOf) {
  const auto token = store_.listen("ball", [this](const std::string& key, const Value&) {
    heard_.push_back(key);
    store_.remove(key);
  });
  store_.raiseEvent("ball", 1);
  EXPECT_THAT(heard_, ElementsAre("ball"));
  EXPECT_EQ(store_.find("ball"), nullptr);
}

TEST_F(MemoryStoreTest, ListenersOutliveTheKeyUntilTheyAreRemoved) {
  const auto token = listenTo(store_, "ball");
  store_.raiseEvent("ball", 1);
  EXPECT_TRUE(store_.remove("ball"));
  EXPECT_FALSE(store_.remove("ball"));
  store_.raiseEvent("ball", 2);
  store_.removeListeners("ball");
  store_.raiseEvent("ball", 3);
  EXPECT_THAT(heard_, ElementsAre("ball 1", "ball 2"));
}

TEST_F(MemoryStoreTest, EventsKeepTheirLastValuesAndMicroEventsNone) {
  for (int i = 0; i < 150; ++i) {
    now_ = milliseconds(i);
    store_.raiseEvent("event", i);
    store_.raiseMicroEvent("micro", i);
  }
  const auto& history = store_.find("event")->history;
  ASSERT_EQ(history.size(), MemoryLimits().history_entries);
  EXPECT_EQ(history.front().value, Value(50));
  EXPECT_EQ(history.back().value, Value(149));
  EXPECT_EQ(history.back().time, milliseconds(149));
  EXPECT_EQ(store_.find("micro")->type, KeyType::MicroEvent);
  EXPECT_TRUE(store_.find("micro")->history.empty());
}

TEST_F(MemoryStoreTest, ADeclaredEventHasNoValueUntilRaised) {
  store_.declareEvent("ball", "ALRedBallDetection");
  const Entry* entry = store_.find("ball");
  ASSERT_NE(entry, nullptr);
  EXPECT_EQ(entry->type, KeyType::Event);
  EXPECT_TRUE(entry->last.value.isVoid());
  EXPECT_TRUE(entry->history.empty());
  EXPECT_EQ(entry->extractor, "ALRedBallDetection");
}

TEST_F(MemoryStoreTest, RaisesItsOwnEventsAboutKeys) {
  const auto added = listenTo(store_, "ALMemory/KeyAdded");
  const auto changed = listenTo(store_, "ALMemory/KeyTypeChanged");
  const auto removed = listenTo(store_, "ALMemory/KeyRemoved");
  store_.insert("ball", 1);
  store_.insert("ball", 2);
  store_.declareEvent("ball");
  store_.remove("ball");
  EXPECT_THAT(heard_, ElementsAre("ALMemory/KeyAdded \"ball\"", "ALMemory/KeyTypeChanged \"ball\"",
                                  "ALMemory/KeyRemoved \"ball\""));
}

TEST_F(MemoryStoreTest, CountsNothingLeftWhenEverythingIsRemoved) {
  store_.insert("data", Value::list({"text", 1.5F}));
  store_.insert("data", std::string(1000, 'x'));
  store_.declareEvent("event", "extractor");
  for (int i = 0; i < 300; ++i) store_.raiseEvent("event", std::string(1000, 'x'));
  store_.describe("event", "what it means");
  EXPECT_GT(store_.bytes(), 1000U);
  store_.remove("data");
  store_.remove("event");
  EXPECT_EQ(store_.bytes(), 0U);
}

TEST_F(MemoryStoreTest, AHistoryOfLargeValuesStaysSmall) {
  for (int i = 0; i < 300; ++i) store_.raiseEvent("event", std::string(1000, 'x'));
  const MemoryLimits limits;
  EXPECT_LT(store_.find("event")->history.size(), limits.history_entries);
  EXPECT_LT(store_.bytes(), limits.history_bytes + 3000);
}

TEST(MemoryStore, RefusesAKeyTooMany) {
  MemoryLimits limits;
  limits.keys = 2;
  MemoryStore store([] { return Duration(); }, limits);
  store.insert("a", 1);
  store.insert("b", 2);
  EXPECT_THROW(store.demandRoom("c", 3), rpc::CallError);
  EXPECT_NO_THROW(store.demandRoom("b", 3));
}

TEST(MemoryStore, ClientsNeverFillItBeyondItsLimit) {
  MemoryLimits limits;
  limits.bytes = 100'000;
  MemoryStore store([] { return Duration(); }, limits);
  int refused = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::string key = "key" + std::to_string(i % 400);
    const Value value = std::string(static_cast<std::size_t>(i), 'x');
    try {
      store.demandRoom(key, value);
      store.raiseEvent(key, value);
    } catch (const rpc::CallError&) {
      ++refused;
    }
    ASSERT_LE(store.bytes(), limits.bytes);
  }
  EXPECT_GT(refused, 0);
}

TEST(MemoryStore, KeepsNoObjects) {
  MemoryStore store([] { return Duration(); });
  const auto object = std::make_shared<rpc::Service>("object", "");
  EXPECT_THROW(store.demandRoom("o", Value(object)), rpc::CallError);
  EXPECT_THROW(store.demandRoom("o", Value::list({1, Value::list({Value(object)})})),
               rpc::CallError);
}

TEST(ValueSize, CountsWhatIsInside) {
  EXPECT_EQ(sizeOf(1), sizeof(Value));
  EXPECT_EQ(sizeOf("12345"), sizeof(Value) + 5);
  EXPECT_EQ(sizeOf(Value::list({"12345", 1})), 3 * sizeof(Value) + 5 + 1);  // and "m"
  EXPECT_EQ(sizeOf(Value::raw(rpc::Bytes(100))), sizeof(Value) + 100);
  EXPECT_EQ(sizeOf(Value(Value::Map{"s", "i", {{"key", 1}}})), 3 * sizeof(Value) + 3 + 2);
  EXPECT_EQ(sizeOf(Value::dynamic("12345")), 2 * sizeof(Value) + 5);
  EXPECT_EQ(sizeOf(Value::listOf("i<" + std::string(1000, 'x') + ">", {})), sizeof(Value) + 1003);
}

}  // namespace
}  // namespace nao::memory

#include "naoqi_api/services/al_text_to_speech.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "tests/naoqi_api/services/manual_clock.h"

namespace nao::services {
namespace {

using rpc::Value;
using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// 7 characters a word, so half a second each.
constexpr char kTwoWords[] = "Hello, world! ";

class AlTextToSpeechTest : public ::testing::Test {
 protected:
  void listenTo(const std::string& event) {
    tokens_.push_back(memory_.listen("ALTextToSpeech/" + event,
                                     [this, event](const std::string&, const Value& value) {
                                       heard_.push_back(event + " " + value.print());
                                     }));
  }
  rpc::Pending<Value> start(const std::string& method, const std::vector<Value>& arguments) {
    return service_.call(method, arguments);
  }
  // The value of a call that ends at once, or "! " and its error.
  Value call(const std::string& method, const std::vector<Value>& arguments) {
    const auto result = start(method, arguments);
    if (!result.isDone()) return "! still running";
    const auto& outcome = *result.outcome();
    return outcome.error ? Value("! " + *outcome.error) : *outcome.value;
  }
  std::string errorOf(const std::string& method, const std::vector<Value>& arguments) {
    const Value answer = call(method, arguments);
    return answer.findText() ? *answer.findText() : answer.print();
  }

  test::ManualClock clock_;
  memory::MemoryStore memory_{[this] { return clock_.now(); }};
  std::vector<std::string> said_;
  std::unique_ptr<AlTextToSpeech> speech_ = std::make_unique<AlTextToSpeech>(
      memory_,
      [this](Duration delay, std::function<void()> then) {
        clock_.callLater(delay, std::move(then));
      },
      [this](const std::string& text) { said_.push_back(text); });
  rpc::Service service_ = speech_->describe();
  std::vector<std::string> heard_;
  std::vector<std::shared_ptr<void>> tokens_;
};

TEST_F(AlTextToSpeechTest, SayHandsTheTextOnAndEndsAfterAWhile) {
  const auto saying = start("say", {kTwoWords});
  EXPECT_THAT(said_, ElementsAre(kTwoWords));
  clock_.advance(milliseconds(999));
  EXPECT_FALSE(saying.isDone());
  clock_.advance(milliseconds(1));
  ASSERT_TRUE(saying.isDone());
  EXPECT_TRUE(saying.outcome()->value.has_value());
}

TEST_F(AlTextToSpeechTest, RaisesItsEventsInOrder) {
  for (const char* event : {"Status", "TextStarted", "TextDone", "CurrentSentence", "CurrentWord",
                            "PositionOfCurrentWord", "CurrentBookMark", "TextInterrupted"}) {
    listenTo(event);
  }
  const auto saying = start("say", {"Hello, \\mrk=7\\world! "});
  saying.whenDone([this](const auto& /*outcome*/) { heard_.push_back("reply"); });
  EXPECT_THAT(heard_,
              ElementsAre("Status [1, \"enqueued\"]", "Status [1, \"started\"]", "TextDone false",
                          "TextStarted true", "CurrentSentence \"Hello, \\mrk=7\\world! \"",
                          "PositionOfCurrentWord 0", "CurrentWord \"Hello,\""));
  heard_.clear();
  clock_.advance(milliseconds(500));
  EXPECT_THAT(heard_, ElementsAre("CurrentBookMark 7", "PositionOfCurrentWord 1",
                                  "CurrentWord \"world!\""));
  heard_.clear();
  clock_.advance(milliseconds(500));
  EXPECT_THAT(heard_, ElementsAre("CurrentWord \"\"", "CurrentSentence \"\"", "TextStarted false",
                                  "TextDone true", "Status [1, \"done\"]", "reply"));
}

TEST_F(AlTextToSpeechTest, TextsWaitForEachOther) {
  const auto first = start("say", {kTwoWords});
  const auto second = start("say", {"second", "French"});
  EXPECT_THAT(said_, ElementsAre(kTwoWords));
  clock_.advance(seconds(1));
  EXPECT_TRUE(first.isDone());
  EXPECT_FALSE(second.isDone());
  EXPECT_THAT(said_, ElementsAre(kTwoWords, "second"));
  clock_.advance(milliseconds(500));
  EXPECT_TRUE(second.isDone());
}

TEST_F(AlTextToSpeechTest, StopAllEndsWhatIsSaidAndWhatWaits) {
  const auto first = start("say", {kTwoWords});
  const auto second = start("say", {"second"});
  clock_.advance(milliseconds(100));
  listenTo("Status");
  listenTo("TextInterrupted");
  call("stopAll", {});
  EXPECT_TRUE(first.isDone());
  EXPECT_TRUE(second.isDone());
  EXPECT_THAT(heard_, ElementsAre("TextInterrupted true", "Status [1, \"stopped\"]",
                                  "Status [2, \"stopped\"]"));
  heard_.clear();
  clock_.advance(seconds(10));
  EXPECT_THAT(heard_, IsEmpty());
  EXPECT_THAT(said_, ElementsAre(kTwoWords));
}

TEST_F(AlTextToSpeechTest, CancelingOneTextLetsTheNextBegin) {
  const auto first = start("say", {kTwoWords});
  const auto second = start("say", {"second"});
  first.cancel();
  ASSERT_TRUE(first.isDone());
  EXPECT_TRUE(first.outcome()->isCanceled());
  EXPECT_THAT(said_, ElementsAre(kTwoWords, "second"));
  clock_.advance(milliseconds(500));
  EXPECT_TRUE(second.isDone());
}

TEST_F(AlTextToSpeechTest, CancelingAWaitingTextLeavesTheOthers) {
  const auto first = start("say", {kTwoWords});
  const auto second = start("say", {"second"});
  const auto third = start("say", {"third"});
  second.cancel();
  clock_.advance(milliseconds(1500));
  EXPECT_TRUE(first.outcome()->value.has_value());
  EXPECT_TRUE(third.isDone());
  EXPECT_THAT(said_, ElementsAre(kTwoWords, "third"));
}

TEST_F(AlTextToSpeechTest, AListenerMayStopTheTextItHearsOf) {
  const auto token =
      memory_.listen("ALTextToSpeech/CurrentWord", [this](const std::string&, const Value& value) {
        if (value == Value("stop")) call("stopAll", {});
      });
  const auto saying = start("say", {"stop at once and say nothing more"});
  EXPECT_TRUE(saying.isDone());
  const auto next = start("say", {kTwoWords});
  clock_.advance(seconds(1));
  EXPECT_TRUE(next.isDone());
}

TEST_F(AlTextToSpeechTest, AServiceThatIsGoneHasEndedItsCallsAndSaysNoMore) {
  const auto saying = start("say", {kTwoWords});
  const auto waiting = start("say", {"second"});
  speech_.reset();
  EXPECT_TRUE(saying.outcome()->isCanceled());
  EXPECT_TRUE(waiting.outcome()->isCanceled());
  clock_.advance(seconds(10));
  EXPECT_THAT(said_, ElementsAre(kTwoWords));
}

TEST_F(AlTextToSpeechTest, RefusesTooManyAndTooLongTexts) {
  EXPECT_THAT(errorOf("say", {std::string(SpeechQueue::kLongestText + 1, 'x')}),
              HasSubstr("too long"));
  for (std::size_t i = 0; i < SpeechQueue::kMostTasks; ++i) start("say", {"x"});
  EXPECT_THAT(errorOf("say", {"x"}), HasSubstr("too many texts"));
}

TEST_F(AlTextToSpeechTest, TheSpeedParameterCounts) {
  call("setParameter", {"speed", 200.0F});
  const auto saying = start("say", {kTwoWords});
  clock_.advance(milliseconds(500));
  EXPECT_TRUE(saying.isDone());
}

TEST_F(AlTextToSpeechTest, LanguageAndVoiceGoTogether) {
  EXPECT_EQ(call("getLanguage", {}), Value("English"));
  EXPECT_EQ(call("locale", {}), Value("en_US"));
  call("setLanguage", {"French"});
  EXPECT_EQ(call("getLanguage", {}), Value("French"));
  EXPECT_EQ(call("locale", {}), Value("fr_FR"));
  call("setVoice", {"Kenny22Enhanced"});
  EXPECT_EQ(call("getLanguage", {}), Value("English"));
  EXPECT_EQ(call("getVoice", {}), Value("Kenny22Enhanced"));
  call("loadVoicePreference", {"NaoOfficialVoiceEnglish"});
  EXPECT_EQ(call("getVoice", {}), Value("naoenu"));
}

TEST_F(AlTextToSpeechTest, EveryVoiceThatIsListedCanBeSet) {
  for (const auto& voice : call("getAvailableVoices", {}).to<std::vector<std::string>>()) {
    call("setVoice", {voice});
    EXPECT_EQ(call("getVoice", {}), Value(voice));
  }
  for (const auto& language : call("getAvailableLanguages", {}).to<std::vector<std::string>>()) {
    call("setLanguage", {language});
    EXPECT_EQ(call("getLanguage", {}), Value(language));
  }
}

TEST_F(AlTextToSpeechTest, RefusesWhatItDoesNotHave) {
  EXPECT_EQ(call("setLanguage", {"Klingon"}),
            Value("! \tALTextToSpeech::setLanguage\n\tlanguage Klingon is not installed"));
  EXPECT_THAT(errorOf("say", {"nuqneH", "Klingon"}), HasSubstr("Klingon is not installed"));
  EXPECT_THAT(errorOf("setVoice", {"nobody"}), HasSubstr("voice nobody is not installed"));
  EXPECT_THAT(errorOf("setLanguageDefaultVoice", {"French", "naoenu"}),
              HasSubstr("does not speak French"));
  EXPECT_THAT(errorOf("loadVoicePreference", {"Mine"}), HasSubstr("no voice preference Mine"));
  EXPECT_THAT(said_, IsEmpty());
}

TEST_F(AlTextToSpeechTest, KeepsVolumeAndParametersWithinTheirRange) {
  EXPECT_EQ(call("getVolume", {}), Value(1.0F));
  call("setVolume", {0.25F});
  EXPECT_EQ(call("getVolume", {}), Value(0.25F));
  EXPECT_THAT(errorOf("setVolume", {1.5F}), HasSubstr("from 0 to 1, not 1.5"));
  EXPECT_EQ(call("getVolume", {}), Value(0.25F));
  EXPECT_EQ(call("getParameter", {"pitchShift"}), Value(0.0F));
  call("setParameter", {"pitchShift", 1});
  EXPECT_EQ(call("getParameter", {"pitchShift"}), Value(1.0F));
  EXPECT_THAT(errorOf("setParameter", {"doubleVoiceTimeShift", 0.75F}),
              HasSubstr("from 0 to 0.5, not 0.75"));
  EXPECT_THAT(errorOf("getParameter", {"Nope"}), HasSubstr("no parameter Nope"));
}

}  // namespace
}  // namespace nao::services

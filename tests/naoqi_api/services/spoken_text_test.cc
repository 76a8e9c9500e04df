#include "naoqi_api/services/spoken_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace nao::services {
namespace {

using std::chrono::milliseconds;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> wordsOf(const SpokenText& spoken) {
  std::vector<std::string> words;
  for (const auto& word : spoken.words) words.push_back(word.text);
  return words;
}

TEST(SpokenText, CutsWordsAtSpaces) {
  EXPECT_THAT(wordsOf(calcSpokenText("  Hello,  my\nfriend! ")),
              ElementsAre("Hello,", "my", "friend!"));
}

TEST(SpokenText, SaysFourteenCharactersASecond) {
  const SpokenText spoken = calcSpokenText("seven7 seven7 seven7 seven7 ");
  EXPECT_EQ(spoken.length, std::chrono::seconds(2));
  ASSERT_EQ(spoken.words.size(), 4U);
  EXPECT_EQ(spoken.words[0].start, Duration());
  EXPECT_EQ(spoken.words[1].start, milliseconds(500));
  EXPECT_EQ(spoken.words[3].start, milliseconds(1500));
}

TEST(SpokenText, TakesHalfASecondAtLeast) {
  EXPECT_EQ(calcSpokenText("").length, milliseconds(500));
  EXPECT_EQ(calcSpokenText("Hi").length, milliseconds(500));
}

TEST(SpokenText, SpeedShortensIt) {
  const std::string text(28, 'x');
  EXPECT_EQ(calcSpokenText(text, 2).length, std::chrono::seconds(1));
}

TEST(SpokenText, CountsCharactersNotBytes) {
  EXPECT_EQ(calcSpokenText("\u00e9\u00e9\u00e9\u00e9\u00e9\u00e9\u00e9"
                           "\u00e9\u00e9\u00e9\u00e9\u00e9\u00e9\u00e9")
                .length,
            std::chrono::seconds(1));
}

TEST(SpokenText, TagsAreNotSpoken) {
  const SpokenText spoken = calcSpokenText("\\vct=120\\seven7 \\pau=1000\\seven7 \\mrk=5\\end");
  EXPECT_THAT(wordsOf(spoken), ElementsAre("seven7", "seven7", "end"));
  EXPECT_EQ(spoken.words[1].start, milliseconds(1500));
  ASSERT_EQ(spoken.marks.size(), 1U);
  EXPECT_EQ(spoken.marks[0].number, 5);
  EXPECT_EQ(spoken.marks[0].start, milliseconds(2000));
}

TEST(SpokenText, ATagChangesTheSpeedFromThereOn) {
  const SpokenText spoken = calcSpokenText("seven7 \\rspd=200\\seven7 seven7 ");
  EXPECT_EQ(spoken.words[1].start, milliseconds(500));
  EXPECT_EQ(spoken.words[2].start, milliseconds(750));
}

TEST(SpokenText, BrokenTagsAreTextOrHarmless) {
  EXPECT_THAT(wordsOf(calcSpokenText("a \\b c")), ElementsAre("a", "\\b", "c"));
  EXPECT_THAT(wordsOf(calcSpokenText("\\")), ElementsAre("\\"));
  EXPECT_THAT(wordsOf(calcSpokenText("\\pau=nan\\")), IsEmpty());
  EXPECT_EQ(calcSpokenText("\\pau=-5\\").length, milliseconds(500));
  EXPECT_EQ(calcSpokenText("\\pau=1e300\\").length, std::chrono::seconds(60));
  EXPECT_EQ(calcSpokenText("\\mrk=1e300\\").marks.front().number, 65535);
}

}  // namespace
}  // namespace nao::services

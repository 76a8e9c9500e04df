#include "validation/diagnosis/jobs/team.h"

#include <gtest/gtest.h>

#include "core/check.h"
#include "tests/validation/diagnosis/thread_team.h"

namespace nao::validation {
namespace {

using test::ThreadTeam;

TEST(Team, EveryProcessKnowsAllAnswersInTheirOrder) {
  for (const std::size_t size : {1u, 2u, 3u, 7u}) {
    std::vector<std::vector<std::string>> known(size);
    std::vector<int> asked(5, 0);
    ThreadTeam::run(size, [&](const Team& team) {
      known[team.rank()] = askAll(team, "squares", 5, 2, [&](std::size_t i) {
        ++asked[i];
        return std::to_string(i * i);
      });
    });
    for (const auto& answers : known) {
      EXPECT_EQ(answers, (std::vector<std::string>{"0", "1", "4", "9", "16"}));
    }
    EXPECT_EQ(asked, std::vector<int>(5, 1));  // nobody does what another does
  }
}

TEST(Team, TheFirstDecides) {
  ThreadTeam::run(3, [](const Team& team) {
    EXPECT_EQ(askFirst(team, "who", [&] { return std::to_string(team.rank()); }), "0");
  });
}

TEST(Team, NoticesThatItHasComeApart) {
  ThreadTeam::run(2, [](const Team& team) {
    const std::string question = team.rank() == 0 ? "one" : "two";
    EXPECT_THROW(askAll(team, question, 2, 1, [](std::size_t) { return ""; }), InputError);
  });
}

}  // namespace
}  // namespace nao::validation

// Where a world ends that goes as far as its LoLA programs have ordered: a function of what they
// did, whenever that is seen.
#include <gtest/gtest.h>

#include <chrono>

#include "tests/daemon/lola_daemon.h"

namespace nao::daemon {
namespace {

using std::chrono_literals::operator""ms;

constexpr int kTimes = 10;  // each race is run so often; every end must be the same

class LolaEndTest : public LolaServerTest {
 protected:
  Options toTheEnd() const {
    Options options = lockstep();
    options.lola_to_the_end = true;
    return options;
  }

  static void answer(LolaClient& client, int frames) {
    for (int k = 0; k < frames; ++k) {
      client.receive();
      client.send(drive(0.01F * static_cast<float>(k)));
    }
  }

  // The cycle of a client's coming and one for each of its answers.
  static SimTime endOf(int answers) { return SimTime((answers + 1) * 12ms); }
};

TEST_F(LolaEndTest, WhatWasSentBeforeTheEndIsDone) {
  std::uint64_t state = 0;
  for (int k = 0; k < kTimes; ++k) {
    LolaDaemon daemon(toTheEnd());
    {
      LolaClient client(path_);
      answer(client, 5);
    }
    const LoopState end = daemon.stop();
    EXPECT_EQ(end.time, endOf(5));
    if (k == 0) state = end.hash;
    EXPECT_EQ(end.hash, state);
  }
}

TEST_F(LolaEndTest, WhoClosesLateOrNeverChangesNothing) {
  for (const bool reads : {false, true}) {
    LolaDaemon daemon(toTheEnd());
    LolaClient client(path_);
    answer(client, 5);
    if (reads) client.receive();
    EXPECT_EQ(daemon.stop().time, endOf(5));
  }
}

TEST_F(LolaEndTest, WhoComesAndGoesIsFollowedByACycleSeenOrNot) {
  for (int k = 0; k < kTimes; ++k) {
    LolaDaemon daemon(toTheEnd());
    {
      LolaClient client(path_);
      client.send(drive(0.5F));  // before any frame: it answers none
    }
    EXPECT_EQ(daemon.stop().time, endOf(0));
  }
}

TEST_F(LolaEndTest, WhereNobodyCameTimeHasNotBegun) {
  LolaDaemon daemon(toTheEnd());
  EXPECT_EQ(daemon.stop().time, SimTime());
}

TEST_F(LolaEndTest, AnAnswerIsFollowedBeforeTheNextClientIs) {
  for (int k = 0; k < kTimes; ++k) {
    LolaDaemon daemon(toTheEnd());
    {
      LolaClient first(path_);
      answer(first, 5);
    }
    LolaClient second(path_);
    answer(second, 3);
    EXPECT_EQ(daemon.stop().time, endOf(5 + 1 + 3));
  }
}

TEST_F(LolaEndTest, TimeGoesOnForWhoIsStillThere) {
  Options options = toTheEnd();
  options.robots = {{"short", "nao_h25_v60", {}}, {"long", "nao_h25_v60", {}}};
  options.lola = {{"short", path_ + "_short"}, {"long", path_}};
  LolaDaemon daemon(options);
  LolaClient longer(path_);
  {
    LolaClient shorter(path_ + "_short");
    for (int k = 0; k < 3; ++k) {
      answer(shorter, 1);
      answer(longer, 1);
    }
  }
  answer(longer, 7);
  EXPECT_EQ(daemon.stop().time, endOf(10));
}

TEST_F(LolaEndTest, SeveralSendsForOneFrameLetOneCyclePass) {
  LolaDaemon daemon(toTheEnd());
  LolaClient client(path_);
  for (int k = 0; k < 50; ++k) {
    client.receive();
    client.send(drive(0.5F));
    client.send({{"Skull", LolaClient::list(1, 12)}});
  }
  answer(client, 1);
  EXPECT_EQ(daemon.stop().time, endOf(51));
}

}  // namespace
}  // namespace nao::daemon

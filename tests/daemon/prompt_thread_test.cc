#include "daemon/prompt_thread.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>

#include <thread>

namespace nao::daemon {
namespace {

// In a thread of its own: rules of a thread end with it.
template <class Work>
void inAThread(const Work& work) {
  std::thread(work).join();
}

TEST(PromptThread, KeepsPolicyAndNicenessAndMayBeAskedTwice) {
  inAThread([] {
    const int policy = sched_getscheduler(0);
    const int nice = getpriority(PRIO_PROCESS, 0);
    const bool first = makeThreadPrompt();
    EXPECT_EQ(makeThreadPrompt(), first);
    EXPECT_EQ(sched_getscheduler(0), policy);
    EXPECT_EQ(getpriority(PRIO_PROCESS, 0), nice);
  });
}

TEST(PromptThread, LeavesAThreadAloneThatRunsByOtherRules) {
  inAThread([] {
    const sched_param none{};
    ASSERT_EQ(sched_setscheduler(0, SCHED_BATCH, &none), 0);
    EXPECT_FALSE(makeThreadPrompt());
    EXPECT_EQ(sched_getscheduler(0), SCHED_BATCH);
  });
}

}  // namespace
}  // namespace nao::daemon

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "runtime/simulation.h"
#include "tests/support/models.h"

namespace nao::runtime {
namespace {

using std::chrono_literals::operator""ms;

double residentBytes() {
  std::ifstream statm("/proc/self/statm");
  double total = 0;
  double resident = 0;
  statm >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

// How an engine for learning uses it: back, a few steps, back again.
TEST(SnapshotMemory, StaysOver100000Restores) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer keeps what is freed";
#endif
  constexpr int kRestores = 100'000;
  constexpr double kGrowth = 1e6;  // [bytes] 10 a restore: no object is that small, and the
                                   // allocator's arenas may still round by some hundred KB
  Simulation simulation(test::flatWorld(), {{"nao", test::robot("nao_h21_v33"), {}}}, 2ms);
  auto& ports = *simulation.robot(0).ports();
  ASSERT_TRUE(ports.requests.post({1, motion::WakeUp{}}));
  simulation.advanceTo(SimTime(4000ms));
  ASSERT_TRUE(ports.requests.post({2, motion::MoveToward{1, 0, 0, {}}}));
  simulation.advanceTo(SimTime(6000ms));
  const auto snapshot = simulation.snapshot();
  const std::uint64_t hash = simulation.hash();

  motion::RequestId id = 2;
  double before = 0;
  for (int k = 0; k < kRestores + 1000; ++k) {
    if (k == 1000) before = residentBytes();  // buffers have their size by then
    ASSERT_TRUE(ports.requests.post({++id, motion::MoveTo{{0.2, 0, 0}, {}, {}}}));
    simulation.advanceTo(simulation.now() + 2ms);
    simulation.restore(*snapshot);
    ports.outcomes.drain();
  }
  EXPECT_LT(residentBytes() - before, kGrowth);
  EXPECT_EQ(simulation.hash(), hash);
}

}  // namespace
}  // namespace nao::runtime

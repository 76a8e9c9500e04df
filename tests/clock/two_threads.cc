// A client of two threads that share a condition: one watches a joint, the other moves it.
#include <alproxies/almemoryproxy.h>
#include <alproxies/almotionproxy.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

const Clock::time_point start = Clock::now();
std::mutex mutex;
std::condition_variable changed;
std::vector<float> seen;
bool over = false;

double now() { return std::chrono::duration<double>(Clock::now() - start).count(); }

void watch(const std::string& host, int port) {
  AL::ALMemoryProxy memory(host, port);
  for (bool more = true; more;) {
    const float angle = memory.getData("Device/SubDeviceList/HeadYaw/Position/Sensor/Value");
    std::unique_lock<std::mutex> lock(mutex);
    seen.push_back(angle);
    changed.notify_one();
    more = !changed.wait_for(lock, std::chrono::milliseconds(17), [] { return over; });
  }
}

}  // namespace

int main(int argc, char* argv[]) {
  const std::string host = argc > 1 ? argv[1] : "127.0.0.1";
  const int port = argc > 2 ? std::atoi(argv[2]) : 9559;
  AL::ALMotionProxy motion(host, port);
  motion.setStiffnesses("Head", 1.0f);
  std::thread watcher(watch, host, port);
  for (int step = 0; step < 30; ++step) {
    motion.setAngles("HeadYaw", step % 10 < 5 ? 0.5f : -0.5f, 0.5f);
    std::unique_lock<std::mutex> lock(mutex);
    changed.wait(lock, [] { return !seen.empty(); });
    std::printf("%.4f %d %zu %.9g\n", now(), step, seen.size(), seen.back());
    seen.clear();
    lock.unlock();
    std::this_thread::sleep_for(std::chrono::milliseconds(43));
  }
  {
    const std::lock_guard<std::mutex> lock(mutex);
    over = true;
  }
  changed.notify_one();
  watcher.join();
  std::printf("%.4f end\n", now());
  return 0;
}

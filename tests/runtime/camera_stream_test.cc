// A minute of a camera's pictures, to the last bit.

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "runtime/simulation.h"

namespace nao::runtime {
namespace {

const std::string kSource = NAO_SOURCE_DIR;

/// A field on which a ball rolls past a robot that is pushed over, watched by both its cameras.
struct Minute {
  explicit Minute(camera::ImageSize size = {160, 120})
      : simulation(loadWorldModel(kSource + "/worlds/field_2011.yaml"),
                   {{"a", loadRobotModel(kSource + "/robots", "nao_h25_v50"), {}},
                    {"b", loadRobotModel(kSource + "/robots", "nao_h21_v33"), {1.2, 0.4, 2}}},
                   std::chrono::milliseconds(2)) {
    for (const int camera : {0, 1}) {
      ids.push_back(feed->subscribe({camera, size, camera::ColorSpace::kYUV422, 30}));
    }
    simulation.showTo(queue, 0);
  }

  /// Each 40 ms at most one picture of either is due, so none is overwritten unseen.
  template <class Wait>
  std::uint64_t run(const Wait& wait) {
    std::uint64_t hash = 0;
    std::vector<std::shared_ptr<const camera::Image>> last(2);
    for (int ms = 0; ms < 60000; ms += 20) {
      if (ms % 5000 == 0) simulation.world().placeBall(0, {1, -1, 0.0325}, {0.1, 0.8, 0});
      if (ms == 20000) simulation.world().push(0, {30, 0, 0}, std::chrono::milliseconds(200));
      simulation.advanceTo(SimTime(std::chrono::milliseconds(ms + 20)));
      wait();
      for (std::size_t i = 0; i < 2; ++i) {
        const auto image = feed->latest(ids[i]);
        if (!image || image == last[i]) continue;
        last[i] = image;
        hash = hash * 31 + image->hash();
        ++pictures;
      }
    }
    return hash;
  }

  std::uint64_t runAlone() {
    camera::Renderer renderer;
    return run([&] {
      while (queue->renderNext(renderer)) {
      }
    });
  }

  std::uint64_t runWithThread() {
    std::atomic<bool> stop = false;
    std::thread thread([&] {
      camera::Renderer renderer;
      while (!stop) {
        if (!queue->renderNext(renderer)) std::this_thread::yield();
      }
    });
    const std::uint64_t hash = run([&] {
      while (queue->pendingJobs() > 0) std::this_thread::yield();  // as a pacer at maximum speed
    });
    stop = true;
    thread.join();
    return hash;
  }

  std::shared_ptr<camera::ImageFeed> feed = std::make_shared<camera::ImageFeed>();
  std::shared_ptr<camera::RenderQueue> queue = std::make_shared<camera::RenderQueue>(feed);
  Simulation simulation;
  std::vector<std::uint64_t> ids;
  int pictures = 0;
};

TEST(CameraStream, AMinuteIsTheSameAgain) {
  Minute first, second;
  const std::uint64_t hash = first.runAlone();
  EXPECT_EQ(first.pictures, 2 * (1 + 60 * 30));  // the first at once, then k = 1 ... 1800
  EXPECT_EQ(second.runAlone(), hash);
}

TEST(CameraStream, AMinuteInFullSizeIsTheSameOnAThreadOfItsOwn) {
  Minute alone({640, 480}), threaded({640, 480});
  EXPECT_EQ(threaded.runWithThread(), alone.runAlone());
  EXPECT_EQ(threaded.pictures, 2 * (1 + 60 * 30));
  EXPECT_EQ(threaded.queue->droppedImages(), 0);
}

/// The pictures of both cameras from one time to another.
std::vector<std::uint64_t> watch(Minute& minute, int from_ms, int to_ms) {
  camera::Renderer renderer;
  std::vector<std::uint64_t> hashes;
  for (int ms = from_ms; ms < to_ms; ms += 20) {
    minute.simulation.advanceTo(SimTime(std::chrono::milliseconds(ms + 20)));
    while (minute.queue->renderNext(renderer)) {
    }
    for (const std::uint64_t id : minute.ids) {
      const auto image = minute.feed->latest(id);
      hashes.push_back(image ? image->hash() : 0);
    }
  }
  return hashes;
}

// The robot falls, from the field to the hall's sky and back: exposure is on its way all the time.
TEST(CameraStream, PicturesAfterARestoredSnapshotAreTheSameAgain) {
  Minute minute;
  watch(minute, 0, 1000);
  minute.simulation.world().push(0, {60, 20, 0}, std::chrono::milliseconds(300));
  watch(minute, 1000, 1500);
  const auto snapshot = minute.simulation.snapshot();
  const auto first = watch(minute, 1500, 3500);
  minute.simulation.restore(*snapshot);
  EXPECT_EQ(watch(minute, 1500, 3500), first);
}

}  // namespace
}  // namespace nao::runtime

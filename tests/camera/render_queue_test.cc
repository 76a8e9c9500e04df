#include "camera/render_queue.h"

#include <gtest/gtest.h>

#include <thread>

#include "tests/camera/scenes.h"

namespace nao::camera {
namespace {

constexpr Duration kStep = std::chrono::milliseconds(2);

std::shared_ptr<const SceneFrame> sceneAt(SimTime time) {
  auto scene = std::make_shared<SceneFrame>(fieldScene());
  scene->time = time;
  scene->robots.push_back(simpleRobot("a", translation({-1, 0, 0.32})));
  return scene;
}

ImageRequest request(int frame_rate, ColorSpace space = ColorSpace::kYUV422) {
  return {0, {40, 30}, space, frame_rate};
}

/// A robot's pictures without a thread: what is due is drawn at once.
struct Studio {
  std::shared_ptr<ImageFeed> feed = std::make_shared<ImageFeed>();
  RenderQueue queue{feed};
  Renderer renderer;

  /// Steps from after `from` to `to`; returns the times at which something was due.
  std::vector<SimTime> run(SimTime from, SimTime to) {
    std::vector<SimTime> times;
    for (SimTime now = from + kStep; now <= to; now += kStep) {
      if (!queue.anyDue(now)) continue;
      times.push_back(now);
      EXPECT_TRUE(queue.offer(sceneAt(now), 0));
      while (queue.renderNext(renderer)) {
      }
    }
    return times;
  }
};

constexpr SimTime at(double seconds) { return SimTime(fromSeconds(seconds)); }

TEST(RenderQueue, NothingIsDueWhileNobodyLooks) {
  Studio studio;
  EXPECT_FALSE(studio.queue.anyDue(at(1)));
  const auto id = studio.feed->subscribe(request(30));
  studio.feed->unsubscribe(id);
  EXPECT_FALSE(studio.queue.anyDue(at(2)));
}

TEST(RenderQueue, ThirtyPicturesASecondAtTheStepsAfterTheirTimes) {
  Studio studio;
  studio.feed->subscribe(request(30));
  const std::vector<SimTime> times = studio.run(at(0), at(2));
  // The first at once, then k = 1 ... 60.
  ASSERT_EQ(times.size(), 61u);
  EXPECT_EQ(times[0], at(0.002));
  for (int k = 1; k <= 60; ++k) {
    const double exact = k / 30.0;
    EXPECT_GE(toSeconds(times[k]), exact - 1e-9) << k;
    EXPECT_LT(toSeconds(times[k]), exact + 0.002) << k;
  }
  EXPECT_EQ(times[30], at(1));  // 30 whole intervals, no drift
}

TEST(RenderQueue, EveryRateGivesItsNumberOfPictures) {
  for (const int rate : {1, 5, 7, 10, 15, 30}) {
    Studio studio;
    studio.feed->subscribe(request(rate));
    EXPECT_EQ(studio.run(at(0), at(0.002)).size(), 1u) << rate;
    EXPECT_EQ(studio.run(at(0.002), at(3)).size(), 3u * rate) << rate;
  }
}

TEST(RenderQueue, APictureShowsTheSceneOfItsTime) {
  Studio studio;
  const auto id = studio.feed->subscribe(request(10));
  EXPECT_EQ(studio.feed->latest(id), nullptr);
  studio.run(at(5), at(5.1));
  const auto image = studio.feed->latest(id);
  ASSERT_NE(image, nullptr);
  EXPECT_EQ(image->time, at(5.1));
  EXPECT_EQ(image->size, (ImageSize{40, 30}));
  EXPECT_EQ(image->bytes->size(), 40u * 30 * 2);
}

TEST(RenderQueue, EqualWishesShareOnePicture) {
  Studio studio;
  const auto a = studio.feed->subscribe(request(30));
  const auto b = studio.feed->subscribe(request(10));
  const auto c = studio.feed->subscribe(request(10, ColorSpace::kRGB));
  studio.run(at(0), at(0.1));
  EXPECT_EQ(studio.feed->latest(a), studio.feed->latest(b));
  EXPECT_EQ(studio.feed->latest(c)->time, at(0.1));
  EXPECT_EQ(studio.feed->latest(c)->bytes->size(), 40u * 30 * 3);
}

TEST(RenderQueue, ALateSubscriberGetsAPictureAtTheNextStep) {
  Studio studio;
  studio.feed->subscribe(request(5));
  studio.run(at(0), at(0.25));
  const auto late = studio.feed->subscribe(request(1));
  const std::vector<SimTime> times = studio.run(at(0.25), at(0.39));
  EXPECT_EQ(times, std::vector<SimTime>{at(0.252)});
  EXPECT_NE(studio.feed->latest(late), nullptr);
}

TEST(RenderQueue, AFullQueueDropsAndCounts) {
  const auto feed = std::make_shared<ImageFeed>();
  RenderQueue queue(feed, 2);
  feed->subscribe(request(10));
  feed->subscribe(request(10, ColorSpace::kRGB));
  EXPECT_TRUE(queue.offer(sceneAt(at(0)), 0));
  EXPECT_TRUE(queue.offer(sceneAt(at(0.1)), 0));
  EXPECT_EQ(queue.pendingJobs(), 2u);
  EXPECT_FALSE(queue.offer(sceneAt(at(0.2)), 0));
  EXPECT_EQ(queue.droppedImages(), 2);
  Renderer renderer;
  EXPECT_TRUE(queue.renderNext(renderer));
  EXPECT_EQ(queue.pendingJobs(), 1u);
  EXPECT_TRUE(queue.offer(sceneAt(at(0.3)), 0));
}

TEST(RenderQueue, NothingIsQueuedBeforeItsTime) {
  const auto feed = std::make_shared<ImageFeed>();
  RenderQueue queue(feed);
  feed->subscribe(request(10));
  queue.offer(sceneAt(at(0)), 0);
  EXPECT_TRUE(queue.offer(sceneAt(at(0.05)), 0));
  EXPECT_EQ(queue.pendingJobs(), 1u);
}

TEST(RenderQueue, PicturesGoOnWhenTimeStartsOver) {
  Studio studio;
  const auto id = studio.feed->subscribe(request(10));
  studio.run(at(10), at(11));
  studio.run(at(0), at(0.05));
  EXPECT_EQ(studio.feed->latest(id)->time, at(0.002));
}

TEST(RenderQueue, AnotherThreadDrawsTheSamePictures) {
  Studio alone;
  const auto wanted = alone.feed->subscribe(request(30));
  alone.run(at(0), at(1));

  const auto feed = std::make_shared<ImageFeed>();
  const auto id = feed->subscribe(request(30));
  RenderQueue queue(feed);
  constexpr int kJobs = 31;
  std::thread camera([&] {
    Renderer renderer;
    for (int done = 0; done < kJobs;) done += queue.renderNext(renderer) ? 1 : 0;
  });
  for (SimTime now = at(0.002); now <= at(1); now += kStep) {
    if (!queue.anyDue(now)) continue;
    while (queue.pendingJobs() > 0) std::this_thread::yield();  // as a pacer at maximum speed
    EXPECT_TRUE(queue.offer(sceneAt(now), 0));
  }
  camera.join();
  EXPECT_EQ(queue.droppedImages(), 0);
  EXPECT_EQ(feed->latest(id)->hash(), alone.feed->latest(wanted)->hash());
  EXPECT_EQ(feed->latest(id)->time, at(1));
}

TEST(ImageFeed, UnknownSubscriptionsAreNull) {
  ImageFeed feed;
  EXPECT_EQ(feed.latest(1), nullptr);
  EXPECT_FALSE(feed.unsubscribe(1));
  const auto id = feed.subscribe(request(5));
  EXPECT_TRUE(feed.unsubscribe(id));
  EXPECT_FALSE(feed.unsubscribe(id));
  EXPECT_EQ(feed.latest(id), nullptr);
}

}  // namespace
}  // namespace nao::camera

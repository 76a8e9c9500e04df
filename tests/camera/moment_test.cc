// A moment of a render queue brings back what its cameras and their clients were at.

#include <gtest/gtest.h>

#include "camera/render_queue.h"
#include "tests/camera/scenes.h"

namespace nao::camera {
namespace {

constexpr SimTime at(double seconds) { return SimTime(fromSeconds(seconds)); }
constexpr Duration kStep = std::chrono::milliseconds(2);

/// A hall whose lights go down for a second and up again, so that automatic exposure is always
/// somewhere else, watched by a camera that has it.
std::shared_ptr<const SceneFrame> sceneAt(SimTime time) {
  auto scene = std::make_shared<SceneFrame>(fieldScene());
  scene->time = time;
  const double phase = std::fmod(toSeconds(time), 2.0);
  worldOf(*scene).light = phase < 1 ? 1 - 0.8 * phase : 0.2 + 0.8 * (phase - 1);
  SceneFrame::Robot robot = simpleRobot("a", translation({-1, 0, 0.32}));
  RobotModel model = *robot.model;
  model.version = "V5.0";
  model.cameras[0].effects.response = model.cameras[0].effects.noise = true;
  robot.model = std::make_shared<const RobotModel>(model);
  scene->robots.push_back(robot);
  return scene;
}

struct Studio {
  std::shared_ptr<ImageFeed> feed = std::make_shared<ImageFeed>();
  RenderQueue queue{feed};
  Renderer renderer;
  std::uint64_t id = feed->subscribe({0, {40, 30}, ColorSpace::kRGB, 10});

  void offer(SimTime now) {
    if (queue.anyDue(now)) {
      EXPECT_TRUE(queue.offer(sceneAt(now), 0));
    }
  }
  void draw() {
    while (queue.renderNext(renderer)) {
    }
  }
  /// Steps from after `from` to `to`; the hashes of the pictures that come.
  std::vector<std::uint64_t> run(SimTime from, SimTime to) {
    std::vector<std::uint64_t> hashes;
    auto last = feed->latest(id);
    for (SimTime now = from + kStep; now <= to; now += kStep) {
      offer(now);
      draw();
      const auto image = feed->latest(id);
      if (image != last) hashes.push_back(image->hash());
      last = image;
    }
    return hashes;
  }
};

TEST(Moment, TheSamePicturesFollowIt) {
  Studio studio;
  studio.run(at(0), at(0.55));
  const auto moment = studio.queue.moment();
  const auto first = studio.run(at(0.55), at(3));
  EXPECT_EQ(first.size(), 25u);
  studio.queue.restore(moment);
  studio.draw();
  EXPECT_EQ(studio.run(at(0.55), at(3)), first);
}

// That it matters: a camera that starts then has adapted to the light of then.
TEST(Moment, WithoutItPicturesDiffer) {
  Studio studio;
  studio.run(at(0), at(0.55));
  const auto first = studio.run(at(0.55), at(1));
  studio.queue.restore(nullptr);
  studio.draw();
  auto again = studio.run(at(0.55), at(1));
  ASSERT_EQ(again.size(), first.size() + 1);  // the first one at once
  again.erase(again.begin());
  EXPECT_NE(again, first);
}

TEST(Moment, ItsPictureIsSeenAgainAtOnce) {
  Studio studio;
  studio.run(at(0), at(1.05));
  const auto seen = studio.feed->latest(studio.id);
  const auto moment = studio.queue.moment();
  studio.run(at(1.05), at(2));
  ASSERT_NE(studio.feed->latest(studio.id), seen);
  studio.queue.restore(moment);
  EXPECT_EQ(studio.feed->latest(studio.id), seen);
}

TEST(Moment, PicturesNotYetDrawnThenAreDrawn) {
  Studio studio;
  studio.run(at(0), at(0.95));
  studio.offer(at(1));  // and nobody draws it
  const auto moment = studio.queue.moment();
  const auto first = studio.run(at(1), at(2));
  studio.offer(at(2.1));  // of a time that is left: drawn or not, it does not matter
  studio.queue.restore(moment);
  EXPECT_EQ(studio.run(at(1), at(2)), first);
  EXPECT_EQ(studio.queue.pendingJobs(), 0u);
}

TEST(Moment, RestoredAgainAndAgainWhileNobodyDrawsItIsStillThatMoment) {
  Studio studio;
  studio.run(at(0), at(0.55));
  const auto moment = studio.queue.moment();
  const auto first = studio.run(at(0.55), at(1));
  for (int i = 0; i < 100; ++i) studio.queue.restore(moment);
  while (studio.queue.pendingJobs() > 0) studio.draw();
  EXPECT_EQ(studio.run(at(0.55), at(1)), first);
}

TEST(Moment, AnotherQueueGoesOnFromIt) {
  Studio studio;
  studio.run(at(0), at(0.5));
  const auto moment = studio.queue.moment();
  const auto shown = studio.feed->latest(studio.id);
  const auto first = studio.run(at(0.5), at(2));
  Studio other;
  other.queue.restore(moment);
  other.draw();
  EXPECT_EQ(other.feed->latest(other.id), nullptr);  // its client has seen nothing yet
  // From the first instant that both see on.
  EXPECT_EQ(other.run(at(0.598), at(2)), first);
  EXPECT_NE(shown, nullptr);
}

TEST(Moment, WhoSubscribedSinceGetsAPictureAtOnce) {
  Studio studio;
  studio.run(at(0), at(0.55));
  const auto moment = studio.queue.moment();
  const auto late = studio.feed->subscribe({0, {40, 30}, ColorSpace::kYuv, 10});
  studio.queue.restore(moment);
  studio.run(at(0.55), at(0.552));
  ASSERT_NE(studio.feed->latest(late), nullptr);
  EXPECT_EQ(studio.feed->latest(late)->time, at(0.552));
}

}  // namespace
}  // namespace nao::camera

// Pictures for LoLA programs, as they reach them: on a port, and in shared memory.
#include "daemon/lola_cameras.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <set>
#include <thread>

#include "core/check.h"
#include "daemon/daemon.h"
#include "daemon/picture_ring.h"
#include "tests/core/temporary_folder.h"
#include "tests/daemon/lola_client.h"
#include "tests/daemon/picture_ring_reader.h"
#include "tests/daemon/running_daemon.h"

namespace nao::daemon {
namespace {

using boost::asio::ip::tcp;
using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""ns;

constexpr std::size_t kPixels = 640 * 480 * 2;  // bytes

/// A name of shared memory that no other process uses.
std::string ownName(const std::string& what) {
  return "nao_test_" + std::to_string(::getpid()) + "_" + what;
}

class LolaCamerasTest : public testing::Test {
 protected:
  Options options() const {
    Options options = optionsFor({});
    options.world = NAO_SOURCE_DIR "/worlds/field_2020.yaml";
    options.robots = {{"nao", "nao_h25_v60", {}}};
    options.lola = {{"", folder_.path() + "/robocup"}};
    options.lola_camera_port = 0;
    return options;
  }

  TemporaryFolder folder_;
};

struct Picture {
  std::vector<std::uint8_t> header = std::vector<std::uint8_t>(16);
  std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(kPixels);
  int number(std::size_t at) const { return header[at] + 256 * header[at + 1]; }
};

Picture receive(tcp::socket& socket) {
  Picture picture;
  boost::asio::read(socket, boost::asio::buffer(picture.header));
  boost::asio::read(socket, boost::asio::buffer(picture.pixels));
  return picture;
}

TEST_F(LolaCamerasTest, EachCameraSendsWholePicturesWithTheirHeader) {
  Options options = this->options();
  options.speed = 1;  // as fast as it goes, a limp robot may have fallen on its face by now
  Daemon daemon(options);
  std::thread thread([&] { daemon.run(); });
  boost::asio::io_context io;
  ASSERT_EQ(daemon.lolaCameraPorts(0).size(), 2U);
  for (std::uint8_t camera = 0; camera < 2; ++camera) {
    tcp::socket socket(io);
    socket.connect({boost::asio::ip::make_address("127.0.0.1"), daemon.lolaCameraPorts(0)[camera]});
    std::vector<int> ticks;
    for (int k = 0; k < 3; ++k) {
      const Picture picture = receive(socket);
      EXPECT_EQ(std::string(picture.header.begin(), picture.header.begin() + 8),
                std::string("wbimage\0", 8));
      EXPECT_EQ(picture.header[10], camera);
      EXPECT_EQ(picture.header[11], 2);
      EXPECT_EQ(picture.number(12), 640);
      EXPECT_EQ(picture.number(14), 480);
      ticks.push_back(picture.number(8));
      const std::set<std::uint8_t> values(picture.pixels.begin(), picture.pixels.end());
      EXPECT_GT(values.size(), 4U);  // it sees something
    }
    // The first one comes as soon as there is a viewer, the others every 33 ms.
    EXPECT_GE(ticks[1], ticks[0]);
    EXPECT_GE(ticks[2], ticks[1] + 2);
  }
  daemon.stop();
  thread.join();
}

TEST_F(LolaCamerasTest, PicturesAreInSharedMemoryWithTheirTimes) {
  Options options = this->options();
  options.lola_camera_port.reset();
  options.lola_camera_memory = ownName("daemon");
  options.lola_lockstep = 60;
  {
    Daemon daemon(options);
    std::thread thread([&] { daemon.run(); });
    LolaClient client(options.lola.front().path);
    const PictureRingReader top(options.lola_camera_memory + ".nao.top");
    const PictureRingReader bottom(options.lola_camera_memory + ".nao.bottom");
    for (int k = 0; k < 10000 && (top.newest() < 3 || bottom.newest() < 3); ++k) {
      client.receive();
      client.send({{"Stiffness", LolaClient::list(0)}});
    }
    const auto second = top.read(2);
    const auto third = top.read(3);
    ASSERT_TRUE(second && third);
    EXPECT_EQ(third->pixels.size(), kPixels);
    EXPECT_EQ(third->camera, 0U);
    EXPECT_EQ(bottom.read(3)->camera, 1U);
    EXPECT_GT(third->time, second->time);
    daemon.stop();
    thread.join();
  }
  EXPECT_THROW(PictureRingReader(options.lola_camera_memory + ".nao.top"), std::runtime_error);
}

camera::Image imageOf(std::uint8_t value, SimTime time) {
  camera::Image image;
  image.size = {16, 8};
  image.color_space = camera::ColorSpace::kYUV422;
  image.time = time;
  image.bytes = std::make_shared<const camera::Bytes>(16U * 8U * 2U, value);
  return image;
}

TEST(PictureRing, KeepsTheNewestPictures) {
  const std::string name = ownName("keeps");
  PictureRing ring(name, {16, 8}, camera::ColorSpace::kYUV422);
  const PictureRingReader reader(name);
  EXPECT_EQ(reader.newest(), 0U);
  EXPECT_FALSE(reader.read(0));
  for (std::uint8_t k = 1; k <= 10; ++k) ring.write(imageOf(k, SimTime(k * 1ms)), 1);
  EXPECT_EQ(reader.newest(), 10U);
  EXPECT_FALSE(reader.read(2));  // overwritten by the tenth
  for (std::uint64_t k = 3; k <= 10; ++k) {
    const auto picture = reader.read(k);
    ASSERT_TRUE(picture) << k;
    EXPECT_EQ(picture->pixels, std::vector<std::uint8_t>(256, static_cast<std::uint8_t>(k)));
    EXPECT_EQ(picture->time, k * 1000000);
  }
}

TEST(PictureRing, AReaderNeverGetsAPictureHalfOverwritten) {
  const std::string name = ownName("race");
  PictureRing ring(name, {16, 8}, camera::ColorSpace::kYUV422);
  const PictureRingReader reader(name);
  std::thread writer([&] {
    for (int k = 1; k <= 100000; ++k)
      ring.write(imageOf(static_cast<std::uint8_t>(k % 251), SimTime(k * 1ns)), 0);
  });
  int whole = 0;
  while (reader.newest() < 100000) {
    const auto picture = reader.read(reader.newest());
    if (!picture) continue;
    ++whole;
    ASSERT_EQ(picture->pixels,
              std::vector<std::uint8_t>(256, static_cast<std::uint8_t>(picture->number % 251)));
    ASSERT_EQ(picture->time, picture->number);
  }
  writer.join();
  EXPECT_TRUE(reader.read(100000)) << whole;
}

TEST(PictureRing, OneProgramWritesAndLeftMemoryIsTakenOver) {
  const std::string name = ownName("own");
  const auto make = [&] { return PictureRing(name, {16, 8}, camera::ColorSpace::kYUV422); };
  const int left = ::shm_open(("/" + name).c_str(), O_CREAT | O_RDWR, 0600);
  ASSERT_EQ(::write(left, "old", 3), 3);
  ::close(left);
  const PictureRing first = make();
  EXPECT_THROW(make(), InputError);
  EXPECT_EQ(PictureRingReader(name).newest(), 0U);
}

}  // namespace
}  // namespace nao::daemon

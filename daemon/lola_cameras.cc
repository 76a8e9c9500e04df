#include "daemon/lola_cameras.h"

#include <algorithm>
#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <list>
#include <utility>

#include "daemon/lola_sender.h"
#include "daemon/picture_ring.h"

namespace nao::daemon {
namespace {

using boost::asio::ip::tcp;

constexpr camera::ImageSize kSize{640, 480};
constexpr camera::ColorSpace kSpace = camera::ColorSpace::kYUV422;
constexpr int kFastest = 30;             // [1/s]
constexpr std::size_t kMostClients = 8;  // of one camera
constexpr std::size_t kHeaderSize = 16;

using Header = std::array<std::uint8_t, kHeaderSize>;

Header headerOf(const camera::Image& image, std::uint8_t camera) {
  const auto tick = static_cast<std::uint16_t>(image.time.time_since_epoch() / LolaSender::kCycle);
  Header header{'w', 'b', 'i', 'm', 'a', 'g', 'e', 0};
  const auto put = [&](std::size_t at, int number) {
    header[at] = static_cast<std::uint8_t>(number);
    header[at + 1] = static_cast<std::uint8_t>(number >> 8);
  };
  put(8, tick);
  header[10] = camera;
  header[11] = static_cast<std::uint8_t>(camera::layers(kSpace));
  put(12, image.size.width);
  put(14, image.size.height);
  return header;
}

int frameRateOf(const CameraModel& camera) {
  int rate = camera.frame_rates.front();
  for (const int offered : camera.frame_rates) {
    if (offered <= kFastest) rate = std::max(rate, offered);
  }
  return rate;
}

/// One program that looks on.
class Viewer : public std::enable_shared_from_this<Viewer> {
 public:
  explicit Viewer(tcp::socket socket) : socket_(std::move(socket)) {}

  bool isOpen() const { return socket_.is_open(); }

  void close() {
    boost::system::error_code ignored;
    socket_.close(ignored);
  }

  // It has nothing to say; that it left shows here.
  void watch() {
    socket_.async_read_some(boost::asio::buffer(unread_),
                            [self = shared_from_this()](const auto& error, std::size_t /*count*/) {
                              if (error) return self->close();
                              self->watch();
                            });
  }

  void show(const camera::Image& image, std::uint8_t camera) {
    if (sending_ || !isOpen()) return;
    sending_ = true;
    header_ = headerOf(image, camera);
    pixels_ = image.bytes;
    const std::array<boost::asio::const_buffer, 2> parts{boost::asio::buffer(header_),
                                                         boost::asio::buffer(*pixels_)};
    boost::asio::async_write(socket_, parts,
                             [self = shared_from_this()](const auto& error, std::size_t /*sent*/) {
                               self->sending_ = false;
                               if (error) self->close();
                             });
  }

 private:
  tcp::socket socket_;
  std::array<char, 64> unread_{};
  bool sending_ = false;
  Header header_{};
  std::shared_ptr<const camera::Bytes> pixels_;
};

}  // namespace

/// One camera, its viewers and its ring.
class LolaCamera {
 public:
  LolaCamera(boost::asio::io_context& io, const LolaCameras::Setup& setup, std::size_t camera,
             std::uint8_t number)
      : feed_(setup.feed), number_(number) {
    request_.camera = static_cast<int>(camera);
    request_.size = kSize;
    request_.color_space = kSpace;
    request_.frame_rate = frameRateOf(setup.model->cameras[camera]);
    if (!setup.memory.empty()) {
      ring_.emplace(setup.memory + (number == 0 ? ".top" : ".bottom"), kSize, kSpace);
    }
    if (!setup.top_port) return;
    const auto port =
        static_cast<std::uint16_t>(*setup.top_port == 0 ? 0 : *setup.top_port + number);
    listener_.emplace(io, Address{setup.hosts, port, "--lola-camera-port"}, [this](auto socket) {
      if (viewers_.size() >= kMostClients) return;
      viewers_.push_back(std::make_shared<Viewer>(std::move(socket)));
      viewers_.back()->watch();
    });
  }

  std::optional<std::uint16_t> port() const {
    return listener_ ? std::optional(listener_->port()) : std::nullopt;
  }

  void deliver() {
    viewers_.remove_if([](const auto& viewer) { return !viewer->isOpen(); });
    const bool wanted = ring_ || !viewers_.empty();
    if (wanted && !subscription_) subscription_ = feed_->subscribe(request_);
    if (!wanted && subscription_) feed_->unsubscribe(*std::exchange(subscription_, std::nullopt));
    const auto image = subscription_ ? feed_->latest(*subscription_) : nullptr;
    if (!image || image == shown_) return;
    shown_ = image;
    if (ring_) ring_->write(*image, number_);
    for (const auto& viewer : viewers_) viewer->show(*image, number_);
  }

  void close() {
    if (listener_) listener_->close();
    for (const auto& viewer : viewers_) viewer->close();
    viewers_.clear();
  }

 private:
  std::shared_ptr<camera::ImageFeed> feed_;
  std::uint8_t number_;
  camera::ImageRequest request_;
  std::optional<PictureRing> ring_;
  std::list<std::shared_ptr<Viewer>> viewers_;
  std::optional<std::uint64_t> subscription_;
  std::shared_ptr<const camera::Image> shown_;
  std::optional<Listener> listener_;
};

LolaCameras::LolaCameras(boost::asio::io_context& io, const Setup& setup) {
  std::uint8_t number = 0;
  for (const char* name : {"CameraTop", "CameraBottom"}) {
    const auto& all = setup.model->cameras;
    const auto camera =
        std::find_if(all.begin(), all.end(), [&](const auto& c) { return c.name == name; });
    if (camera != all.end()) {
      const auto at = static_cast<std::size_t>(camera - all.begin());
      cameras_.push_back(std::make_unique<LolaCamera>(io, setup, at, number));
    }
    ++number;
  }
}

LolaCameras::~LolaCameras() { close(); }

std::vector<std::uint16_t> LolaCameras::ports() const {
  std::vector<std::uint16_t> ports;
  for (const auto& camera : cameras_) {
    if (const auto port = camera->port()) ports.push_back(*port);
  }
  return ports;
}

void LolaCameras::deliver() {
  for (const auto& camera : cameras_) camera->deliver();
}

void LolaCameras::close() {
  for (const auto& camera : cameras_) camera->close();
}

}  // namespace nao::daemon

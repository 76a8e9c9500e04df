#pragma once

#include <boost/asio/io_context.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "camera/image_feed.h"
#include "core/robot_model.h"
#include "daemon/listener.h"

namespace nao::daemon {

class LolaCamera;

/// A robot's two cameras for LoLA programs, which have no ALVideoDevice: each on a TCP port of its
/// own, in the form of Bembelbots' WebotsLoLaController, and as a ring in shared memory. Pictures
/// of 640x480, YUV422 (Y U Y V), as many a second as the camera offers up to 30; drawn only while
/// somebody wants them. I/O thread.
///
///   picture = "wbimage\0" 8, tick u16, camera u8 (0 top, 1 bottom), bytes per pixel u8 = 2,
///             width u16, height u16, then width * height * 2 bytes; little endian
///
/// The tick counts LoLA's cycles of 12 ms, modulo 65536. A client that is still being sent a
/// picture misses the next.
class LolaCameras {
 public:
  struct Setup {
    std::shared_ptr<const RobotModel> model;
    std::shared_ptr<camera::ImageFeed> feed;
    std::vector<std::string> hosts;         // IP addresses
    std::optional<std::uint16_t> top_port;  // the bottom camera's is the next; 0: any; none: none
    std::string memory;                     // name of the rings without ".top"; empty: none
  };

  /// @throws InputError when a port can not be listened on, or memory not be had.
  LolaCameras(boost::asio::io_context& io, const Setup& setup);
  ~LolaCameras();

  /// The ports, of the top camera first; empty: none.
  std::vector<std::uint16_t> ports() const;

  /// Hands on the pictures that are new.
  void deliver();

  void close();

 private:
  std::vector<std::unique_ptr<LolaCamera>> cameras_;
};

}  // namespace nao::daemon

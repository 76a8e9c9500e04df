#pragma once

#include <boost/asio/io_context.hpp>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "core/robot_model.h"
#include "daemon/lola_door.h"
#include "daemon/lola_meeting.h"
#include "motion/robot_ports.h"
#include "naoqi_api/wire/lola_command.h"

namespace nao::daemon {

class LolaSession;

/// One robot's LoLA socket: lets in one client at a time and takes its actuator frames to the
/// robot's body. What is wrong with a frame is logged, once for each kind and client, and nothing
/// of it is taken. I/O thread; LolaSender sends.
class LolaServer {
 public:
  struct Robot {
    std::string name;
    std::shared_ptr<const RobotModel> model;
    std::shared_ptr<motion::RobotPorts> ports;
  };

  /// `heard` is called after a frame was answered, and when a client comes or goes.
  /// @throws InputError when there can be no socket at `path`.
  LolaServer(boost::asio::io_context& io, const std::string& path, Robot robot,
             std::function<void()> heard);
  ~LolaServer();

  const std::string& path() const { return door_.path(); }
  const std::shared_ptr<LolaMeeting>& meeting() const { return meeting_; }

  /// After the robot's cycles: tells of clients that are silent.
  void deliver();

  /// The programs that came here have ended: hears what they have said until then, and nobody
  /// from now on.
  void finish();

  void close();

 private:
  friend class LolaSession;

  void take(LolaDoor::Socket socket);
  void tellNews();
  void answered();
  void drive(BodyCommand command);
  void light(const std::vector<LedOrder>& orders);
  void postLights();
  void left(const std::string& how);
  void log(const std::string& text) const;
  void warn(const std::string& text) const;

  Robot robot_;
  std::function<void()> heard_;
  std::shared_ptr<LolaMeeting> meeting_ = std::make_shared<LolaMeeting>();
  std::shared_ptr<LolaSession> session_;  // null: nobody is connected
  LolaNews news_;                         // as told last
  std::uint64_t answered_ = 0;            // how many frames had been sent then
  std::uint64_t commands_ = 0;
  std::map<std::string, float> lights_;  // that could not be posted yet
  std::size_t posted_lights_ = 0;        // since
  SimTime lit_{};                        // this cycle
  bool drove_ = false;
  LolaDoor door_;
};

}  // namespace nao::daemon

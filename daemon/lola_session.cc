#include "daemon/lola_session.h"

#include <poll.h>

#include <boost/asio/buffer.hpp>
#include <utility>

#include "daemon/lola_server.h"
#include "naoqi_api/call_error.h"
#include "naoqi_api/wire/lola_actuators.h"
#include "runtime/body_drive.h"

namespace nao::daemon {

LolaSession::LolaSession(LolaServer& server, LolaDoor::Socket socket)
    : server_(&server), socket_(std::move(socket)), command_(server.robot_.model) {
  reader_.setMaxBytes(kLongestFrame);
  socket_.non_blocking(true);
}

void LolaSession::close() {
  server_ = nullptr;
  boost::system::error_code ignored;
  socket_.shutdown(LolaDoor::Socket::shutdown_both, ignored);
  socket_.close(ignored);
}

bool LolaSession::hasLeft() {
  pollfd asked{descriptor(), POLLRDHUP, 0};
  return ::poll(&asked, 1, 0) == 1 && (asked.revents & (POLLRDHUP | POLLHUP)) != 0;
}

void LolaSession::checkSilence(SimTime now) {
  if (!came_ || now < *came_) came_ = now;
  if (hasSpoken() || told_silence_ || now - *came_ < runtime::BodyDrive::kHold) return;
  told_silence_ = true;
  server_->warn("the client has sent nothing for 500 ms: it does not drive the robot");
}

// Bytes are in the kernel or taken, never on their way: hearRest() finds all of them.
void LolaSession::listen() {
  socket_.async_wait(LolaDoor::Socket::wait_read,
                     [self = shared_from_this()](const boost::system::error_code& /*error*/) {
                       if (self->server_) self->hearSome();
                       if (self->server_) self->listen();
                     });
}

// False: there is nothing, or it has ended.
bool LolaSession::hearSome() {
  boost::system::error_code error;
  const std::size_t count = socket_.read_some(boost::asio::buffer(buffer_), error);
  if (error == boost::asio::error::would_block) return false;
  if (error) {
    end("the client left");
    return false;
  }
  got(count);
  return server_ != nullptr;
}

void LolaSession::hearRest() {
  constexpr int kMostReads = 1024;  // far more than a socket holds; who still sends has not ended
  const auto self = shared_from_this();
  for (int i = 0; i < kMostReads && server_ && hearSome(); ++i) {
  }
}

void LolaSession::got(std::size_t count) {
  reader_.push(buffer_.data(), count);
  const std::uint64_t before = frames_;
  while (const auto frame = reader_.next()) take(*frame);
  if (frames_ != before) server_->answered();  // once all that came together is taken
  if (reader_.isBroken()) {
    server_->warn("expected actuator frames of at most 64 KiB, found other bytes: closed");
    end("the client was closed");
  }
}

void LolaSession::take(const rpc::Value& frame) {
  ++frames_;
  try {
    const std::string note = command_.take(wire::readLolaActuators(frame));
    if (!note.empty()) tell(note);
    server_->light(command_.takeLeds());
    if (command_.body()) server_->drive(*command_.body());
  } catch (const rpc::CallError& error) {
    ++refused_;
    tell(std::string("frame refused: ") + error.what());
  }
}

// Each kind once: clients repeat their mistakes 83 times a second.
void LolaSession::tell(const std::string& what) {
  constexpr std::size_t kMost = 64;
  const std::string kind = what.substr(0, what.find("expected"));
  if (told_.size() < kMost && told_.insert(kind).second) server_->warn(what);
}

void LolaSession::end(const std::string& how) {
  LolaServer& server = *server_;
  close();
  server.left(how + " after " + std::to_string(frames_) + " frames, " + std::to_string(refused_) +
              " of them refused");
}

}  // namespace nao::daemon

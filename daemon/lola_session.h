#pragma once

#include <array>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "core/sim_time.h"
#include "daemon/lola_door.h"
#include "naoqi_api/wire/lola_command.h"
#include "naoqi_api/wire/msgpack_codec.h"

namespace nao::daemon {

class LolaServer;

/// A connected LoLA client: reads its frames as they come. I/O thread.
class LolaSession : public std::enable_shared_from_this<LolaSession> {
 public:
  static constexpr std::size_t kLongestFrame = 64U << 10U;  // bytes; a usual one has 786

  LolaSession(LolaServer& server, LolaDoor::Socket socket);

  void start() { listen(); }
  void close();

  /// Whether the other side has closed, though that has not been read yet.
  bool hasLeft();

  /// All that it has said up to now; the end of its connection, too, ends it here.
  void hearRest();

  int descriptor() { return socket_.native_handle(); }
  bool hasSpoken() const { return frames_ > 0; }

  /// Tells once if it has said nothing for as long as a command holds.
  void checkSilence(SimTime now);

 private:
  void listen();
  bool hearSome();
  void got(std::size_t count);
  void take(const rpc::Value& frame);
  void tell(const std::string& what);
  void end(const std::string& how);

  LolaServer* server_;  // null: closed
  LolaDoor::Socket socket_;
  std::array<std::uint8_t, 16384> buffer_{};
  wire::MsgpackReader reader_;
  wire::LolaCommand command_;
  std::uint64_t frames_ = 0;
  std::uint64_t refused_ = 0;
  std::set<std::string> told_;  // what each text begins with
  std::optional<SimTime> came_;
  bool told_silence_ = false;
};

}  // namespace nao::daemon

#pragma once

#include <array>
#include <boost/system/error_code.hpp>
#include <cstdint>
#include <functional>
#include <string>

#include "naoqi_api/value.h"

namespace nao::daemon {

/// The bytes of one client's socket, both ways. I/O thread. Whoever passes a function keeps alive
/// what it needs: it may still be called, with an error, after close().
class Stream {
 public:
  using Error = boost::system::error_code;
  using Done = std::function<void(const Error&)>;
  /// The bytes are valid during the call only.
  using Got = std::function<void(const Error&, const std::uint8_t* bytes, std::size_t count)>;

  /// Lent for the moment of a read; all streams of the thread may share one.
  using ReadBuffer = std::array<std::uint8_t, 65536>;

  virtual ~Stream() = default;

  /// Makes it ready: the handshake, where there is one. Once, before anything else.
  virtual void open(Done done) = 0;

  /// Takes what has come, once something has.
  virtual void read(Got got) = 0;

  /// Writes all of `bytes`, which must stay where they are until done. `done` may be called before
  /// this returns.
  virtual void write(const rpc::Bytes& bytes, Done done) = 0;

  virtual void close() = 0;
  virtual bool isOpen() const = 0;

  /// The address the client dialled, as tcp://host:port.
  virtual std::string endpoint() const = 0;
};

}  // namespace nao::daemon

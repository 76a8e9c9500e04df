#include "daemon/lola_door.h"

#include <sys/stat.h>
#include <unistd.h>

#include <utility>

#include "core/check.h"

namespace nao::daemon {
namespace {

using boost::asio::local::stream_protocol;
using Error = boost::system::error_code;

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw InputError("--lola: " + path + ": " + what);
}

void checkLength(const std::string& path) {
  constexpr std::size_t kLongest = 107;  // unix(7), without the closing zero
  if (path.empty() || path.size() > kLongest) fail(path, "expected a path of 1 to 107 letters");
}

// Nobody is there who might answer: a program that was killed could not take its socket along.
void clearAway(boost::asio::io_context& io, const std::string& path) {
  struct stat file {};
  if (::lstat(path.c_str(), &file) != 0) return;
  if (!S_ISSOCK(file.st_mode)) fail(path, "expected a socket or nothing, found a file");
  stream_protocol::socket visitor(io);
  Error error;
  visitor.connect(stream_protocol::endpoint(path), error);
  if (!error) fail(path, "another program serves a robot there, expected a path of its own");
  if (error != boost::asio::error::connection_refused) fail(path, error.message());
  if (::unlink(path.c_str()) != 0) fail(path, "is left over and can not be removed");
}

}  // namespace

struct LolaDoor::Impl : std::enable_shared_from_this<Impl> {
  Impl(boost::asio::io_context& io, std::string where, Take taker)
      : path(std::move(where)), acceptor(io), breath(io), take(std::move(taker)) {}

  void open() {
    Error error;
    const stream_protocol::endpoint endpoint(path);
    acceptor.open(endpoint.protocol(), error);
    if (!error) acceptor.bind(endpoint, error);
    if (!error) acceptor.listen(boost::asio::socket_base::max_listen_connections, error);
    if (!error) acceptor.non_blocking(true, error);
    if (error) fail(path, "can not be listened on: " + error.message());
    ::lstat(path.c_str(), &made);
  }

  void accept() {
    acceptor.async_wait(stream_protocol::acceptor::wait_read,
                        [self = shared_from_this()](const Error& /*error*/) {
                          if (!self->acceptor.is_open()) return;
                          self->takeWaiting() ? self->accept() : self->acceptLater();
                        });
  }

  // False: somebody waits who can not be let in.
  bool takeWaiting() {
    for (;;) {
      Error error;
      Socket socket = acceptor.accept(error);
      if (error) return error == boost::asio::error::would_block;
      take(std::move(socket));
    }
  }

  // No descriptor is left: one may be free soon.
  void acceptLater() {
    breath.expires_after(std::chrono::milliseconds(100));
    breath.async_wait([self = shared_from_this()](const Error& error) {
      if (!error && self->acceptor.is_open()) self->accept();
    });
  }

  void close() {
    if (!acceptor.is_open()) return;
    Error ignored;
    acceptor.close(ignored);
    breath.cancel();
    struct stat now {};
    const bool own =
        ::lstat(path.c_str(), &now) == 0 && now.st_ino == made.st_ino && now.st_dev == made.st_dev;
    if (own) ::unlink(path.c_str());
  }

  std::string path;
  stream_protocol::acceptor acceptor;
  boost::asio::steady_timer breath;
  Take take;
  struct stat made {};
};

LolaDoor::LolaDoor(boost::asio::io_context& io, const std::string& path, const Take& take)
    : impl_(std::make_shared<Impl>(io, path, take)) {
  checkLength(path);
  clearAway(io, path);
  impl_->open();
  impl_->accept();
}

LolaDoor::~LolaDoor() { close(); }

const std::string& LolaDoor::path() const { return impl_->path; }
void LolaDoor::takeWaiting() { impl_->takeWaiting(); }
void LolaDoor::close() { impl_->close(); }

}  // namespace nao::daemon

#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace nao::daemon {

/// A Python process that runs a behavior's code and is a client like any other. Lives in a
/// shared_ptr; who lets go of it ends it. I/O thread.
class ScriptProcess : public std::enable_shared_from_this<ScriptProcess> {
 public:
  struct Job {
    std::filesystem::path file;     // the behavior.xar
    std::filesystem::path modules;  // the folder of the Python client
    std::string address;            // of the robot, host:port
    std::string token;              // of the user kUser; empty: none is asked for
  };
  static constexpr char kUser[] = "usarnaoqi-script";

  using Ended = std::function<void(const std::string& failure)>;

  /// `ended` is told later, once, unless the process is let go before.
  /// @throws rpc::CallError if there is no python3.
  static std::shared_ptr<ScriptProcess> start(boost::asio::io_context& io, const Job& job,
                                              Ended ended);
  ~ScriptProcess();

  /// Asks it to end.
  void stop() const;

 private:
  ScriptProcess(boost::asio::io_context& io, Ended ended);
  void run(const Job& job);
  void waitForEnd();

  boost::asio::posix::stream_descriptor alive_;  // of a pipe that the process holds open
  Ended ended_;
  char nothing_ = 0;
  int process_ = 0;  // 0: none, or over
};

}  // namespace nao::daemon

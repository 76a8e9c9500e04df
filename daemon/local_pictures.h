#pragma once

#include <boost/asio/io_context.hpp>
#include <functional>
#include <string>

#include "naoqi_api/pending.h"
#include "naoqi_api/sdk/cpp/include/usarnaoqi_sdk/local_host.h"
#include "naoqi_api/value.h"

namespace nao::daemon {

/// Lends the robot's pictures to modules in this process: they read the pixels where the camera
/// has put them. Must outlive the modules.
class LocalPictures {
 public:
  /// What ALVideoDevice answers to getImageRemote, or getDirectRawImageRemote. I/O thread.
  using Ask = std::function<rpc::Pending<rpc::Value>(const std::string& window, bool raw)>;

  LocalPictures(boost::asio::io_context& io, Ask ask);

  /// What modules call, on their threads, which wait for a window's first picture.
  const UsarnaoqiPictures& functions() const { return functions_; }

 private:
  bool lend(const std::string& window, bool raw, UsarnaoqiPicture& picture);

  boost::asio::io_context& io_;
  Ask ask_;
  UsarnaoqiPictures functions_;
};

}  // namespace nao::daemon

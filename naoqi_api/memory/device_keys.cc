#include "naoqi_api/memory/device_keys.h"

#include <utility>

#include "naoqi_api/memory/device_views.h"

namespace nao::memory {

DeviceKeys::DeviceKeys(const RobotModel& model, std::shared_ptr<const motion::RobotPorts> ports)
    : ports_(std::move(ports)) {
  addJointViews(model, views_);
  addMotionViews(model, views_);
  addInertialViews(views_);
  addFootViews(model, views_);
  addBoardViews(model, views_);
  addLedViews(model, views_);
}

std::optional<rpc::Value> DeviceKeys::find(const std::string& key, const Frames& frames) const {
  const View* view = findView(key);
  if (!view || !frames.sensors || !frames.state) return std::nullopt;
  return view->read(*frames.sensors, *frames.state);
}

const View* DeviceKeys::findView(const std::string& key) const {
  const auto found = views_.find(key);
  return found == views_.end() ? nullptr : &found->second;
}

}  // namespace nao::memory

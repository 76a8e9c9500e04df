#include "camera/image_feed.h"

#include <algorithm>

namespace nao::camera {

std::uint64_t ImageFeed::subscribe(const ImageRequest& request) {
  own_.push_back({next_id_, request, std::make_shared<Latest<Image>>()});
  table_.publish(own_);
  return next_id_++;
}

bool ImageFeed::unsubscribe(std::uint64_t id) {
  const auto gone =
      std::find_if(own_.begin(), own_.end(), [&](const Subscription& s) { return s.id == id; });
  if (gone == own_.end()) return false;
  own_.erase(gone);
  table_.publish(own_);
  return true;
}

CameraControl& ImageFeed::ownControl(int camera) {
  const auto index = static_cast<std::size_t>(camera);
  if (own_controls_.size() <= index) own_controls_.resize(index + 1);
  return own_controls_[index];
}

void ImageFeed::setSettings(int camera, const CameraSettings& settings) {
  ownControl(camera).settings = settings;
  controls_.publish(own_controls_);
}

void ImageFeed::setEffects(int camera, const CameraEffects& effects) {
  ownControl(camera).effects = effects;
  controls_.publish(own_controls_);
}

std::shared_ptr<const Image> ImageFeed::latest(std::uint64_t id) const {
  const auto table = table_.get();
  if (!table) return nullptr;
  const auto found = std::lower_bound(table->begin(), table->end(), id,
                                      [](const Subscription& subscription, std::uint64_t wanted) {
                                        return subscription.id < wanted;
                                      });
  return found != table->end() && found->id == id ? found->window->get() : nullptr;
}

}  // namespace nao::camera

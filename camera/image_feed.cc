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

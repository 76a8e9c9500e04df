#include <alvision/alimage.h>
#include <usarnaoqi_sdk/local_host.h>
#include <usarnaoqi_sdk/local_image.h>

#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "naoqi_api/sdk/cpp/src/addresses.h"

namespace {

// Never destroyed: a module's last picture may be released after static objects.
struct Images {
  std::mutex mutex;
  std::map<std::pair<std::string, bool>, std::unique_ptr<AL::ALImage>> lent;
};
Images& images() {
  static Images* const all = new Images;
  return *all;
}

/// What getImageRemote would return, without a copy of the pixels.
AL::ALValue toValue(const UsarnaoqiPicture& picture, const UsarnaoqiPictures& host) {
  AL::ALValue pixels;
  pixels.SetBinary(std::shared_ptr<const void>(picture.pixels,
                                               [give_back = host.giveBack, owner = picture.owner](
                                                   const void* /*pixels*/) { give_back(owner); }),
                   picture.size);
  AL::ALValue value;
  for (const int number : {picture.width, picture.height, picture.layers, picture.color,
                           picture.seconds, picture.microseconds})
    value.arrayPush(number);
  value.arrayPush(pixels);
  value.arrayPush(picture.camera);
  for (const float angle : picture.angles) value.arrayPush(angle);
  return value;
}

AL::ALValue fetch(const AL::ALProxy& video, const std::string& window, bool raw) {
  const UsarnaoqiPictures* const host = nao::client::ownPictures();
  if (host == nullptr)
    return video.call<AL::ALValue>(raw ? "getDirectRawImageRemote" : "getImageRemote", window);
  UsarnaoqiPicture picture{};
  if (!host->lend(host->host, window.c_str(), raw, &picture)) return AL::ALValue();
  return toValue(picture, *host);
}

}  // namespace

void* AL::detail::localImage(const ALProxy& video, const std::string& window, bool raw) {
  const ALValue value = fetch(video, window, raw);
  releaseLocalImage(window, raw);
  if (!value.isArray()) return nullptr;
  auto image = std::make_unique<ALImage>(value);
  const std::lock_guard<std::mutex> lock(images().mutex);
  return (images().lent[{window, raw}] = std::move(image)).get();
}

void AL::detail::releaseLocalImage(const std::string& window, bool raw) {
  const std::lock_guard<std::mutex> lock(images().mutex);
  images().lent.erase({window, raw});
}

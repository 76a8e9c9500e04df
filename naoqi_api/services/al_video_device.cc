#include "naoqi_api/services/al_video_device.h"

#include <algorithm>
#include <utility>

#include "naoqi_api/call_error.h"

namespace nao::services {
namespace {

constexpr std::size_t kLongestName = 128;
constexpr camera::ColorSpace kSensorSpace = camera::ColorSpace::kYUV422;  // what sensors deliver
constexpr int k16Vga = 4;                                                 // resolution 2560x1920
constexpr int k16VgaMostRate = 15;  // [1/s] NAOqi 2.8, the V6's top camera

/// The rate a camera works at when asked for `wish` pictures a second: its next faster one.
int offeredRate(const CameraModel& camera, int wish) {
  const auto& rates = camera.frame_rates;
  if (rates.empty()) return wish;
  const auto found = std::lower_bound(rates.begin(), rates.end(), wish);
  return found != rates.end() ? *found : rates.back();
}

/// The largest standard size up to `wish` that the camera can take.
int offeredResolution(const CameraModel& camera, int wish) {
  const auto fits = [&](int resolution) {
    const auto size = camera::resolutionSize(resolution);
    return size && size->width <= camera.max_width && size->height <= camera.max_height;
  };
  int resolution = wish;
  while (resolution > 0 && !fits(resolution)) --resolution;
  return resolution;
}

rpc::CallError unknownHandle(const std::string& handle) {
  return rpc::CallError("ALVideoDevice: no subscriber \"" + handle + "\"");
}

}  // namespace

AlVideoDevice::AlVideoDevice(std::shared_ptr<const RobotModel> robot,
                             std::shared_ptr<camera::ImageFeed> feed, Duration epoch)
    : robot_(std::move(robot)),
      feed_(std::move(feed)),
      epoch_(epoch),
      settings_(robot_->cameras.size()) {}

std::string AlVideoDevice::subscribeCamera(const rpc::Caller& caller, const std::string& name,
                                           int camera, int resolution, int color_space,
                                           int frame_rate) {
  return open(caller, name, makeWindow(camera, resolution, color_space, frame_rate));
}

std::string AlVideoDevice::subscribe(const rpc::Caller& caller, const std::string& name,
                                     int resolution, int color_space, int frame_rate) {
  auto window = makeWindow(active_camera_, resolution, color_space, frame_rate);
  if (window) window->follows_active = true;
  return open(caller, name, window);
}

std::string AlVideoDevice::open(const rpc::Caller& caller, const std::string& name,
                                const std::optional<Window>& window) {
  const std::string handle = freeHandle(name);
  if (!window || handle.empty()) return {};
  Window& opened = windows_[handle] = *window;
  closed_.erase(opened.camera);  // whoever looks switches it on
  opened.session = caller.id();
  if (caller.session) watch(caller.session);
  startSubscription(opened);
  return handle;
}

std::string AlVideoDevice::handleOf(const std::string& name, std::size_t number) const {
  if (numbers_first_) return name + "_" + std::to_string(number);
  return number == 0 ? name : name + "_" + std::to_string(number + 1);
}

std::string AlVideoDevice::freeHandle(const std::string& name) const {
  if (windows_.size() >= kMost || name.size() > kLongestName) return {};
  for (std::size_t i = 0; i < kMostOfOneName; ++i) {
    const std::string handle = handleOf(name, i);
    if (windows_.count(handle) == 0) return handle;
  }
  return {};
}

std::optional<AlVideoDevice::Window> AlVideoDevice::makeWindow(int camera, int resolution,
                                                               int color_space,
                                                               int frame_rate) const {
  const auto space = camera::toColorSpace(color_space);
  if (!isCamera(camera) || !camera::resolutionSize(resolution) || !space || frame_rate <= 0) {
    return std::nullopt;
  }
  const CameraModel& model = cameraOf(camera);
  Window window;
  window.camera = camera;
  window.resolution = offeredResolution(model, resolution);
  window.color_space = *space;
  window.frame_rate = offeredRate(model, frame_rate);
  if (window.resolution == k16Vga) window.frame_rate = std::min(window.frame_rate, k16VgaMostRate);
  return window;
}

void AlVideoDevice::startSubscription(Window& window) {
  window.subscription = feed_->subscribe({window.camera, *camera::resolutionSize(window.resolution),
                                          window.color_space, window.frame_rate});
}

void AlVideoDevice::watch(const std::shared_ptr<rpc::Session>& session) {
  const std::uint64_t id = session->id();
  if (!watched_sessions_.insert(id).second) return;
  session->onEnd([self = std::weak_ptr<AlVideoDevice*>(alive_), id] {
    if (const auto alive = self.lock()) (*alive)->closeWindowsOf(id);
  });
}

void AlVideoDevice::closeWindowsOf(std::uint64_t session) {
  watched_sessions_.erase(session);
  std::vector<std::string> left;
  for (const auto& [handle, window] : windows_) {
    if (window.session == session) left.push_back(handle);
  }
  for (const std::string& handle : left) unsubscribe(handle);
  for (auto put = put_.begin(); put != put_.end();) {
    put = put->second.session == session ? put_.erase(put) : std::next(put);
  }
}

bool AlVideoDevice::unsubscribe(const std::string& handle) {
  const auto found = windows_.find(handle);
  if (found == windows_.end()) return false;
  const Window closed = std::move(found->second);
  windows_.erase(found);
  closeFeeds(closed);
  recordings_.erase(handle);
  for (const auto* waiting : {&closed.waiting, &closed.waiting_raw}) {
    for (const auto& call : *waiting) call.resolve(rpc::Value());
  }
  return true;
}

void AlVideoDevice::closeFeeds(const Window& window) {
  feed_->unsubscribe(window.subscription);
  if (window.raw != 0) feed_->unsubscribe(window.raw);
}

void AlVideoDevice::unsubscribeAllInstances(const std::string& name) {
  for (std::size_t i = 0; i < kMostOfOneName; ++i) unsubscribe(handleOf(name, i));
}

rpc::Value AlVideoDevice::getSubscribers() const { return rpc::toValue(handles()); }

std::vector<std::string> AlVideoDevice::handles() const {
  std::vector<std::string> found;
  for (const auto& [handle, unused] : windows_) found.push_back(handle);
  return found;
}

// What clients test for as None answers an unknown handle and a camera that is off.
rpc::Pending<rpc::Value> AlVideoDevice::getImageRemote(const std::string& handle) {
  rpc::Pending<rpc::Value> nothing;
  Window* const window = findWindow(handle);
  if (window != nullptr && closed_.count(window->camera) == 0)
    return replyWith(pictureOf(*window), window->waiting);
  nothing.resolve(rpc::Value());
  return nothing;
}

rpc::Pending<rpc::Value> AlVideoDevice::getDirectRawImage(const std::string& handle) {
  Window* const window = findWindow(handle);
  const bool is_off = window == nullptr || closed_.count(window->camera) > 0;
  if (is_off || window->color_space == kSensorSpace) return getImageRemote(handle);
  if (window->raw == 0) {
    window->raw = feed_->subscribe({window->camera, *camera::resolutionSize(window->resolution),
                                    kSensorSpace, window->frame_rate});
  }
  return replyWith(rawPictureOf(*window), window->waiting_raw);
}

/// The picture, or when it comes.
rpc::Pending<rpc::Value> AlVideoDevice::replyWith(const Picture& picture, Waiting& waiting) const {
  rpc::Pending<rpc::Value> reply;
  if (picture) {
    reply.resolve(toReply(*picture));
    return reply;
  }
  const auto given_up = [](const auto& call) { return call.isDone(); };
  waiting.erase(std::remove_if(waiting.begin(), waiting.end(), given_up), waiting.end());
  waiting.push_back(reply);
  reply.onlyWaits();
  return reply;
}

void AlVideoDevice::deliverImages() {
  std::vector<std::pair<rpc::Pending<rpc::Value>, rpc::Value>> replies;
  const auto deliver = [&](const Picture& picture, Waiting& waiting) {
    if (!picture) return;
    for (const auto& call : std::exchange(waiting, {}))
      replies.emplace_back(call, toReply(*picture));
  };
  for (auto& [unused, window] : windows_) {
    if (!window.waiting.empty()) deliver(pictureOf(window), window.waiting);
    if (!window.waiting_raw.empty()) deliver(rawPictureOf(window), window.waiting_raw);
  }
  for (const auto& [call, reply] : replies) call.resolve(reply);
  recordDue();
}

rpc::Value AlVideoDevice::toReply(const camera::Image& image) const {
  using std::chrono::duration_cast;
  const Duration stamp = epoch_ + image.time.time_since_epoch();
  const auto seconds = duration_cast<std::chrono::seconds>(stamp);
  const auto rest = duration_cast<std::chrono::microseconds>(stamp - seconds);
  const CameraModel& model = cameraOf(image.camera);
  const auto right = static_cast<float>(model.hfov / 2);
  const auto top = static_cast<float>(model.vfov / 2);
  return rpc::Value::list({image.size.width, image.size.height, camera::layers(image.color_space),
                           static_cast<int>(image.color_space), static_cast<int>(seconds.count()),
                           static_cast<int>(rest.count()), image.bytes, image.camera, right, top,
                           -right, -top});
}

bool AlVideoDevice::releaseImage(const std::string& handle) const {
  return findWindow(handle) != nullptr;  // pictures are shared, so there is nothing to release
}

bool AlVideoDevice::replace(const std::string& handle, const std::optional<Window>& changed) {
  Window* const window = findWindow(handle);
  if (window == nullptr || !changed) return false;
  window->camera = changed->camera;
  window->resolution = changed->resolution;
  window->color_space = changed->color_space;
  window->frame_rate = changed->frame_rate;
  closeFeeds(*window);
  window->raw = 0;
  for (const auto& call : std::exchange(window->waiting_raw, {})) call.resolve(rpc::Value());
  startSubscription(*window);
  return true;
}

bool AlVideoDevice::setCamera(const std::string& handle, int camera) {
  if (!turn(handle, camera)) return false;
  findWindow(handle)->follows_active = false;
  return true;
}

bool AlVideoDevice::turn(const std::string& handle, int camera) {
  const Window& now = windowOf(handle);
  return replace(handle, makeWindow(camera, now.resolution, static_cast<int>(now.color_space),
                                    now.frame_rate));
}

bool AlVideoDevice::setResolution(const std::string& handle, int resolution) {
  const Window& now = windowOf(handle);
  return replace(handle, makeWindow(now.camera, resolution, static_cast<int>(now.color_space),
                                    now.frame_rate));
}

bool AlVideoDevice::setColorSpace(const std::string& handle, int color_space) {
  const Window& now = windowOf(handle);
  return replace(handle, makeWindow(now.camera, now.resolution, color_space, now.frame_rate));
}

bool AlVideoDevice::setFrameRate(const std::string& handle, int frame_rate) {
  const Window& now = windowOf(handle);
  return replace(handle, makeWindow(now.camera, now.resolution, static_cast<int>(now.color_space),
                                    frame_rate));
}

int AlVideoDevice::getCamera(const std::string& handle) const { return windowOf(handle).camera; }

int AlVideoDevice::getResolution(const std::string& handle) const {
  return windowOf(handle).resolution;
}

int AlVideoDevice::getColorSpace(const std::string& handle) const {
  return static_cast<int>(windowOf(handle).color_space);
}

int AlVideoDevice::getFrameRate(const std::string& handle) const {
  return windowOf(handle).frame_rate;
}

AlVideoDevice::Window* AlVideoDevice::findWindow(const std::string& handle) {
  const auto found = windows_.find(handle);
  return found == windows_.end() ? nullptr : &found->second;
}

const AlVideoDevice::Window* AlVideoDevice::findWindow(const std::string& handle) const {
  const auto found = windows_.find(handle);
  return found == windows_.end() ? nullptr : &found->second;
}

const AlVideoDevice::Window& AlVideoDevice::windowOf(const std::string& handle) const {
  const Window* const window = findWindow(handle);
  if (window == nullptr) throw unknownHandle(handle);
  return *window;
}

}  // namespace nao::services

#include "camera/render_queue.h"

#include <algorithm>
#include <utility>

#include "camera/color_conversion.h"
#include "core/check.h"

namespace nao::camera {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;  // [ns]

bool sameView(const ImageRequest& a, const ImageRequest& b) {
  return a.camera == b.camera && a.size == b.size;
}

Image makeImage(const Raster& raster, const ImageRequest& request, SimTime time) {
  return {raster.size(), request.color_space, time, request.camera,
          std::make_shared<const Bytes>(toBytes(raster, request.color_space))};
}

/// Shows one raster in the windows of all that asked for this view; they share bytes where their
/// colour spaces agree.
void publish(const Raster& raster, const std::vector<Subscription>& due, const ImageRequest& view,
             SimTime time) {
  std::map<ColorSpace, std::shared_ptr<const Image>> images;
  for (const Subscription& subscription : due) {
    if (!sameView(subscription.request, view)) continue;
    auto& image = images[subscription.request.color_space];
    if (!image) {
      image = std::make_shared<const Image>(makeImage(raster, subscription.request, time));
    }
    subscription.window->publish(image);
  }
}

}  // namespace

std::int64_t pictureNumber(SimTime now, int frame_rate) {
  return now.time_since_epoch().count() * frame_rate / kSecond;
}

SimTime dueTime(std::int64_t k, int frame_rate) {
  return SimTime(Duration((k * kSecond + frame_rate - 1) / frame_rate));
}

RenderQueue::RenderQueue(std::shared_ptr<const ImageFeed> feed, std::size_t capacity)
    : feed_(std::move(feed)), capacity_(capacity), jobs_(capacity) {
  NAO_CHECK(feed_ != nullptr && capacity > 0);
}

bool RenderQueue::anyDue(SimTime now) {
  auto table = feed_->subscriptions();
  const bool started_over = now < now_;
  if (started_over) {
    taken_.clear();
    held_.clear();
  }
  now_ = now;
  for (; !held_.empty() && held_.front().first <= now; held_.pop_front())
    post(std::move(held_.front().second));
  if (started_over || table != table_) {
    table_ = std::move(table);
    findNextDue();
  }
  return now >= next_due_;
}

void RenderQueue::findNextDue() {
  next_due_ = SimTime::max();
  if (!table_) return;
  for (const Subscription& subscription : *table_) {
    const auto taken = taken_.find(subscription.id);
    const SimTime due = taken == taken_.end()
                            ? SimTime::min()
                            : dueTime(taken->second + 1, subscription.request.frame_rate);
    next_due_ = std::min(next_due_, due);
  }
}

bool RenderQueue::offer(std::shared_ptr<const SceneFrame> scene, std::size_t robot) {
  if (!anyDue(scene->time)) return true;
  std::map<Duration, Job> jobs;                 // by latency
  std::map<std::uint64_t, std::int64_t> taken;  // forgets who has unsubscribed
  const auto& cameras = scene->robots.at(robot).model->cameras;
  for (const Subscription& subscription : *table_) {
    const std::int64_t k = pictureNumber(now_, subscription.request.frame_rate);
    const auto last = taken_.find(subscription.id);
    const Duration latency =
        cameras.at(static_cast<std::size_t>(subscription.request.camera)).latency;
    if (last == taken_.end() || last->second < k) jobs[latency].due.push_back(subscription);
    taken[subscription.id] = k;
  }
  taken_ = std::move(taken);
  findNextDue();
  bool all = true;
  for (auto& [latency, job] : jobs) {
    job.scene = scene;
    job.robot = robot;
    job.controls = feed_->controls();
    if (latency > Duration::zero()) {
      hold(now_ + latency, std::move(job));
    } else {
      all &= post(std::move(job));
    }
  }
  return all;
}

void RenderQueue::hold(SimTime until, Job job) {
  const auto later = std::find_if(held_.begin(), held_.end(),
                                  [&](const auto& other) { return other.first > until; });
  held_.insert(later, {until, std::move(job)});
}

bool RenderQueue::post(Job job) {
  const auto images = static_cast<std::int64_t>(job.due.size());
  if (pendingJobs() >= capacity_ || !jobs_.post(std::move(job))) {
    dropped_.publish(droppedImages() + images);
    return false;
  }
  ++offered_jobs_;
  return true;
}

std::size_t RenderQueue::pendingJobs() const {
  const auto finished = finished_.get();
  return static_cast<std::size_t>(offered_jobs_ - (finished ? *finished : 0));
}

Eye& RenderQueue::eyeOf(const Job& job, int camera) {
  const auto found = eyes_.find(camera);
  if (found != eyes_.end()) return found->second;
  const auto index = static_cast<std::size_t>(camera);
  const std::uint64_t seed = job.robot * 1000 + index;  // every eye has noise of its own
  return eyes_.try_emplace(camera, *job.scene->robots[job.robot].model, index, seed).first->second;
}

std::int64_t RenderQueue::droppedImages() const {
  const auto dropped = dropped_.get();
  return dropped ? *dropped : 0;
}

bool RenderQueue::renderNext(Renderer& renderer) {
  if (waiting_.empty()) {
    for (Job& job : jobs_.drain()) waiting_.push_back(std::move(job));
  }
  if (waiting_.empty()) return false;
  const Job job = std::move(waiting_.front());
  waiting_.pop_front();
  for (auto first = job.due.begin(); first != job.due.end(); ++first) {
    const auto same = [&](const Subscription& s) { return sameView(s.request, first->request); };
    if (std::any_of(job.due.begin(), first, same)) continue;  // drawn with an earlier one
    const CameraPlace place{job.robot, static_cast<std::size_t>(first->request.camera)};
    const bool is_set = job.controls && place.camera < job.controls->size();
    const CameraControl control = is_set ? (*job.controls)[place.camera] : CameraControl{};
    Eye& eye = eyeOf(job, first->request.camera);
    if (control.effects) eye.use(*control.effects);
    const Raster& raster =
        eye.look(*job.scene, place, first->request.size, control.settings, renderer);
    publish(raster, job.due, first->request, job.scene->time);
  }
  finished_.publish(++finished_jobs_);
  return true;
}

}  // namespace nao::camera

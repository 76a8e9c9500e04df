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
  handOver();
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
    auto ready = std::make_shared<const Job>(std::move(job));
    if (latency > Duration::zero()) {
      hold(now_ + latency, std::move(ready));
    } else {
      all &= post(std::move(ready));
    }
  }
  return all;
}

void RenderQueue::hold(SimTime until, JobPointer job) {
  const auto later = std::find_if(held_.begin(), held_.end(),
                                  [&](const auto& other) { return other.first > until; });
  held_.insert(later, {until, std::move(job)});
}

bool RenderQueue::post(JobPointer job) {
  if (pendingJobs() >= capacity_) {
    dropped_.publish(droppedImages() + static_cast<std::int64_t>(job->due.size()));
    return false;
  }
  under_way_.push_back(std::move(job));
  ++offered_jobs_;
  ++to_hand_over_;
  handOver();
  return true;
}

void RenderQueue::handOver() {
  while (to_hand_over_ > 0 && jobs_.post(under_way_[under_way_.size() - to_hand_over_]))
    --to_hand_over_;
}

std::size_t RenderQueue::pendingJobs() {
  handOver();
  const auto drawn = drawn_.get();
  const auto pending = static_cast<std::size_t>(offered_jobs_ - (drawn ? drawn->jobs : 0));
  while (under_way_.size() > pending) under_way_.pop_front();
  return pending;
}

std::shared_ptr<const RenderQueue::Moment> RenderQueue::moment() const {
  auto moment = std::make_shared<Moment>();
  moment->feed = feed_;
  moment->drawn = drawn_.get();
  const auto pending = offered_jobs_ - (moment->drawn ? moment->drawn->jobs : 0);
  moment->under_way.assign(under_way_.end() - pending, under_way_.end());
  moment->taken = taken_;
  moment->held = held_;
  return moment;
}

RenderQueue::JobPointer RenderQueue::startOf(const Moment& moment) const {
  Job job;
  job.start = moment.drawn ? moment.drawn : std::make_shared<const Drawn>();
  return mine(std::make_shared<const Job>(std::move(job)), moment);
}

/// A moment's job in this queue. Pictures for another feed are drawn, as automatic exposure has
/// seen them, but nobody gets them.
RenderQueue::JobPointer RenderQueue::mine(const JobPointer& job, const Moment& moment) const {
  if (moment.feed == feed_) return job;
  Job copy = *job;
  for (Subscription& subscription : copy.due) {
    subscription.id = 0;
    subscription.window = std::make_shared<Latest<Image>>();
  }
  if (copy.start) {
    auto start = std::make_shared<Drawn>(*copy.start);
    start->last.clear();
    copy.start = start;
  }
  return std::make_shared<const Job>(std::move(copy));
}

void RenderQueue::restore(const std::shared_ptr<const Moment>& moment) {
  const Moment start;
  const Moment& to = moment ? *moment : start;
  // What the camera thread has not taken yet belongs to another time.
  under_way_.erase(under_way_.end() - static_cast<std::ptrdiff_t>(to_hand_over_), under_way_.end());
  offered_jobs_ -= static_cast<std::int64_t>(std::exchange(to_hand_over_, 0));
  std::vector<JobPointer> jobs = {startOf(to)};
  for (const JobPointer& job : to.under_way) jobs.push_back(mine(job, to));
  under_way_.insert(under_way_.end(), jobs.begin(), jobs.end());
  offered_jobs_ += static_cast<std::int64_t>(jobs.size());
  to_hand_over_ = jobs.size();
  handOver();
  // At once, too: who asks now sees no picture of a time that has not come.
  showAgain(*jobs.front()->start);
  held_.clear();
  for (const auto& [until, job] : to.held) held_.emplace_back(until, mine(job, to));
  taken_ = to.feed == feed_ ? to.taken : std::map<std::uint64_t, std::int64_t>{};
  table_ = nullptr;
  now_ = SimTime::min();
  next_due_ = SimTime::max();
}

Eye& RenderQueue::eyeOf(const Job& job, int camera) {
  const auto found = eyes_.find(camera);
  if (found != eyes_.end()) return found->second;
  const auto index = static_cast<std::size_t>(camera);
  const std::uint64_t seed = job.robot * 1000 + index;  // every eye has noise of its own
  const RobotModel& model = *job.scene->robots[job.robot].model;
  Eye& eye = eyes_.try_emplace(camera, model, index, seed).first->second;
  eye.restore(so_far_.eyes[camera]);
  return eye;
}

std::int64_t RenderQueue::droppedImages() const {
  const auto dropped = dropped_.get();
  return dropped ? *dropped : 0;
}

bool RenderQueue::renderNext(Renderer& renderer) {
  if (waiting_.empty()) {
    for (JobPointer& job : jobs_.drain()) waiting_.push_back(std::move(job));
  }
  if (waiting_.empty()) return false;
  const JobPointer job = std::move(waiting_.front());
  waiting_.pop_front();
  if (job->start) {
    goBackTo(*job->start);
  } else {
    draw(*job, renderer);
  }
  tellDrawn();
  return true;
}

void RenderQueue::draw(const Job& job, Renderer& renderer) {
  for (auto first = job.due.begin(); first != job.due.end(); ++first) {
    const auto same = [&](const Subscription& s) { return sameView(s.request, first->request); };
    if (std::any_of(job.due.begin(), first, same)) continue;  // drawn with an earlier one
    const CameraPlace place{job.robot, static_cast<std::size_t>(first->request.camera)};
    const bool is_set = job.controls && place.camera < job.controls->size();
    const CameraControl control = is_set ? (*job.controls)[place.camera] : CameraControl{};
    Eye& eye = eyeOf(job, first->request.camera);
    if (control.effects) eye.use(*control.effects);
    publish(eye.look(*job.scene, place, first->request.size, control.settings, renderer), job,
            first->request);
    so_far_.eyes[first->request.camera] = eye.sensor().state();
  }
}

/// Shows one raster in the windows of all that asked for this view; they share bytes where their
/// colour spaces agree.
void RenderQueue::publish(const Raster& raster, const Job& job, const ImageRequest& view) {
  std::map<ColorSpace, std::shared_ptr<const Image>> images;
  for (const Subscription& subscription : job.due) {
    if (!sameView(subscription.request, view)) continue;
    auto& image = images[subscription.request.color_space];
    if (!image) {
      image =
          std::make_shared<const Image>(makeImage(raster, subscription.request, job.scene->time));
    }
    subscription.window->publish(image);
    so_far_.last[subscription.id] = image;
  }
}

void RenderQueue::goBackTo(const Drawn& start) {
  eyes_.clear();
  so_far_.eyes = start.eyes;
  for (const auto& [subscription, image] : start.last) so_far_.last[subscription] = image;
  showAgain(start);
}

void RenderQueue::showAgain(const Drawn& start) const {
  const auto table = feed_->subscriptions();
  if (!table) return;
  for (const Subscription& subscription : *table) {
    const auto shown = start.last.find(subscription.id);
    if (shown != start.last.end()) subscription.window->publish(shown->second);
  }
}

/// Pictures of those who have left are forgotten.
void RenderQueue::tellDrawn() {
  ++so_far_.jobs;
  std::map<std::uint64_t, std::shared_ptr<const Image>> last;
  if (const auto table = feed_->subscriptions()) {
    for (const Subscription& subscription : *table) {
      const auto shown = so_far_.last.find(subscription.id);
      if (shown != so_far_.last.end()) last.insert(*shown);
    }
  }
  so_far_.last = std::move(last);
  drawn_.publish(so_far_);
}

}  // namespace nao::camera

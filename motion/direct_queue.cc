#include "motion/direct_queue.h"

#include <algorithm>

namespace nao::motion {
namespace {

using Points = std::vector<TimedValue>;
using Merge = DirectCommands::Merge;

bool earlier(const TimedValue& a, const TimedValue& b) { return a.time < b.time; }

// What is left of a queue when `added` come, and they in it.
Points merged(Points points, const Points& added, Merge how) {
  if (added.empty()) return points;
  const SimTime first = added.front().time;
  const SimTime last = added.back().time;
  const auto drop = [&points](auto condition) {
    points.erase(std::remove_if(points.begin(), points.end(), condition), points.end());
  };
  switch (how) {
    case Merge::ClearAll:
      points.clear();
      break;
    case Merge::Merge:
      break;
    case Merge::ClearAfter:
      drop([first](const TimedValue& point) { return point.time >= first; });
      break;
    case Merge::ClearBefore:
      drop([last](const TimedValue& point) { return point.time <= last; });
      break;
  }
  points.insert(points.end(), added.begin(), added.end());
  std::stable_sort(points.begin(), points.end(), earlier);
  return points;
}

}  // namespace

DirectQueue::Queue& DirectQueue::queueOf(const DirectCommands::Track& track) {
  auto& queues = track.quantity == DirectCommands::Quantity::Angle ? angle_ : stiffness_;
  return queues[index(track.joint)];
}

bool DirectQueue::take(const DirectCommands& request, SimTime now, const JointArray<double>& angle,
                       const JointArray<double>& stiffness) {
  std::vector<Points> next;
  for (const DirectCommands::Track& track : request.tracks) {
    Points added = track.points;
    std::stable_sort(added.begin(), added.end(), earlier);
    next.push_back(merged(queueOf(track).points, added, request.merge));
    if (next.back().size() > kDeepest) return false;
  }
  for (std::size_t i = 0; i < request.tracks.size(); ++i) {
    const DirectCommands::Track& track = request.tracks[i];
    const bool is_angle = track.quantity == DirectCommands::Quantity::Angle;
    Queue& queue = queueOf(track);
    if (queue.points.empty() || request.merge != Merge::Merge) {
      queue.last = {now, is_angle ? angle[track.joint] : stiffness[track.joint]};
    }
    queue.points = std::move(next[i]);
  }
  return true;
}

JointSet DirectQueue::activeAngles() const {
  JointSet active;
  for (std::size_t i = 0; i < angle_.size(); ++i) {
    if (!angle_[i].points.empty()) active.set(i);
  }
  return active;
}

double DirectQueue::advance(Queue& queue, SimTime now) {
  while (!queue.points.empty() && queue.points.front().time <= now) {
    queue.last = queue.points.front();
    queue.points.erase(queue.points.begin());
  }
  if (queue.points.empty()) return queue.last.value;
  const TimedValue& next = queue.points.front();
  const double whole = toSeconds(next.time - queue.last.time);
  const double part = toSeconds(now - queue.last.time);
  return queue.last.value + (next.value - queue.last.value) * std::clamp(part / whole, 0.0, 1.0);
}

void DirectQueue::apply(SimTime now, JointArray<double>& angle) {
  for (std::size_t i = 0; i < angle_.size(); ++i) {
    if (!angle_[i].points.empty()) angle[i] = advance(angle_[i], now);
  }
}

void DirectQueue::clear() {
  for (Queue& queue : angle_) queue.points.clear();
  for (Queue& queue : stiffness_) queue.points.clear();
}

void DirectQueue::archive(Archive& archive) {
  for (auto* queues : {&angle_, &stiffness_}) {
    for (Queue& queue : *queues) {
      archive.each(queue.points, [&archive](TimedValue& point) {
        archive.value(point.time);
        archive.value(point.value);
      });
      if (queue.points.empty()) continue;
      archive.value(queue.last.time);
      archive.value(queue.last.value);
    }
  }
}

}  // namespace nao::motion

#include "motion/schedule.h"

#include <algorithm>

namespace nao::motion {
namespace {

// Free: far more than a program plans ahead, so that lost clients can not fill the memory.
constexpr std::size_t kMostWaiting = 1000;

}  // namespace

bool Schedule::add(Job job) {
  if (waiting_.size() == kMostWaiting) {
    end(job, MotionOutcome::Kind::Failed, "too many motions wait for their joints");
    return false;
  }
  waiting_.push_back(std::move(job));
  return true;
}

void Schedule::advance(double dt, Body& body) {
  startWaiting(body);
  std::vector<Job>::iterator job = running_.begin();
  while (job != running_.end()) {
    const Phase::Progress progress = job->phase->advance(dt, job->joints, body);
    if (progress == Phase::Progress::Running) {
      ++job;
      continue;
    }
    const bool failed = progress == Phase::Progress::Failed;
    end(*job, failed ? MotionOutcome::Kind::Failed : MotionOutcome::Kind::Done,
        failed ? job->phase->failure() : std::string());
    job = running_.erase(job);
  }
}

void Schedule::startWaiting(Body& body) {
  JointSet taken = booked();
  std::vector<Job>::iterator job = waiting_.begin();
  while (job != waiting_.end()) {
    const bool free = (job->joints & taken).none();
    taken |= job->joints;
    if (!free) {
      ++job;
      continue;
    }
    job->phase->begin(body);
    running_.push_back(std::move(*job));
    job = waiting_.erase(job);
  }
}

void Schedule::release(Joint joint) {
  for (Job& job : running_) job.joints.reset(index(joint));
}

bool Schedule::kill(RequestId id) {
  if (id == 0) return false;
  for (std::vector<Job>* jobs : {&running_, &waiting_}) {
    const auto job =
        std::find_if(jobs->begin(), jobs->end(), [id](const Job& j) { return j.id == id; });
    if (job == jobs->end()) continue;
    end(*job, MotionOutcome::Kind::Killed);
    jobs->erase(job);
    return true;
  }
  return false;
}

void Schedule::killAll() {
  for (std::vector<Job>* jobs : {&running_, &waiting_}) {
    for (const Job& job : *jobs) end(job, MotionOutcome::Kind::Killed);
    jobs->clear();
  }
}

JointSet Schedule::booked() const {
  JointSet joints;
  for (const Job& job : running_) joints |= job.joints;
  return joints;
}

std::vector<Task> Schedule::tasks() const {
  std::vector<Task> tasks;
  for (const Job& job : running_) {
    Task task{job.name, job.id, {}};
    for (std::size_t i = 0; i < kMaxJoints; ++i) {
      if (job.joints.test(i)) task.joints.push_back(toJoint(i));
    }
    tasks.push_back(std::move(task));
  }
  return tasks;
}

std::vector<MotionOutcome> Schedule::takeOutcomes() {
  std::vector<MotionOutcome> taken;
  taken.swap(outcomes_);
  return taken;
}

void Schedule::forgetCallers() {
  for (std::vector<Job>* jobs : {&running_, &waiting_}) {
    for (Job& job : *jobs) {
      job.id = 0;
      job.has_outcome = false;
    }
  }
  outcomes_.clear();
}

void Schedule::archive(Archive& archive) {
  for (std::vector<Job>* jobs : {&running_, &waiting_}) {
    archive.each(*jobs, [&archive](Job& job) {
      archive.value(job.joints);
      job.phase->archive(archive);
    });
  }
}

void Schedule::end(const Job& job, MotionOutcome::Kind kind, std::string reason) {
  if (job.has_outcome) outcomes_.push_back({job.id, kind, std::move(reason)});
}

}  // namespace nao::motion

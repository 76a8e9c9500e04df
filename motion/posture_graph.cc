#include "motion/posture_graph.h"

#include <algorithm>
#include <map>

#include "motion/posture_family.h"

namespace nao::motion {
namespace {

constexpr double kStill = 0.15;       // [rad/s] slower is at rest: a free choice above IMU noise
constexpr double kStillTime = 0.3;    // [s] of it
constexpr double kTimeToStill = 2.0;  // [s] after which a body that shakes counts as at rest

// One name per place of the graph.
std::string placeOf(const std::string& family) {
  return family == "Crouching" ? "Standing" : family;
}

double durationOf(const Way& way) {
  double time = 0;
  for (const WayKey& key : way.keys) time += key.time;
  return time;
}

struct Route {
  double time = 0;  // [s]
  std::vector<const Way*> ways;
};

bool leadsFrom(const Way& way, const std::string& place) {
  return std::any_of(way.from.begin(), way.from.end(),
                     [&](const std::string& family) { return placeOf(family) == place; });
}

// Goes on from every place known, until nothing gets any shorter.
bool shorten(const RobotModel& model, std::map<std::string, Route>& best) {
  bool shorter = false;
  for (const Way& way : model.ways) {
    for (const auto& [place, route] : std::map<std::string, Route>(best)) {
      if (!leadsFrom(way, place)) continue;
      const std::string there = placeOf(way.to);
      const double time = route.time + durationOf(way);
      const auto known = best.find(there);
      if (known != best.end() && known->second.time <= time) continue;
      Route longer = route;
      longer.time = time;
      longer.ways.push_back(&way);
      best[there] = longer;
      shorter = true;
    }
  }
  return shorter;
}

/// Keys at their times, each joint along a cubic that begins and ends at rest.
class FollowWay final : public Phase {
 public:
  explicit FollowWay(const Way& way) : way_(way) {}
  void begin(Body& body) override { start_ = body.angle; }
  Progress advance(double dt, const JointSet& mine, Body& body) override;
  std::string failure() const override { return "the way " + way_.name + " did not lead there"; }
  std::unique_ptr<Phase> clone() const override { return std::make_unique<FollowWay>(*this); }
  void archive(Archive& archive) override;

 private:
  void move(const WayKey& key, const JointSet& mine, Body& body) const;
  void takeKey(const WayKey& key, const Body& body);
  Progress comeToRest(double dt, const Body& body);

  const Way& way_;
  JointArray<double> start_;  // [rad] of the key under way
  std::size_t key_ = 0;
  double elapsed_ = 0;  // [s] of the key
  bool lost_ = false;   // a key was not met
  double resting_ = 0;  // [s] since the last key
  double still_ = 0;    // [s] of it without motion
};

void FollowWay::move(const WayKey& key, const JointSet& mine, Body& body) const {
  const double u = std::min(1.0, elapsed_ / key.time);
  const double part = u * u * (3 - 2 * u);
  for (const auto& [joint, angle] : key.angles) {
    if (!mine.test(index(joint))) continue;
    body.angle[joint] = start_[joint] + part * (angle - start_[joint]);
  }
}

void FollowWay::takeKey(const WayKey& key, const Body& body) {
  if (elapsed_ < key.time) return;
  const double pitch = torsoPitch(body.measured);
  const bool met = pitch >= key.pitch_low && pitch <= key.pitch_high;
  if (!met && elapsed_ < key.time + key.patience) return;
  lost_ = !met;
  ++key_;
  elapsed_ = 0;
  start_ = body.angle;
}

Phase::Progress FollowWay::advance(double dt, const JointSet& mine, Body& body) {
  if (lost_ || key_ == way_.keys.size()) return comeToRest(dt, body);
  elapsed_ += dt;
  const WayKey& key = way_.keys[key_];
  move(key, mine, body);
  takeKey(key, body);
  return Progress::Running;
}

Phase::Progress FollowWay::comeToRest(double dt, const Body& body) {
  resting_ += dt;
  still_ = body.measured.gyroscope.norm() < kStill ? still_ + dt : 0;
  if (still_ < kStillTime && resting_ < kTimeToStill) return Progress::Running;
  if (lost_) return Progress::Failed;
  const bool there = areOnePlace(bodyFamily(body.model, body.measured), way_.to);
  return there ? Progress::Done : Progress::Failed;
}

void FollowWay::archive(Archive& archive) {
  archive.value(start_);
  archive.value(key_);
  archive.value(elapsed_);
  archive.value(lost_);
  archive.value(resting_);
  archive.value(still_);
}

}  // namespace

std::optional<std::vector<const Way*>> findRoute(const RobotModel& model, const std::string& from,
                                                 const std::string& to) {
  std::map<std::string, Route> best{{placeOf(from), {}}};
  while (shorten(model, best)) {
  }
  const auto found = best.find(placeOf(to));
  if (found == best.end()) return std::nullopt;
  return found->second.ways;
}

const Way* findWayAround(const RobotModel& model, const std::string& family) {
  const std::string place = placeOf(family);
  for (const Way& way : model.ways) {
    if (placeOf(way.to) == place && leadsFrom(way, place)) return &way;
  }
  return nullptr;
}

bool areOnePlace(const std::string& a, const std::string& b) { return placeOf(a) == placeOf(b); }

std::unique_ptr<Phase> follow(const Way& way) { return std::make_unique<FollowWay>(way); }

}  // namespace nao::motion

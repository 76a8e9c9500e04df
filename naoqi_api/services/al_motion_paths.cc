#include "naoqi_api/services/al_motion_paths.h"

#include <algorithm>
#include <cmath>

#include "naoqi_api/call_error.h"
#include "naoqi_api/convert.h"
#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/finite.h"

namespace nao::services {
namespace {

using Items = std::vector<rpc::Value>;

constexpr double kMostCode = 1e6;  // no space or mask is near; what an int holds

bool isNested(const rpc::Value& value) {
  const Items* items = value.findItems();
  return items != nullptr && std::any_of(items->begin(), items->end(),
                                         [](const rpc::Value& item) { return item.isList(); });
}

std::vector<double> readNumbers(const rpc::Value& value) {
  const Items* items = value.findItems();
  std::vector<double> numbers;
  for (const rpc::Value& item : items ? *items : Items{value}) {
    const auto number = item.findNumber();
    if (!number) throw rpc::CallError("expected a number, got " + item.print());
    numbers.push_back(finite(*number));
  }
  return numbers;
}

// One per chain, or one for all.
std::vector<int> readCodes(const rpc::Value& value, std::size_t chains, const char* what) {
  std::vector<double> numbers = readNumbers(value);
  if (numbers.size() == 1) numbers.resize(chains, numbers[0]);
  if (numbers.size() != chains) {
    throw rpc::CallError(std::string("expected one ") + what + ", or one per effector");
  }
  std::vector<int> codes;
  for (const double number : numbers) {
    if (std::abs(number) > kMostCode) {
      throw rpc::CallError(std::string("no ") + what + ": " + rpc::Value(number).print());
    }
    codes.push_back(static_cast<int>(number));
  }
  return codes;
}

bool isListOfPaths(const rpc::Value& value) {
  return isNested(value) && isNested(value.findItems()->front());
}

// The poses of each chain, as far as they are written out.
std::vector<rpc::Value> splitPaths(const rpc::Value& paths, std::size_t chains) {
  if (chains == 1 && !isListOfPaths(paths)) return {paths};
  const Items* items = paths.findItems();
  if (items == nullptr || items->size() != chains) {
    throw rpc::CallError("expected one path per effector, for " + std::to_string(chains));
  }
  return *items;
}

std::vector<Pose> readPath(const rpc::Value& path, ReadPose read) {
  std::vector<Pose> poses;
  if (!isNested(path)) return {read(readNumbers(path))};
  for (const rpc::Value& pose : *path.findItems()) poses.push_back(read(readNumbers(pose)));
  return poses;
}

// A flat list belongs to all chains, unless each has one pose and a time of its own.
std::vector<double> timesOf(std::size_t chain, std::size_t chains, std::size_t poses,
                            const rpc::Value& times) {
  if (isNested(times)) {
    const Items& lists = *times.findItems();
    if (lists.size() != chains && lists.size() != 1) {
      throw rpc::CallError("expected one list of times per effector");
    }
    return readNumbers(lists.size() == 1 ? lists[0] : lists[chain]);
  }
  const std::vector<double> flat = readNumbers(times);
  if (poses == 1 && chains > 1 && flat.size() == chains) return {flat[chain]};
  return flat;
}

void checkTimes(const motion::PoseTrack& track) {
  if (track.times.size() != track.path.size()) {
    throw rpc::CallError("expected one time per pose of " + track.chain + ", got " +
                         std::to_string(track.times.size()) + " for " +
                         std::to_string(track.path.size()));
  }
  double before = 0;
  for (const double time : track.times) {
    if (time <= before) throw rpc::CallError("times must be positive and ascending");
    before = time;
  }
}

}  // namespace

Pose readPosition(const std::vector<double>& numbers) {
  if (numbers.size() != 6) {
    throw rpc::CallError("expected a position of 6 numbers, got " + std::to_string(numbers.size()));
  }
  Pose pose = translation({numbers[0], numbers[1], numbers[2]});
  pose.linear() = rotationFromRpy(numbers[3], numbers[4], numbers[5]);
  return pose;
}

Pose readTransform(const std::vector<double>& numbers) {
  if (numbers.size() != 12 && numbers.size() != 16) {
    throw rpc::CallError("expected a transform of 16 or 12 numbers, got " +
                         std::to_string(numbers.size()));
  }
  Mat3 rotation;
  Vec3 place;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      rotation(row, column) = numbers[static_cast<std::size_t>(4 * row + column)];
    }
    place[row] = numbers[static_cast<std::size_t>(4 * row + 3)];
  }
  constexpr double kTurned = 0.01;  // free: more than rounding, less than a mistake
  if (((rotation * rotation.transpose()) - Mat3::Identity()).norm() > kTurned ||
      rotation.determinant() < 0) {
    throw rpc::CallError("expected a transform whose 3 by 3 part is a rotation");
  }
  Pose pose = translation(place);
  pose.linear() = Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
  return pose;
}

std::vector<motion::PoseTrack> readTracks(const RobotModel& model, ReadPose read,
                                          const rpc::Value& chains, const rpc::Value& spaces,
                                          const rpc::Value& paths, const rpc::Value& masks,
                                          const rpc::Value& times) {
  const std::vector<std::string> names = readNames(chains);
  const std::vector<int> space = readCodes(spaces, names.size(), "space");
  const std::vector<int> mask = readCodes(masks, names.size(), "axis mask");
  const std::vector<rpc::Value> path = splitPaths(paths, names.size());
  std::vector<motion::PoseTrack> tracks;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!motion::findChain(model, names[i])) {
      throw rpc::CallError("unknown effector name: " + names[i]);
    }
    if (space[i] < 0 || space[i] > 2) {
      throw rpc::CallError("unknown space " + std::to_string(space[i]) +
                           ": 0 is the torso's, 1 the world's, 2 the robot's");
    }
    if (mask[i] < 1 || mask[i] > 63) {
      throw rpc::CallError("an axis mask is a sum of 1, 2, 4, 8, 16 and 32, got " +
                           std::to_string(mask[i]));
    }
    motion::PoseTrack track;
    track.chain = names[i];
    track.space = static_cast<motion::Space>(space[i]);
    track.mask = mask[i];
    track.path = readPath(path[i], read);
    track.times = timesOf(i, names.size(), track.path.size(), times);
    checkTimes(track);
    tracks.push_back(std::move(track));
  }
  if (tracks.empty()) throw rpc::CallError("expected the name of an effector");
  return tracks;
}

}  // namespace nao::services

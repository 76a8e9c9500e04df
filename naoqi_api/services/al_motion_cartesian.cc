#include "naoqi_api/services/al_motion_cartesian.h"

#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/al_motion_paths.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;

const Argument kChain{"chainName", "Head, LArm, RArm, LLeg, RLeg or Torso."};
const Argument kChains{"effectorNames", kChain.meaning + " One, or a list."};
const Argument kSpace{"space", "0: torso, 1: world (odometry), 2: robot."};
const Argument kMask{"axisMask", "Sum of 1 x, 2 y, 4 z, 8, 16, 32 the turns about them."};
const Argument kPath{"path", "A pose or a list of poses."};
const Argument kPaths{"paths", "A path per effector."};
const Argument kTimes{"durations", "Times [s], one per pose."};
const Argument kAbsolute{"isAbsolute", "False: the poses are changes along the axes of space."};
const Argument kFraction{"fractionMaxSpeed", "Part of the maximum speed, up to 1."};

rpc::Value asList(const std::vector<float>& numbers) {
  std::vector<rpc::Value> items(numbers.begin(), numbers.end());
  return rpc::Value::list(std::move(items));
}

}  // namespace

void AlMotionCartesian::declare(rpc::Service& service) {
  declareInterpolations(service, Form::Position);
  declareGoals(service, Form::Position);
  declareInterpolations(service, Form::Transform);
  declareGoals(service, Form::Transform);
}

void AlMotionCartesian::declareInterpolations(rpc::Service& service, Form form) {
  using Self = AlMotionCartesian;
  const bool position = form == Form::Position;
  constexpr Form kP = Form::Position;
  constexpr Form kT = Form::Transform;
  const std::string name = position ? "positionInterpolation" : "transformInterpolation";
  const std::string meaning = "Leads effectors through poses and waits until they are there.";
  const std::uint32_t uid = position ? 189 : 196;
  addMethod(service, name, this, position ? &Self::interpolateOne<kP> : &Self::interpolateOne<kT>,
            meaning, kChain, kSpace, kPath, kMask, kTimes, kAbsolute)
      .at(uid);
  addMethod(service, name + "s", this,
            position ? &Self::interpolateAll<kP> : &Self::interpolateAll<kT>, meaning, kChains,
            kSpace, kPaths, kMask, kTimes, kAbsolute)
      .at(uid + 1);
  addMethod(service, name + "s", this, position ? &Self::interpolate<kP> : &Self::interpolate<kT>,
            meaning, kChains, kSpace, kPaths, kMask, kTimes)
      .at(uid + 2);
}

void AlMotionCartesian::declareGoals(rpc::Service& service, Form form) {
  using Self = AlMotionCartesian;
  const bool position = form == Form::Position;
  constexpr Form kP = Form::Position;
  constexpr Form kT = Form::Transform;
  const std::string what = position ? "Position" : "Transform";
  const std::string meaning = "Starts moving effectors to poses and does not wait.";
  const std::uint32_t uid = position ? 192 : 199;
  const Argument pose{"pose", "6 numbers of a position, or 16 of a transform."};
  addMethod(service, "set" + what, this, position ? &Self::setOne<kP> : &Self::setOne<kT>, meaning,
            kChain, kSpace, pose, kFraction, kMask)
      .at(uid);
  addMethod(service, "set" + what + "s", this, position ? &Self::setAll<kP> : &Self::setAll<kT>,
            meaning, kChains, kSpace, kPaths, kFraction, kMask)
      .at(uid + 1);
  addMethod(service, "change" + what, this, position ? &Self::changeOne<kP> : &Self::changeOne<kT>,
            "Starts moving an effector by this much and does not wait.", kChain, kSpace, pose,
            kFraction, kMask)
      .at(uid + 2);
}

template <AlMotionCartesian::Form form>
rpc::Pending<void> AlMotionCartesian::interpolateOne(const std::string& chain, int space,
                                                     const rpc::Value& path, int mask,
                                                     const rpc::Value& times, bool is_absolute) {
  const ReadPose read = form == Form::Position ? readPosition : readTransform;
  return link_.postAndWait(motion::InterpolatePoses{
      readTracks(link_.model(), read, chain, space, path, mask, times), !is_absolute});
}

template <AlMotionCartesian::Form form>
rpc::Pending<void> AlMotionCartesian::interpolateAll(const std::vector<std::string>& chains,
                                                     int space, const rpc::Value& paths,
                                                     const rpc::Value& masks,
                                                     const rpc::Value& times, bool is_absolute) {
  const ReadPose read = form == Form::Position ? readPosition : readTransform;
  const rpc::Value names = rpc::Value::list(std::vector<rpc::Value>(chains.begin(), chains.end()));
  return link_.postAndWait(motion::InterpolatePoses{
      readTracks(link_.model(), read, names, space, paths, masks, times), !is_absolute});
}

template <AlMotionCartesian::Form form>
rpc::Pending<void> AlMotionCartesian::interpolate(const rpc::Value& chains,
                                                  const rpc::Value& spaces, const rpc::Value& paths,
                                                  const rpc::Value& masks,
                                                  const rpc::Value& times) {
  const ReadPose read = form == Form::Position ? readPosition : readTransform;
  return link_.postAndWait(motion::InterpolatePoses{
      readTracks(link_.model(), read, chains, spaces, paths, masks, times), false});
}

template <AlMotionCartesian::Form form>
void AlMotionCartesian::setOne(const std::string& chain, int space, const std::vector<float>& pose,
                               float fraction, int mask) {
  setAll<form>(chain, space, asList(pose), fraction, mask);
}

template <AlMotionCartesian::Form form>
void AlMotionCartesian::setAll(const rpc::Value& chains, const rpc::Value& spaces,
                               const rpc::Value& poses, float fraction, const rpc::Value& masks) {
  const ReadPose read = form == Form::Position ? readPosition : readTransform;
  link_.post(
      motion::SetPoses{readTracks(link_.model(), read, chains, spaces, poses, masks, rpc::Value(1)),
                       readFraction(fraction), false});
}

template <AlMotionCartesian::Form form>
void AlMotionCartesian::changeOne(const std::string& chain, int space,
                                  const std::vector<float>& change, float fraction, int mask) {
  const ReadPose read = form == Form::Position ? readPosition : readTransform;
  link_.post(motion::SetPoses{
      readTracks(link_.model(), read, chain, space, asList(change), mask, rpc::Value(1)),
      readFraction(fraction), true});
}

}  // namespace nao::services

#pragma once

#include "core/leds.h"
#include "core/members.h"
#include "core/robot_io.h"
#include "core/robot_model.h"
#include "core/world_model.h"
#include "motion/motion_request.h"
#include "runtime/world_request.h"
#include "sim/world.h"

// What a recorded run is written with: how many members its structs have (core/members.h). Who
// adds one corrects the number here; the compiler asks for it.

namespace nao {

// clang-format off
// Requests of motions.
template <> inline constexpr std::size_t kMembers<motion::MotionRequest> = 2;
template <> inline constexpr std::size_t kMembers<motion::SetAngles> = 4;
template <> inline constexpr std::size_t kMembers<motion::Handle> = 3;
template <> inline constexpr std::size_t kMembers<motion::Key> = 4;
template <> inline constexpr std::size_t kMembers<motion::Curve> = 2;
template <> inline constexpr std::size_t kMembers<motion::Interpolate> = 3;
template <> inline constexpr std::size_t kMembers<motion::InterpolateWithSpeed> = 3;
template <> inline constexpr std::size_t kMembers<motion::SetStiffness> = 2;
template <> inline constexpr std::size_t kMembers<motion::InterpolateStiffness::Track> = 3;
template <> inline constexpr std::size_t kMembers<motion::InterpolateStiffness> = 1;
template <> inline constexpr std::size_t kMembers<motion::GoToPosture> = 2;
template <> inline constexpr std::size_t kMembers<motion::GaitConfig> = 8;
template <> inline constexpr std::size_t kMembers<motion::Velocity2> = 3;
template <> inline constexpr std::size_t kMembers<motion::StepOrder> = 3;
template <> inline constexpr std::size_t kMembers<motion::MoveTo> = 3;
template <> inline constexpr std::size_t kMembers<motion::Move> = 2;
template <> inline constexpr std::size_t kMembers<motion::MoveToward> = 4;
template <> inline constexpr std::size_t kMembers<motion::WalkSteps> = 3;
template <> inline constexpr std::size_t kMembers<motion::SetMoveArms> = 2;
template <> inline constexpr std::size_t kMembers<motion::WalkFeedback> = 2;
template <> inline constexpr std::size_t kMembers<motion::SetWalkFeedback> = 1;
template <> inline constexpr std::size_t kMembers<motion::SetIdle> = 2;
template <> inline constexpr std::size_t kMembers<motion::SetBreath> = 2;
template <> inline constexpr std::size_t kMembers<motion::SetCollisionProtection> = 2;
template <> inline constexpr std::size_t kMembers<motion::SetFallManager> = 1;
template <> inline constexpr std::size_t kMembers<motion::SetSmartStiffness> = 1;
template <> inline constexpr std::size_t kMembers<motion::SetWalkProtection> = 2;
template <> inline constexpr std::size_t kMembers<motion::TimedValue> = 2;
template <> inline constexpr std::size_t kMembers<motion::DirectCommands::Track> = 3;
template <> inline constexpr std::size_t kMembers<motion::DirectCommands> = 2;
template <> inline constexpr std::size_t kMembers<motion::Kill> = 1;
template <> inline constexpr std::size_t kMembers<motion::PoseTrack> = 5;
template <> inline constexpr std::size_t kMembers<motion::InterpolatePoses> = 2;
template <> inline constexpr std::size_t kMembers<motion::SetPoses> = 3;
template <> inline constexpr std::size_t kMembers<motion::WbEnable> = 1;
template <> inline constexpr std::size_t kMembers<motion::WbFootState> = 2;
template <> inline constexpr std::size_t kMembers<motion::WbBalance> = 2;
template <> inline constexpr std::size_t kMembers<motion::WbGoToBalance> = 2;
template <> inline constexpr std::size_t kMembers<motion::WbEffector> = 2;
template <> inline constexpr std::size_t kMembers<motion::WbEffectorTarget> = 2;
template <> inline constexpr std::size_t kMembers<motion::WbOptimize> = 2;

// Other inputs.
template <> inline constexpr std::size_t kMembers<LedOrder> = 2;
template <> inline constexpr std::size_t kMembers<BodyCommand> = 3;
template <> inline constexpr std::size_t kMembers<runtime::PushRobot> = 3;
template <> inline constexpr std::size_t kMembers<runtime::PressSensor> = 3;
template <> inline constexpr std::size_t kMembers<runtime::PlaceRobot> = 2;
template <> inline constexpr std::size_t kMembers<runtime::PlaceBall> = 3;
template <> inline constexpr std::size_t kMembers<runtime::TakeSnapshot> = 1;
template <> inline constexpr std::size_t kMembers<runtime::RestoreSnapshot> = 1;
template <> inline constexpr std::size_t kMembers<runtime::DropSnapshot> = 1;
template <> inline constexpr std::size_t kMembers<runtime::KillJoint> = 3;
template <> inline constexpr std::size_t kMembers<runtime::FreezeSensor> = 3;
template <> inline constexpr std::size_t kMembers<runtime::DisturbSensor> = 4;
template <> inline constexpr std::size_t kMembers<runtime::HeatMotor> = 3;
template <> inline constexpr std::size_t kMembers<runtime::SetCharge> = 2;
template <> inline constexpr std::size_t kMembers<runtime::DirtyLens> = 3;
template <> inline constexpr std::size_t kMembers<runtime::WetFloor> = 5;

// Worlds and robots.
template <> inline constexpr std::size_t kMembers<Pose2> = 3;
template <> inline constexpr std::size_t kMembers<Color> = 3;
template <> inline constexpr std::size_t kMembers<Hull::Face> = 3;
template <> inline constexpr std::size_t kMembers<Hull> = 4;
template <> inline constexpr std::size_t kMembers<ObjMesh::Corner> = 3;
template <> inline constexpr std::size_t kMembers<ObjMesh> = 1;
template <> inline constexpr std::size_t kMembers<Texture::Level> = 3;
template <> inline constexpr std::size_t kMembers<Texture> = 1;
template <> inline constexpr std::size_t kMembers<Shape> = 7;
template <> inline constexpr std::size_t kMembers<GroundMark> = 6;
template <> inline constexpr std::size_t kMembers<Material> = 7;
template <> inline constexpr std::size_t kMembers<Obstacle> = 3;
template <> inline constexpr std::size_t kMembers<Ball> = 9;
template <> inline constexpr std::size_t kMembers<RobotPlace> = 4;
template <> inline constexpr std::size_t kMembers<WorldModel> = 13;
template <> inline constexpr std::size_t kMembers<Body> = 9;
template <> inline constexpr std::size_t kMembers<Coordinate> = 4;
template <> inline constexpr std::size_t kMembers<Actuator> = 13;
template <> inline constexpr std::size_t kMembers<CoupledLimit::Row> = 3;
template <> inline constexpr std::size_t kMembers<CoupledLimit> = 5;
template <> inline constexpr std::size_t kMembers<Frame> = 3;
template <> inline constexpr std::size_t kMembers<FootModel> = 4;
template <> inline constexpr std::size_t kMembers<SonarModel> = 5;
template <> inline constexpr std::size_t kMembers<BatteryModel> = 1;
template <> inline constexpr std::size_t kMembers<ContactSphere> = 3;
template <> inline constexpr std::size_t kMembers<Posture> = 3;
template <> inline constexpr std::size_t kMembers<WayKey> = 5;
template <> inline constexpr std::size_t kMembers<Way> = 4;
template <> inline constexpr std::size_t kMembers<EffectSetting> = 4;
template <> inline constexpr std::size_t kMembers<LensDistortion> = 4;
template <> inline constexpr std::size_t kMembers<CameraEffects> = 6;
template <> inline constexpr std::size_t kMembers<CameraModel> = 12;
template <> inline constexpr std::size_t kMembers<RobotModel> = 29;
template <> inline constexpr std::size_t kMembers<sim::RobotSetup> = 4;

// clang-format on

template <>
inline auto tieMembers(RobotModel& robot) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z, aa, bb, cc] =
      robot;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z, aa,
                  bb, cc);
}

}  // namespace nao

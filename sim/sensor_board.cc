#include "sim/sensor_board.h"

#include "sim/fsr.h"

namespace nao::sim {

SensorBoard::SensorBoard(const RobotModel& model, double gravity)
    : model_(model),
      imu_(model, gravity),
      heat_(model),
      battery_(model.battery),
      sonar_(model),
      touch_(model) {}

void SensorBoard::reset() {
  imu_.state() = {};
  heat_.reset();
  battery_.reset();
  sonar_.reset();
  touch_.reset();
}

SensorFrame SensorBoard::sample(const Surroundings& around, SimTime now, EffectChain& effects,
                                Faults& faults, const PhaseWatch* watch) {
  const auto ended = [watch](Phase phase) {
    if (watch) (*watch)(phase);
  };
  const RobotBody& body = *around.robots[around.self];
  const double dt = toSeconds(model_.cycle);
  SensorFrame frame;
  frame.time = now;
  frame.angle = JointArray<double>(model_.jointCount());
  for (std::size_t j = 0; j < model_.jointCount(); ++j) frame.angle[j] = body.angle(toJoint(j));
  heat_.sample(body.drive().torque(), dt, frame);
  battery_.sample(dt, frame);
  ended(Phase::Encoders);
  imu_.sample(body.motion(), model_.cycle, frame);
  effects.alterImu(frame, model_.cycle);
  faults.alterImu(frame);
  imu_.fuse(model_.cycle, frame);
  ended(Phase::Imu);
  frame.feet = calcFootForces(model_, body.motion(), body.groundForces());
  ended(Phase::FootForces);
  sonar_.sample(around, dt, frame);
  ended(Phase::Sonar);
  touch_.sample(around, now, frame);
  ended(Phase::Touch);
  effects.alterSensors(frame, model_.cycle);
  faults.alterSensors(frame);
  ended(Phase::SensorEffects);
  return frame;
}

void SensorBoard::archive(Archive& archive) {
  imu_.archive(archive);
  heat_.archive(archive);
  battery_.archive(archive);
  sonar_.archive(archive);
  touch_.archive(archive);
}

}  // namespace nao::sim

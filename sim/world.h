#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/robot_io.h"
#include "core/robot_model.h"
#include "core/scene_frame.h"
#include "core/sim_time.h"
#include "core/world_model.h"
#include "sim/contact_report.h"
#include "sim/mode.h"
#include "sim/phase.h"

namespace nao::sim {

class EffectCatalogue;

/// A robot as it enters a world.
struct RobotSetup {
  std::string name;
  std::shared_ptr<const RobotModel> model;
  Pose2 start;
  std::optional<Color> team = std::nullopt;  // of its shirt
};

/// The step divides every robot's cycle.
struct WorldOptions {
  /// A step alone is the common case.
  template <class Rep, class Period>
  WorldOptions(std::chrono::duration<Rep, Period> step_size) : step(step_size) {}  // NOLINT

  Duration step;
  Mode mode = Mode::Implicit;
  /// 0: every run is the same. Else the robots' `variation` is on and drawn from this seed.
  std::uint64_t seed = 0;
  const EffectCatalogue* effects = nullptr;  // null: standardEffects()
  bool any_step = false;  // also steps outside 1 to 5 ms: for experiments on the step itself
  PhaseWatch watch;       // of a profiler; empty: nobody watches
};

/// The physical world: robots, balls, ground and obstacles. The whole public face of sim/.
/// Belongs to one thread; same inputs, same outputs, to the last bit. Before the first command a
/// robot rests in its start posture with stiffness 0.
class World {
 public:
  /// @throws InputError if `step` is not 1 to 5 ms or does not divide every robot's cycle.
  /// Or if a robot's effects are not in the catalogue or, in the modes Rk4 and Reference, would
  /// need friction or play: these two have ideal drives.
  World(std::shared_ptr<const WorldModel> model, std::vector<RobotSetup> robots,
        WorldOptions options);
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  SimTime now() const;
  Duration stepSize() const;
  std::size_t robotCount() const;
  const RobotSetup& robot(std::size_t robot) const;
  const WorldModel& model() const;

  /// What the robot's motors follow from the next step on.
  void setCommand(std::size_t robot, const JointCommand& command);

  /// Moves everything on by one step.
  void step();

  /// What the robot's sensors report now; to be called once per cycle of that robot.
  SensorFrame readSensors(std::size_t robot);

  /// Where everything really is.
  SceneFrame scene() const;

  /// What pushed the robots in the last step.
  const ContactReport& contacts() const;

  /// False once a number is no longer finite; step() then does nothing any more.
  bool healthy() const;

  /// Pushes the torso with `force_W` [N] for `duration`.
  void push(std::size_t robot, const Vec3& force_W, Duration duration);
  /// A finger on a bumper, tactile sensor or button, by NaoQi's device name ("Head/Touch/Front").
  /// @throws InputError that lists the names this robot has.
  void press(std::size_t robot, const std::string& sensor, Duration duration);
  /// Lights some of the robot's lights (see findLeds()): `brightness` 0 dark to 1, held within.
  /// False if it has none of that name.
  bool setLeds(std::size_t robot, const std::string& leds, float brightness);
  /// What breaks, until `duration` has passed; laws and sensors' names: sim/faults.h.
  void killJoint(std::size_t robot, Joint joint, Duration duration);
  /// @throws InputError that lists the sensors this robot has, as disturbSensor().
  void freezeSensor(std::size_t robot, const std::string& sensor, Duration duration);
  /// `sd` of the noise in the sensor's unit (core/robot_io.h).
  void disturbSensor(std::size_t robot, const std::string& sensor, double sd, Duration duration);
  /// As if a motor had come to a temperature [deg C].
  void heatMotor(std::size_t robot, Joint joint, double temperature);
  /// As if the battery had come to a charge, 0 to 1.
  void setCharge(std::size_t robot, double charge);
  /// From 0, clean, to 1: nothing is seen through it any more.
  void dirtyLens(std::size_t robot, std::size_t camera, double dirt);
  /// Water on the floor until `duration` has passed; one more patch.
  void wetFloor(const Eigen::Vector2d& center_W, double radius, double friction, Duration duration);
  /// Puts a robot down at rest in its start posture, or in `angles`.
  void placeRobot(std::size_t robot, const Pose2& pose, const JointArray<double>* angles = nullptr);
  /// Puts a ball there; one that would be in the ground is lifted onto it, and one that lies on it
  /// rolls as fast as it moves.
  void placeBall(std::size_t ball, const Vec3& p_W, const Vec3& v_W);
  /// Everything back to how the world began; time goes on.
  void reset();

  /// What this run's seed has drawn, by "robot.effect.name"; empty without a seed.
  std::map<std::string, double> draw() const;

  /// A number that two runs share only if they are in the same state to the last bit.
  std::uint64_t hash() const;

  /// A complete state, to be restored into this world or one made alike.
  class Snapshot;
  std::shared_ptr<const Snapshot> snapshot() const;
  void restore(const Snapshot& snapshot);

  /// What a robot's motors gave in the last step, the truth, for experiments.
  struct Motors {
    JointArray<double> torque;   // [N m]
    JointArray<bool> saturated;  // their servo was held at its limit; not part of the state
  };
  Motors motors(std::size_t robot) const;

  /// The largest depth [m] by which any point of the robot is in the ground now.
  double penetration(std::size_t robot) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace nao::sim

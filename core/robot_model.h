#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/camera_model.h"
#include "core/frames.h"
#include "core/joint.h"
#include "core/shape.h"
#include "core/sim_time.h"

namespace nao {

/// One rigid link. Body 0 is the root (Torso); every other hangs on its parent by one hinge, and
/// a parent always comes before its children.
struct Body {
  std::string name;
  int parent = -1;
  Pose X_PB = Pose::Identity();  // in the parent, at hinge angle 0
  Vec3 axis = Vec3::UnitZ();     // hinge axis in B, unit
  double mass = 0;               // [kg]
  Vec3 p_BoBcm = Vec3::Zero();   // [m] centre of mass, in B
  Mat3 I_Bcm = Mat3::Zero();     // [kg m^2] about the centre of mass, axes of B
  std::vector<Shape> visuals;
  std::vector<Shape> collisions;
};

/// The hinge of body i+1. Coordinates that share a joint move together (HipYawPitch).
struct Coordinate {
  std::string name;  // of the hinge, e.g. RHipYawPitch
  Joint joint{};     // the motor that drives it
  double lower = 0;  // [rad] mechanical stop
  double upper = 0;  // [rad]
};

/// A motor and its gear, seen at the joint.
struct Actuator {
  std::string name;              // NaoQi's, e.g. LHipYawPitch
  std::vector<int> coordinates;  // hinges it turns: one, two (HipYawPitch), none (hands)
  double lower = 0;              // [rad] command range; hands 0..1
  double upper = 0;              // [rad]
  double max_velocity = 0;       // [rad/s] as getLimits reports, base of fractionMaxSpeed
  double max_torque = 0;         // [N m]   as getLimits reports
  double stall_torque = 0;       // [N m] at the joint, before efficiency
  double no_load_speed = 0;      // [rad/s] at the joint
  double efficiency = 0.7;       // of the gear
  double rotor_inertia = 0;      // [kg m^2] reflected to the joint
  double kp = 0;                 // [N m/rad]
  double kd = 0;                 // [N m s/rad]
  int board = -1;                // motors of one board go free together; -1: a board of its own
};

/// The range of one joint depends on the angle of another: linear between rows.
struct CoupledLimit {
  struct Row {
    double driver = 0;  // [rad] ascending
    double min = 0;     // [rad]
    double max = 0;     // [rad]
  };
  Joint driver{};
  Joint limited{};
  std::vector<Row> rows;
  bool stop = true;  // the joint meets it
  bool clip = true;  // commands are clipped to it, as NAOqi does

  /// The range of the limited joint at this angle of the driver; ends are held.
  std::pair<double, double> rangeAt(double driver_angle) const;
};

/// A named place on a body: soles, IMU, cameras.
struct Frame {
  std::string name;
  int body = 0;
  Pose X_BF = Pose::Identity();
};

/// A foot: where it touches the ground and where it feels it.
struct FootModel {
  int body = 0;                          // ankle roll link
  Pose X_BS = Pose::Identity();          // sole frame
  std::vector<Eigen::Vector2d> outline;  // [m] in the sole frame, counter-clockwise
  std::array<Vec3, 4> fsr;               // [m] in the ankle frame: FL, FR, RL, RR
};

/// The ultrasonic sensors. Transmitters and receivers are frames that look along their x axis.
struct SonarModel {
  double min_range = 0;           // [m] nearer things are there, no more is known
  double max_range = 0;           // [m] what no echo reports
  double half_cone = 0;           // [rad] about the x axis of a transmitter
  std::vector<int> transmitters;  // indices of RobotModel::frames, left first; none: no sonar
  std::vector<int> receivers;     // likewise
};

struct BatteryModel {
  double capacity_ah = 2.25;  // [A h]
};

/// A sphere of a body that touches the ground (a foot's corners are not among them).
struct ContactSphere {
  int body = 0;
  Vec3 p_B = Vec3::Zero();
  double radius = 0;  // [m]
};

/// A named set of joint angles.
struct Posture {
  std::string name;
  std::string family;
  JointArray<double> angle;  // [rad]
};

/// One stop on a way: some joints get there together, the others stay as they are told.
struct WayKey {
  double time = 0;                               // [s] after the stop before
  std::vector<std::pair<Joint, double>> angles;  // [rad]
  /// The torso's pitch [rad] at which the way goes on: 0 upright, + forward, +-pi upside down.
  double pitch_low = -4;
  double pitch_high = 4;
  double patience = 0;  // [s] for which the robot holds still until it is so, before it gives up
};

/// A motion from being in one family of postures to being in another: up from the back, down to
/// the seat.
struct Way {
  std::string name;
  std::vector<std::string> from;  // families
  std::string to;                 // family
  std::vector<WayKey> keys;
};

/// An imperfection that a robot's file asks for. sim/effects/ knows the name and its law, and
/// checks the numbers when a world is made.
struct EffectSetting {
  std::string name;                          // in the catalogue
  std::map<std::string, double> parameters;  // those that differ from their nominal value
  std::vector<Joint> joints;                 // it acts on these; empty: on all
  std::string place;                         // "file:line" that asked for it
};

/// Everything fixed about a robot, read from robots/<name>/. Immutable once loaded.
struct RobotModel {
  std::string name;         // nao_h21_v33
  std::string body_type;    // "H21", "H25" (RobotConfig), or the file's own
  std::string version;      // "V3.3"
  Duration cycle{};         // between two exchanges of command and frame
  bool fixed_base = false;  // an arm bolted to the floor

  std::vector<Body> bodies;
  std::vector<Coordinate> coordinates;  // coordinates[i] belongs to bodies[i + 1]
  std::vector<Actuator> actuators;      // indexed by Joint
  std::vector<CoupledLimit> coupled_limits;
  std::vector<Frame> frames;
  std::vector<CameraModel> cameras;
  std::vector<FootModel> feet;  // none, or left and right
  std::vector<ContactSphere> contact_spheres;
  std::vector<Posture> postures;
  std::string start_posture;
  std::vector<Way> ways;  // between families of postures

  int imu_body = 0;
  Vec3 p_BoImu = Vec3::Zero();
  int gyro_axes = 3;  // 2 on V3.x and V4
  SonarModel sonar;
  BatteryModel battery;

  std::vector<EffectSetting> effects;    // always on
  std::vector<EffectSetting> variation;  // on in runs that have a seed: why real runs differ
  /// Why repeats of one motion by one robot differ: on only where such runs are asked for.
  std::vector<EffectSetting> noise;
  double start_sd = 0;  // [s] by which a run's commands come late or early, the same kind of noise
  /// Bodies that never touch each other, the lower number first: the two of every hinge, and
  /// those the file names because their solids overlap where the real ones do not.
  std::vector<std::pair<int, int>> no_collision;
  /// What the files left open and how it was filled in, one sentence each: for the user.
  std::vector<std::string> notes;

  /// NaoQi's names, in NaoQi's order; "Body" has RHipYawPitch although there is no such motor.
  std::map<std::string, std::vector<std::string>> groups;
  /// Names that stand for another actuator: RHipYawPitch -> LHipYawPitch.
  std::map<std::string, std::string> aliases;

  std::size_t jointCount() const { return actuators.size(); }
  double totalMass() const;  // [kg]

  /// The actuator of this name or alias.
  std::optional<Joint> findJoint(std::string_view name) const;
  std::optional<int> findBody(std::string_view name) const;
  const Posture* findPosture(std::string_view name) const;
};

/// Reads robots/<name>/ below `robots_dir`: model.urdf, body.yaml, postures.yaml, ways.yaml,
/// cameras.yaml; or, if `name` is a path that ends in .urdf, that file. A URDF alone is completed
/// by defaults (core/robot_model_bare.cc), told in RobotModel::notes.
/// @throws InputError naming file and line; for an unknown name it lists the known ones.
std::shared_ptr<const RobotModel> loadRobotModel(const std::string& robots_dir,
                                                 const std::string& name);

}  // namespace nao

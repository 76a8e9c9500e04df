#pragma once

#include <optional>
#include <string>

#include "core/config.h"
#include "core/config_node.h"
#include "core/robot_model.h"
#include "core/robot_model_urdf.h"

namespace nao {

// The files of a robot's folder, one reader each. All throw InputError with file and line.

/// Where a robot is described. One that is `like:` another takes from that one's folder the files
/// it does not have, and from its body.yaml the top-level keys it does not give; and so on.
struct RobotFiles {
  std::string urdf;
  std::optional<ConfigNode> body;  // absent: a URDF alone
  std::string postures;            // empty: none
  std::string ways;                // empty: none
  std::string cameras;             // empty: none
};
RobotFiles findRobotFiles(const std::string& robots_dir, const std::string& name);

/// body.yaml: what a URDF can not say. Fills everything but postures and cameras.
void readBody(const ConfigNode& file, const UrdfRobot& urdf, RobotModel& model);

/// The `solids` of body.yaml, which take the place of the masses of the URDF:
/// `Torso: {mass, com: [x, y, z], inertia_at_origin: [xx, yy, zz, xy, xz, yz]}` with the tensor
/// about the link's origin, as NAOqi's tables have it, or `inertia_at_com`. Axes of the link.
void readSolids(Config& body, RobotModel& model);

/// Lets two bodies never touch each other.
void forbidContact(int a, int b, RobotModel& model);

/// The `no_collision` of body.yaml: `[[link, link], ...]`.
void readNoCollision(Config& body, RobotModel& model);

/// The groups every robot has, whatever its file says.
void addDefaultGroups(RobotModel& model);

/// Gives each hinge to the motor of its name, or of the hinge it mimics; and the aliases.
void connectHinges(const UrdfRobot& urdf, RobotModel& model);

/// Fills in what body.yaml would have said, all of it told in `notes`.
void assumeBody(const UrdfRobot& urdf, RobotModel& model);

/// Tells in `notes` which bodies touch nothing, and forbids the two bodies of a hinge to touch.
void finishCollisions(const UrdfRobot& urdf, RobotModel& model);

/// The `drives` and `actuators` of body.yaml, and with them the coordinates and aliases.
void readActuators(Config& body, const UrdfRobot& urdf, RobotModel& model);

/// The list at `key`: `- {effect: name, joints: [names or groups], parameter: number, ...}`.
std::vector<EffectSetting> readEffects(Config& body, const std::string& key,
                                       const RobotModel& model);

/// postures.yaml; every posture gives every actuator an angle within its range.
void readPostures(const std::string& file, RobotModel& model);

/// ways.yaml, one `{name, from: [families], to: family, keys: [...]}` per way; needs the postures.
/// A key is `{time, pitch: [low, high], patience, angles: {joint: rad}}`. A joint named without its
/// side means both of a Nao, the right one mirrored: rolls and yaws change their sign.
void readWays(const std::string& file, RobotModel& model);

/// cameras.yaml; each camera is a frame of the model as well.
void readCameras(const std::string& file, RobotModel& model);

/// What is wrong with a body that moves, or nothing.
std::string flawOf(const Body& body);

/// The inertia tensor nearest to this one that obeys the triangle inequality, as a solid's does.
Mat3 nearestSolid(const Mat3& inertia);

/// Throws InputError unless every body could exist: mass above zero, inertia positive definite
/// and obeying the triangle inequality. A body 0 that is bolted down may be without mass.
void checkBodies(const UrdfRobot& urdf, const RobotModel& model);

/// The joint or body named at `key`, else an InputError.
Joint jointAt(Config& config, const std::string& key, const RobotModel& model);
int bodyAt(Config& config, const std::string& key, const RobotModel& model);

}  // namespace nao

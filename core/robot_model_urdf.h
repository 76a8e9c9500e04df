#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/robot_model.h"

namespace nao {

/// What a URDF says of one hinge. Hinge i turns body i+1 of the same file.
struct UrdfHinge {
  std::string name;
  std::string mimics;       // the hinge it follows one to one, or empty
  double lower = 0;         // [rad]
  double upper = 0;         // [rad]
  double max_velocity = 0;  // [rad/s]
  double max_torque = 0;    // [N m]
  int line = 0;             // of its <joint>
};

/// A URDF as the model wants it: links joined by fixed joints are one body, and each link that
/// was joined so is a frame of that body. Parents come before children, children in file order.
/// Boxes, cylinders and spheres are kept, meshes left out. URDF knows no capsules: a cylinder in a
/// <collision> whose name ends in "capsule" has round ends, its length going from tip to tip.
struct UrdfRobot {
  std::string file;
  bool floats = false;  // the file says itself that the root moves freely
  std::vector<Body> bodies;
  std::vector<int> body_lines;  // of each body's <link>
  std::vector<bool> has_mesh;   // each body: whether a collision mesh was left out
  std::vector<Frame> frames;
  std::vector<UrdfHinge> hinges;
};

/// Joints are revolute, continuous or fixed; a mimic joint follows one to one; the two ends of a
/// range may come in either order, as they do in the wild. One floating joint may stand between an
/// empty root and the rest: then the rest is the robot.
/// Call from one thread at a time: the URDF library reports through a process-wide handler.
/// @throws InputError naming file and line.
UrdfRobot readUrdf(const std::string& file);

/// The lines of a URDF's links and joints, after a check of what the URDF library passes over or
/// reports without a place: XML syntax, names, references, joint types, numbers in attributes.
struct UrdfLines {
  std::map<std::string, int> links;
  std::map<std::string, int> joints;
};
UrdfLines checkUrdf(const std::string& file, const std::string& xml);

}  // namespace nao

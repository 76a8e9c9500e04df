#include "core/robot_model_urdf.h"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "core/check.h"
#include "core/config_node.h"

namespace nao {
namespace {

constexpr double kEndless = 1e6;     // [rad] stops of a continuous joint: never reached
constexpr double kSameRatio = 1e-3;  // a mimic's ratio this near to 1 is 1, rounded

// Catches what the URDF library would print, for as long as this object lives.
class Complaints : public console_bridge::OutputHandler {
 public:
  Complaints() { console_bridge::useOutputHandler(this); }
  ~Complaints() override { console_bridge::restorePreviousOutputHandler(); }
  Complaints(const Complaints&) = delete;
  Complaints& operator=(const Complaints&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && first_.empty()) first_ = text;
  }
  const std::string& first() const { return first_; }

 private:
  std::string first_;
};

Vec3 toVec3(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

Pose toPose(const urdf::Pose& urdf_pose) {
  Pose pose = translation(toVec3(urdf_pose.position));
  const urdf::Rotation& q = urdf_pose.rotation;
  pose.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  return pose;
}

Color toColor(const urdf::MaterialSharedPtr& material) {
  if (!material) return {};
  const auto byte = [](float part) {
    return static_cast<unsigned char>(std::lround(std::clamp(part, 0.0F, 1.0F) * 255));
  };
  return {byte(material->color.r), byte(material->color.g), byte(material->color.b)};
}

// The shape of a visual or collision; false for meshes and empty geometry.
bool toShape(const urdf::GeometrySharedPtr& geometry, const Pose& X_BS, Shape& shape) {
  if (!geometry) return false;
  shape.X_BS = X_BS;
  if (geometry->type == urdf::Geometry::SPHERE) {
    shape.kind = Shape::Kind::Sphere;
    shape.size.x() = static_cast<const urdf::Sphere&>(*geometry).radius;
  } else if (geometry->type == urdf::Geometry::BOX) {
    shape.kind = Shape::Kind::Box;
    shape.size = toVec3(static_cast<const urdf::Box&>(*geometry).dim);
  } else if (geometry->type == urdf::Geometry::CYLINDER) {
    const auto& cylinder = static_cast<const urdf::Cylinder&>(*geometry);
    shape.kind = Shape::Kind::Cylinder;
    shape.size = Vec3(cylinder.radius, 0, cylinder.length);
  } else {
    return false;
  }
  return true;
}

// The inertia of a point mass at p about the origin.
Mat3 pointInertia(double mass, const Vec3& p) {
  return mass * (p.squaredNorm() * Mat3::Identity() - p * p.transpose());
}

// Adds a link's mass to the body it is part of.
void addInertial(const urdf::Inertial& inertial, const Pose& X_BL, Body& body) {
  const Pose X_BI = X_BL * toPose(inertial.origin);
  Mat3 I_Icm;
  I_Icm << inertial.ixx, inertial.ixy, inertial.ixz,  //
      inertial.ixy, inertial.iyy, inertial.iyz,       //
      inertial.ixz, inertial.iyz, inertial.izz;
  const double total = body.mass + inertial.mass;
  if (total <= 0) return;
  const Vec3 com = (body.mass * body.p_BoBcm + inertial.mass * X_BI.translation()) / total;
  body.I_Bcm += pointInertia(body.mass, body.p_BoBcm - com) +
                X_BI.linear() * I_Icm * X_BI.linear().transpose() +
                pointInertia(inertial.mass, X_BI.translation() - com);
  body.mass = total;
  body.p_BoBcm = com;
}

bool endsIn(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// Round ends for the cylinders called capsules, within their length.
void roundEnds(const urdf::Collision& collision, Shape& shape) {
  if (shape.kind != Shape::Kind::Cylinder || !endsIn(collision.name, "capsule")) return;
  shape.kind = Shape::Kind::Capsule;
  shape.size.z() = std::max(0.0, shape.size.z() - 2 * shape.size.x());
}

// True if there was a collision that is no solid of ours.
bool addShapes(const urdf::Link& link, const Pose& X_BL, Body& body) {
  Shape shape;
  for (const auto& visual : link.visual_array) {
    if (!toShape(visual->geometry, X_BL * toPose(visual->origin), shape)) continue;
    shape.color = toColor(visual->material);
    body.visuals.push_back(shape);
  }
  bool left_out = false;
  for (const auto& collision : link.collision_array) {
    if (!toShape(collision->geometry, X_BL * toPose(collision->origin), shape)) {
      left_out = true;
      continue;
    }
    shape.color = {};
    roundEnds(*collision, shape);
    body.collisions.push_back(shape);
  }
  return left_out;
}

class Builder {
 public:
  Builder(const std::string& file, const UrdfLines& lines) : lines_(lines) { robot_.file = file; }

  UrdfRobot build(const urdf::Link& root) {
    const urdf::Link* first = &root;
    if (root.child_joints.size() == 1 && root.child_joints[0]->type == urdf::Joint::FLOATING) {
      first = root.child_links[0].get();
      robot_.floats = true;
    }
    startBody(*first, -1, Pose::Identity());
    addLink(*first, 0, Pose::Identity());
    return std::move(robot_);
  }

 private:
  void startBody(const urdf::Link& link, int parent, const Pose& X_PB) {
    Body body;
    body.name = link.name;
    body.parent = parent;
    body.X_PB = X_PB;
    robot_.bodies.push_back(body);
    robot_.body_lines.push_back(lines_.links.at(link.name));
    robot_.has_mesh.push_back(false);
  }

  void addLink(const urdf::Link& link, int body_index, const Pose& X_BL) {
    Body& body = robot_.bodies[static_cast<std::size_t>(body_index)];
    if (link.name != body.name) robot_.frames.push_back({link.name, body_index, X_BL});
    if (link.inertial) addInertial(*link.inertial, X_BL, body);
    if (addShapes(link, X_BL, body)) robot_.has_mesh[static_cast<std::size_t>(body_index)] = true;
    for (const auto& [joint, child] : childrenInFileOrder(link)) {
      const Pose X_BJ = X_BL * toPose(joint->parent_to_joint_origin_transform);
      if (joint->type == urdf::Joint::FIXED) {
        addLink(*child, body_index, X_BJ);
      } else {
        addHinge(*joint, *child, body_index, X_BJ);
      }
    }
  }

  using Child = std::pair<urdf::JointSharedPtr, urdf::LinkSharedPtr>;
  std::vector<Child> childrenInFileOrder(const urdf::Link& link) const {
    std::vector<Child> children;
    for (std::size_t i = 0; i < link.child_links.size(); ++i) {
      children.emplace_back(link.child_links[i]->parent_joint, link.child_links[i]);
    }
    std::sort(children.begin(), children.end(), [this](const Child& a, const Child& b) {
      return lines_.joints.at(a.first->name) < lines_.joints.at(b.first->name);
    });
    return children;
  }

  void addHinge(const urdf::Joint& joint, const urdf::Link& child, int parent, const Pose& X_PB) {
    startBody(child, parent, X_PB);
    const int index = static_cast<int>(robot_.bodies.size()) - 1;
    const Vec3 axis = toVec3(joint.axis);
    if (axis.norm() < 1e-6) fail(joint, "`axis`: expected a direction, found 0 0 0");
    robot_.bodies.back().axis = axis.normalized();
    robot_.hinges.push_back(toHinge(joint));
    addLink(child, index, Pose::Identity());
  }

  UrdfHinge toHinge(const urdf::Joint& joint) const {
    UrdfHinge hinge;
    hinge.name = joint.name;
    hinge.line = lines_.joints.at(joint.name);
    const bool endless = joint.type == urdf::Joint::CONTINUOUS;
    hinge.lower = endless ? -kEndless : std::min(joint.limits->lower, joint.limits->upper);
    hinge.upper = endless ? kEndless : std::max(joint.limits->lower, joint.limits->upper);
    if (joint.limits) {
      hinge.max_velocity = joint.limits->velocity;
      hinge.max_torque = joint.limits->effort;
    }
    if (joint.mimic) {
      if (std::abs(joint.mimic->multiplier - 1) > kSameRatio || joint.mimic->offset != 0) {
        fail(joint, "`mimic`: expected multiplier 1 and offset 0, one motor turns both alike");
      }
      hinge.mimics = joint.mimic->joint_name;
    }
    return hinge;
  }

  [[noreturn]] void fail(const urdf::Joint& joint, const std::string& sentence) const {
    throw InputError(complaint(robot_.file, lines_.joints.at(joint.name), sentence));
  }

  const UrdfLines& lines_;
  UrdfRobot robot_;
};

std::string readText(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file + ": can not be read");
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

UrdfRobot readUrdf(const std::string& file) {
  const std::string xml = readText(file);
  const UrdfLines lines = checkUrdf(file, xml);
  const Complaints complaints;
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(xml);
  if (!model || !model->getRoot()) {
    throw InputError(complaint(file, 1, "not a robot tree: " + complaints.first()));
  }
  return Builder(file, lines).build(*model->getRoot());
}

}  // namespace nao

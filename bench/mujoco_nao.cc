#include "bench/mujoco_nao.h"

#include <mujoco/mujoco.h>

#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "core/check.h"

namespace nao::bench {
namespace {

std::string text(const Vec3& v) {
  std::ostringstream out;
  out.precision(12);
  out << v.x() << ' ' << v.y() << ' ' << v.z();
  return out.str();
}

// MJCF of one robot on a plane.
class Writer {
 public:
  Writer(const RobotModel& model, double step) : model_(model) {
    out_.precision(12);
    out_ << "<mujoco><compiler angle='radian' autolimits='true'/><option timestep='" << step
         << "' integrator='Euler' solver='Newton' gravity='0 0 -9.80665'/><worldbody>"
         << "<geom type='plane' size='20 20 1' conaffinity='0' friction='0.7 0.005 0.0001'/>";
    writeBody(0);
    out_ << "</worldbody><equality>";
    for (const Actuator& a : model.actuators) {
      if (a.coordinates.size() != 2) continue;
      out_ << "<joint joint1='" << nameOf(a.coordinates[0]) << "' joint2='"
           << nameOf(a.coordinates[1]) << "'/>";
    }
    out_ << "</equality><actuator>";
    for (const Actuator& a : model.actuators) writeMotor(a);
    out_ << "</actuator><contact>";
    for (const auto& [a, b] : model.no_collision) {
      out_ << "<exclude body1='" << bodyName(a) << "' body2='" << bodyName(b) << "'/>";
    }
    out_ << "</contact></mujoco>";
  }
  std::string xml() const { return out_.str(); }

 private:
  std::string nameOf(int coordinate) const {
    return model_.coordinates[static_cast<std::size_t>(coordinate)].name;
  }

  std::string bodyName(int body) const {
    return model_.bodies[static_cast<std::size_t>(body)].name;
  }

  void writeBody(int index) {
    const Body& body = model_.bodies[static_cast<std::size_t>(index)];
    out_ << "<body name='" << body.name << "' pos='" << text(Vec3(body.X_PB.translation())) << "'>";
    if (index == 0) out_ << "<freejoint/>";
    if (index > 0) writeHinge(index - 1, body);
    const Mat3& I = body.I_Bcm;
    out_ << "<inertial mass='" << body.mass << "' pos='" << text(body.p_BoBcm) << "' fullinertia='"
         << I(0, 0) << ' ' << I(1, 1) << ' ' << I(2, 2) << ' ' << I(0, 1) << ' ' << I(0, 2) << ' '
         << I(1, 2) << "'/>";
    writeContacts(index);
    for (const Shape& solid : body.collisions) writeSolid(solid);
    for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
      if (model_.bodies[i].parent == index) writeBody(static_cast<int>(i));
    }
    out_ << "</body>";
  }

  void writeHinge(int coordinate, const Body& body) {
    const Coordinate& c = model_.coordinates[static_cast<std::size_t>(coordinate)];
    const Actuator& motor = model_.actuators[index(c.joint)];
    const double share = 1.0 / static_cast<double>(motor.coordinates.size());
    out_ << "<joint name='" << c.name << "' axis='" << text(body.axis) << "' range='" << c.lower
         << ' ' << c.upper << "' armature='" << share * motor.rotor_inertia << "'/>";
  }

  // The plane is of contype 1. Points meet it alone, as ours do (conaffinity 1, contype 0); solids
  // meet each other (2, 2).
  void writePoint(const Vec3& p, double radius) {
    // As stiff as ours: eight corners of 30 kN/m under a Nao answer within 5 ms.
    out_ << "<geom type='sphere' size='" << radius << "' pos='" << text(p)
         << "' contype='0' conaffinity='1' mass='0' solref='0.005 1' friction='0.7 0.005 0.0001'/>";
  }

  void writeSolid(const Shape& solid) {
    const Eigen::Quaterniond q(solid.X_BS.linear());
    out_ << "<geom contype='2' conaffinity='2' mass='0' friction='0.7 0.005 0.0001' pos='"
         << text(Vec3(solid.X_BS.translation())) << "' quat='" << q.w() << ' ' << q.x() << ' '
         << q.y() << ' ' << q.z() << "' type='";
    const Vec3 half = solid.size / 2;
    switch (solid.kind) {
      case Shape::Kind::Sphere:
        out_ << "sphere' size='" << solid.size.x() << "'/>";
        return;
      case Shape::Kind::Box:
        out_ << "box' size='" << text(half) << "'/>";
        return;
      case Shape::Kind::Cylinder:
        out_ << "cylinder' size='" << solid.size.x() << ' ' << half.z() << "'/>";
        return;
      case Shape::Kind::Capsule:
        // MuJoCo knows no capsule without length, which is a sphere.
        if (half.z() < 1e-6) {
          out_ << "sphere' size='" << solid.size.x() << "'/>";
        } else {
          out_ << "capsule' size='" << solid.size.x() << ' ' << half.z() << "'/>";
        }
        return;
      case Shape::Kind::Hull:
        NAO_CHECK(false);  // no robot of the benchmark has one
    }
  }

  void writeContacts(int body) {
    constexpr double kCorner = 0.002;  // [m] MuJoCo has no points
    for (const FootModel& foot : model_.feet) {
      if (foot.body != body) continue;
      for (const double x : {-0.045, 0.09}) {
        for (const double y : {-0.035, 0.035}) {
          writePoint(foot.X_BS * Vec3(x, y, kCorner), kCorner);
        }
      }
    }
    for (const ContactSphere& sphere : model_.contact_spheres) {
      if (sphere.body == body) writePoint(sphere.p_B, sphere.radius);
    }
  }

  void writeMotor(const Actuator& a) {
    if (a.coordinates.empty()) return;
    const double limit = a.efficiency * a.stall_torque;
    // As in our drives the limit is on stiffness and damping together: the walk leads its commands
    // by what the damping holds back.
    out_ << "<general joint='" << nameOf(a.coordinates.front()) << "' gainprm='" << a.kp
         << "' biastype='affine' biasprm='0 " << -a.kp << ' ' << -a.kd << "' forcerange='" << -limit
         << ' ' << limit << "'/>";
  }

  const RobotModel& model_;
  std::ostringstream out_;
};

mjModel* compile(const std::string& xml) {
  mjVFS files;
  mj_defaultVFS(&files);
  NAO_CHECK(mj_makeEmptyFileVFS(&files, "nao.xml", static_cast<int>(xml.size())) == 0);
  const int i = mj_findFileVFS(&files, "nao.xml");
  std::copy(xml.begin(), xml.end(), static_cast<char*>(files.filedata[i]));
  char error[500] = "";
  mjModel* model = mj_loadXML("nao.xml", &files, error, sizeof error);
  mj_deleteVFS(&files);
  if (!model) throw std::runtime_error(std::string("MuJoCo: ") + error);
  return model;
}

}  // namespace

class MujocoNao::Impl {
 public:
  Impl(const RobotModel& model, double step)
      : model_(model), m_(compile(Writer(model, step).xml())), d_(mj_makeData(m_)) {}
  ~Impl() {
    mj_deleteData(d_);
    mj_deleteModel(m_);
  }

  void stand(const JointArray<double>& angles) {
    mj_resetData(m_, d_);
    double lean = 0;
    for (std::size_t j = 0; j < model_.jointCount(); ++j) {
      for (const int c : model_.actuators[j].coordinates) {
        const std::string& name = model_.coordinates[static_cast<std::size_t>(c)].name;
        d_->qpos[m_->jnt_qposadr[mj_name2id(m_, mjOBJ_JOINT, name.c_str())]] = angles[j];
        if (name == "LHipPitch" || name == "LKneePitch" || name == "LAnklePitch") lean -= angles[j];
      }
    }
    command(angles);
    d_->qpos[3] = std::cos(lean / 2);  // about y: soles level
    d_->qpos[5] = std::sin(lean / 2);
    d_->qpos[2] = 0.325;
    for (int k = 0; k < 1000; ++k) mj_step(m_, d_);
  }

  void command(const JointArray<double>& angles) {
    int motor = 0;
    for (std::size_t j = 0; j < model_.jointCount(); ++j) {
      if (!model_.actuators[j].coordinates.empty()) d_->ctrl[motor++] = angles[j];
    }
  }

  State state() const {
    return {{d_->qpos, d_->qpos + m_->nq},
            {d_->qvel, d_->qvel + m_->nv},
            {d_->qacc_warmstart, d_->qacc_warmstart + m_->nv}};
  }
  void setState(const State& state) {
    std::copy(state.q.begin(), state.q.end(), d_->qpos);
    std::copy(state.u.begin(), state.u.end(), d_->qvel);
    std::copy(state.warm_start.begin(), state.warm_start.end(), d_->qacc_warmstart);
  }

  void step() { mj_step(m_, d_); }
  Vec3 position() const { return {d_->qpos[0], d_->qpos[1], d_->qpos[2]}; }

 private:
  const RobotModel& model_;
  mjModel* m_;
  mjData* d_;
};

MujocoNao::MujocoNao(const RobotModel& model, double step_s)
    : impl_(std::make_unique<Impl>(model, step_s)) {}
MujocoNao::~MujocoNao() = default;
void MujocoNao::stand(const JointArray<double>& angles) { impl_->stand(angles); }
void MujocoNao::step() { impl_->step(); }
bool MujocoNao::stands() const { return impl_->position().z() > 0.25; }
Vec3 MujocoNao::position() const { return impl_->position(); }
void MujocoNao::command(const JointArray<double>& angles) { impl_->command(angles); }
MujocoNao::State MujocoNao::state() const { return impl_->state(); }
void MujocoNao::setState(const State& state) { impl_->setState(state); }

}  // namespace nao::bench

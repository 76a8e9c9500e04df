#include "core/robot_model.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace nao {
namespace {

const char* const kRobots = NAO_SOURCE_DIR "/robots";

std::shared_ptr<const RobotModel> load(const std::string& name) {
  return loadRobotModel(kRobots, name);
}

const Actuator& actuator(const RobotModel& model, const std::string& name) {
  return model.actuators[index(*model.findJoint(name))];
}

const Coordinate& coordinate(const RobotModel& model, const std::string& name) {
  return *std::find_if(model.coordinates.begin(), model.coordinates.end(),
                       [&](const Coordinate& c) { return c.name == name; });
}

// The poses of all bodies in T, the actuators at `angle`.
std::vector<Pose> posesOf(const RobotModel& model, const JointArray<double>& angle) {
  std::vector<Pose> X_TB{Pose::Identity()};
  for (std::size_t i = 1; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    const double q = angle[model.coordinates[i - 1].joint];
    X_TB.push_back(X_TB[static_cast<std::size_t>(body.parent)] * body.X_PB *
                   Eigen::AngleAxisd(q, body.axis));
  }
  return X_TB;
}

class EveryNao : public ::testing::TestWithParam<const char*> {
 protected:
  const std::shared_ptr<const RobotModel> model_ = load(GetParam());
};
INSTANTIATE_TEST_SUITE_P(RobotModel, EveryNao,
                         ::testing::Values("nao_h21_v33", "nao_h21_v33_ideal", "nao_h21_v40",
                                           "nao_h25_v33", "nao_h25_v40", "nao_h25_v50",
                                           "nao_h25_v60"));

TEST_P(EveryNao, HasInertiaThatSolidsCanHave) {
  for (const Body& body : model_->bodies) {
    const Vec3 moments = Eigen::SelfAdjointEigenSolver<Mat3>(body.I_Bcm).eigenvalues();
    EXPECT_GT(moments.x(), 0) << body.name;
    EXPECT_GE(moments.x() + moments.y(), moments.z()) << body.name;
  }
}

// The pages give tensors about the link's origin. Taken for tensors about the centre of mass the
// thigh would have 1.63e-3; shifted, the generated URDF's figure comes out.
TEST(RobotModel, InertiaIsAboutTheCentreOfMass) {
  const auto model = load("nao_h21_v33");
  const Body& torso = model->bodies[0];
  EXPECT_NEAR(torso.I_Bcm(0, 0), 0.00308278, 1e-8);  // the V3.3 URDF of nao_robot
  EXPECT_NEAR(torso.I_Bcm(0, 2), -1.92153e-05, 1e-9);
  const Body& thigh = model->bodies[static_cast<std::size_t>(*model->findBody("LHipPitch"))];
  EXPECT_NEAR(thigh.I_Bcm(0, 0), 498.8e-6, 1e-7);
}

TEST_P(EveryNao, ParentsComeBeforeChildren) {
  EXPECT_EQ(model_->bodies[0].name, "Torso");
  EXPECT_EQ(model_->coordinates.size() + 1, model_->bodies.size());
  for (std::size_t i = 1; i < model_->bodies.size(); ++i) {
    EXPECT_GE(model_->bodies[i].parent, 0);
    EXPECT_LT(model_->bodies[i].parent, static_cast<int>(i));
    EXPECT_NEAR(model_->bodies[i].axis.norm(), 1, 1e-12);
  }
}

TEST_P(EveryNao, LegsKeepTheirOwnLimits) {
  EXPECT_DOUBLE_EQ(actuator(*model_, "LKneePitch").lower, -0.092346);
  EXPECT_DOUBLE_EQ(actuator(*model_, "LKneePitch").upper, 2.112528);
  EXPECT_DOUBLE_EQ(actuator(*model_, "RKneePitch").lower, -0.103083);
  EXPECT_DOUBLE_EQ(actuator(*model_, "RKneePitch").upper, 2.120198);
  EXPECT_DOUBLE_EQ(actuator(*model_, "LAnklePitch").lower, -1.189516);
  EXPECT_DOUBLE_EQ(actuator(*model_, "RAnklePitch").upper, 0.932056);
  EXPECT_DOUBLE_EQ(actuator(*model_, "LAnkleRoll").upper, 0.769001);
  EXPECT_DOUBLE_EQ(actuator(*model_, "RAnkleRoll").lower, -0.768992);
  EXPECT_DOUBLE_EQ(coordinate(*model_, "RKneePitch").upper, 2.120198);
}

TEST_P(EveryNao, BendsItsLeftElbowToNegativeAngles) {
  EXPECT_DOUBLE_EQ(actuator(*model_, "LElbowRoll").lower, -1.5446);
  EXPECT_DOUBLE_EQ(actuator(*model_, "RElbowRoll").upper, 1.5446);
}

TEST_P(EveryNao, HipYawPitchIsOneMotorWithTwoHinges) {
  const Actuator& hip = actuator(*model_, "LHipYawPitch");
  ASSERT_EQ(hip.coordinates.size(), 2u);
  EXPECT_EQ(model_->coordinates[static_cast<std::size_t>(hip.coordinates[0])].name, "LHipYawPitch");
  EXPECT_EQ(model_->coordinates[static_cast<std::size_t>(hip.coordinates[1])].name, "RHipYawPitch");
  EXPECT_EQ(model_->findJoint("RHipYawPitch"), model_->findJoint("LHipYawPitch"));
}

TEST(RobotModel, HasOneActuatorPerMotorInBodyOrder) {
  for (const auto& [name, count] : {std::pair{"nao_h21_v33", 21u}, {"nao_h25_v50", 25u}}) {
    const auto model = load(name);
    ASSERT_EQ(model->jointCount(), count);
    auto body = model->groups.at("Body");
    body.erase(std::find(body.begin(), body.end(), "RHipYawPitch"));
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(model->actuators[i].name, body[i]);
  }
}

TEST(RobotModel, GroupsHaveTheSizesOfNaoQi) {
  const auto h21 = load("nao_h21_v33");
  const auto h25 = load("nao_h25_v50");
  EXPECT_EQ(h21->groups.at("Body").size(), 22u);
  EXPECT_EQ(h25->groups.at("Body").size(), 26u);
  EXPECT_EQ(h21->groups.at("Joints").size(), 22u);
  EXPECT_EQ(h25->groups.at("Joints").size(), 24u);
  EXPECT_EQ(h21->groups.at("Actuators").size(), 0u);
  EXPECT_EQ(h25->groups.at("Actuators"), (std::vector<std::string>{"LHand", "RHand"}));
  EXPECT_EQ(h21->groups.at("LArm").size(), 4u);
  EXPECT_EQ(h25->groups.at("LArm").size(), 6u);
  EXPECT_EQ(h25->groups.at("Arms").size(), 12u);
  EXPECT_EQ(h25->groups.at("Legs").size(), 12u);
  EXPECT_EQ(h25->groups.at("BodyJoints"), h25->groups.at("Joints"));
  EXPECT_EQ(h25->groups.at("Chains"),
            (std::vector<std::string>{"Head", "LArm", "LLeg", "RLeg", "RArm"}));
}

TEST(RobotModel, HandsOpenFromZeroToOneWithoutAHinge) {
  const auto model = load("nao_h25_v50");
  const Actuator& hand = actuator(*model, "LHand");
  EXPECT_TRUE(hand.coordinates.empty());
  EXPECT_EQ(hand.lower, 0);
  EXPECT_EQ(hand.upper, 1);
}

TEST(RobotModel, MotorsAreSeenThroughTheirGear) {
  const auto model = load("nao_h21_v33");
  const Actuator& knee = actuator(*model, "RKneePitch");
  EXPECT_NEAR(knee.stall_torque, 7.786, 5e-4);    // 59.5 mN m x 130.85
  EXPECT_NEAR(knee.no_load_speed, 6.4024, 5e-5);  // 8000 rpm / 130.85
  EXPECT_DOUBLE_EQ(knee.max_velocity, 6.40239);
  EXPECT_DOUBLE_EQ(knee.max_torque, 3.023);
  EXPECT_DOUBLE_EQ(knee.efficiency, 0.7);
  EXPECT_NEAR(knee.kd, 1.4 * std::sqrt(knee.kp * 1.5 * knee.rotor_inertia), 1e-3);
}

TEST_P(EveryNao, CoupledLimitsMeetTheirRowsAndRunStraightBetween) {
  const auto& limits = model_->coupled_limits;
  ASSERT_EQ(limits.size(), 3u);
  const CoupledLimit& head = limits[0];
  EXPECT_EQ(head.driver, *model_->findJoint("HeadYaw"));
  EXPECT_EQ(head.limited, *model_->findJoint("HeadPitch"));
  EXPECT_DOUBLE_EQ(head.rangeAt(1.526988).second, 0.200015);
  EXPECT_DOUBLE_EQ(head.rangeAt(-1.526988).first, -0.330041);
  const double between = (0.486074 + 0.756077) / 2;
  EXPECT_NEAR(head.rangeAt(between).second, (0.422021 + 0.370010) / 2, 1e-12);
  EXPECT_NEAR(head.rangeAt(-between).first, (-0.671951 - 0.548033) / 2, 1e-12);
  EXPECT_DOUBLE_EQ(head.rangeAt(3).first, -0.449073);  // held beyond the last row
  EXPECT_DOUBLE_EQ(head.rangeAt(-3).second, 0.330041);
}

TEST_P(EveryNao, RightAnkleRollIsLimitedLikeTheLeftMirrored) {
  const CoupledLimit& left = model_->coupled_limits[1];
  const CoupledLimit& right = model_->coupled_limits[2];
  for (const double pitch : {-1.1, -0.5, 0.0, 0.4, 0.9}) {
    EXPECT_DOUBLE_EQ(right.rangeAt(pitch).first, -left.rangeAt(pitch).second);
    EXPECT_DOUBLE_EQ(right.rangeAt(pitch).second, -left.rangeAt(pitch).first);
  }
}

TEST_P(EveryNao, StandsAsTallAsItsLinksSay) {
  const auto X_TB = posesOf(*model_, model_->findPosture("StandZero")->angle);
  for (const FootModel& foot : model_->feet) {
    const Vec3 sole = (X_TB[static_cast<std::size_t>(foot.body)] * foot.X_BS).translation();
    EXPECT_NEAR(sole.z(), -(0.085 + 0.100 + 0.1029 + 0.04519), 1e-9);
    EXPECT_NEAR(std::abs(sole.y()), 0.05, 1e-9);
  }
}

// Where the sole touches the floor in each posture on two feet, no sphere may touch instead.
TEST_P(EveryNao, StandsOnItsSolesAndNothingElse) {
  for (const char* name : {"Stand", "StandInit", "StandZero", "Crouch"}) {
    const auto X_TB = posesOf(*model_, model_->findPosture(name)->angle);
    for (const FootModel& foot : model_->feet) {
      const Pose X_TS = X_TB[static_cast<std::size_t>(foot.body)] * foot.X_BS;
      for (const ContactSphere& sphere : model_->contact_spheres) {
        const Vec3 p_S = X_TS.inverse() * X_TB[static_cast<std::size_t>(sphere.body)] * sphere.p_B;
        EXPECT_GT(p_S.z() - sphere.radius, 0.001)
            << name << ": " << model_->bodies[static_cast<std::size_t>(sphere.body)].name;
      }
    }
  }
}

// How far a set of points reaches in a direction.
double reachOfContacts(const RobotModel& model, const std::vector<Pose>& X_TB, const Vec3& way) {
  double reach = -1e9;
  for (const ContactSphere& sphere : model.contact_spheres) {
    const Vec3 p = X_TB[static_cast<std::size_t>(sphere.body)] * sphere.p_B;
    reach = std::max(reach, p.dot(way) + sphere.radius);
  }
  for (const FootModel& foot : model.feet) {
    const Pose X_TS = X_TB[static_cast<std::size_t>(foot.body)] * foot.X_BS;
    for (const Eigen::Vector2d& corner : foot.outline) {
      reach = std::max(reach, (X_TS * Vec3(corner.x(), corner.y(), 0)).dot(way));
    }
  }
  return reach;
}

double reachOfShape(const Shape& shape, const Pose& X_TB, const Vec3& way_T) {
  const Pose X_TS = X_TB * shape.X_BS;
  const Vec3 way = X_TS.linear().transpose() * way_T;
  const double centre = X_TS.translation().dot(way_T);
  switch (shape.kind) {
    case Shape::Kind::Sphere:
      return centre + shape.size.x();
    case Shape::Kind::Box:
      return centre + 0.5 * shape.size.dot(way.cwiseAbs());
    case Shape::Kind::Cylinder:
      return centre + shape.size.x() * way.head<2>().norm() +
             0.5 * shape.size.z() * std::abs(way.z());
    case Shape::Kind::Capsule:
      return centre + shape.size.x() + 0.5 * shape.size.z() * std::abs(way.z());
    case Shape::Kind::Hull:
      break;  // no robot has one
  }
  return centre;
}

// A fallen robot lies on its contact spheres. From whatever side the floor comes, they must meet
// it before the visible body has sunk in by more than 2 cm (a quarter of a thigh).
TEST_P(EveryNao, LiesOnTheFloorFromAnySide) {
  for (const Posture& posture : model_->postures) {
    const auto X_TB = posesOf(*model_, posture.angle);
    for (int i = 0; i < 500; ++i) {  // directions spread evenly over the sphere
      const double z = 1 - (2 * i + 1) / 500.0;
      const double turn = 2.399963 * i;  // the golden angle
      const double r = std::sqrt(1 - z * z);
      const Vec3 way(r * std::cos(turn), r * std::sin(turn), z);
      const double reach = reachOfContacts(*model_, X_TB, way);
      for (std::size_t b = 0; b < model_->bodies.size(); ++b) {
        for (const Shape& shape : model_->bodies[b].visuals) {
          EXPECT_LT(reachOfShape(shape, X_TB[b], way), reach + 0.02)
              << posture.name << ", " << model_->bodies[b].name << " towards " << way.transpose();
        }
      }
    }
  }
}

TEST_P(EveryNao, KnowsTheStandardPostures) {
  for (const char* name : {"Crouch", "LyingBack", "LyingBelly", "Sit", "SitRelax", "Stand",
                           "StandInit", "StandZero"}) {
    ASSERT_NE(model_->findPosture(name), nullptr) << name;
    EXPECT_EQ(model_->findPosture(name)->angle.size(), model_->jointCount());
  }
  EXPECT_EQ(model_->start_posture, "Crouch");
  EXPECT_EQ(model_->findPosture("SitOnMoon"), nullptr);
  const auto& crouch = *model_->findPosture("Crouch");
  EXPECT_DOUBLE_EQ(crouch.angle[*model_->findJoint("RKneePitch")], 2.11);
  EXPECT_EQ(crouch.family, "Crouching");
}

TEST_P(EveryNao, FeetHaveOutlineAndSensorsMirrored) {
  ASSERT_EQ(model_->feet.size(), 2u);
  const FootModel& left = model_->feet[0];
  const FootModel& right = model_->feet[1];
  EXPECT_EQ(left.body, *model_->findBody("LAnkleRoll"));
  ASSERT_EQ(left.outline.size(), right.outline.size());
  for (std::size_t i = 0; i < left.outline.size(); ++i) {
    const Eigen::Vector2d& mirror = right.outline[right.outline.size() - 1 - i];
    EXPECT_EQ(left.outline[i].x(), mirror.x());
    EXPECT_EQ(left.outline[i].y(), -mirror.y());
  }
  EXPECT_DOUBLE_EQ(left.fsr[0].x(), 0.07025);
  EXPECT_DOUBLE_EQ(right.fsr[2].y(), 0.0191);
}

TEST(RobotModel, CamerasSeeWhatTheirHeadVersionSees) {
  const auto v33 = load("nao_h21_v33");
  const auto v50 = load("nao_h25_v50");
  ASSERT_EQ(v33->cameras.size(), 2u);
  EXPECT_EQ(v33->cameras[0].name, "CameraTop");
  EXPECT_EQ(v33->cameras[1].name, "CameraBottom");
  EXPECT_NEAR(v33->cameras[0].hfov, 47.8 * M_PI / 180, 1e-12);
  EXPECT_NEAR(v50->cameras[1].vfov, 47.6 * M_PI / 180, 1e-12);
  EXPECT_EQ(v33->cameras[0].frame_rates, (std::vector<int>{5, 10, 15, 30}));
  EXPECT_EQ(v50->cameras[0].frame_rates.size(), 30u);
  EXPECT_EQ(v50->cameras[0].max_width, 1280);
  const auto v60 = load("nao_h25_v60");
  EXPECT_NEAR(v60->cameras[0].hfov, 56.3 * M_PI / 180, 1e-12);
  EXPECT_EQ(v60->cameras[0].max_width, 2560);
  EXPECT_EQ(v60->cameras[1].max_width, 1280);
  EXPECT_EQ(load("nao_h25_v33")->cameras[0].hfov, v33->cameras[0].hfov);
  EXPECT_EQ(load("nao_h25_v40")->cameras[0].hfov, v50->cameras[0].hfov);
  EXPECT_EQ(load("nao_h21_v40")->cameras[0].hfov, v50->cameras[0].hfov);
  const Vec3 sight = v33->cameras[1].X_BC.linear() * Vec3::UnitX();
  EXPECT_NEAR(std::asin(-sight.z()), 40 * M_PI / 180, 1e-4);  // the bottom one looks down
}

TEST(RobotModel, GyroscopesHaveTheAxesOfTheirVersion) {
  for (const char* old : {"nao_h21_v33", "nao_h21_v40", "nao_h25_v33", "nao_h25_v40"}) {
    EXPECT_EQ(load(old)->gyro_axes, 2) << old;
  }
  EXPECT_EQ(load("nao_h25_v50")->gyro_axes, 3);
  EXPECT_EQ(load("nao_h25_v60")->gyro_axes, 3);
}

TEST(RobotModel, SonarsReachAsFarAsTheirVersion) {
  const auto range = [](const char* name) {
    const SonarModel sonar = load(name)->sonar;
    return std::pair(sonar.min_range, sonar.max_range);
  };
  for (const char* old : {"nao_h21_v33", "nao_h21_v40", "nao_h25_v33", "nao_h25_v40"}) {
    EXPECT_EQ(range(old), std::pair(0.25, 2.55)) << old;
  }
  EXPECT_EQ(range("nao_h25_v50"), std::pair(0.2, 0.8));
  EXPECT_EQ(range("nao_h25_v60"), std::pair(0.2, 0.8));
}

TEST_P(EveryNao, HasTwoTransmittersAndTwoReceiversOfSixtyDegrees) {
  const SonarModel& sonar = model_->sonar;
  EXPECT_NEAR(sonar.half_cone, M_PI / 6, 1e-12);
  ASSERT_EQ(sonar.transmitters.size(), 2u);
  ASSERT_EQ(sonar.receivers.size(), 2u);
  for (const int i : sonar.receivers) {
    const Frame& frame = model_->frames.at(static_cast<std::size_t>(i));
    const bool left = i == sonar.receivers[0];
    EXPECT_EQ(frame.name, left ? "Sonar/Left" : "Sonar/Right");
    EXPECT_EQ(frame.body, 0);
    const Vec3 sight = frame.X_BF.linear() * Vec3::UnitX();
    EXPECT_GT(sight.x(), 0.9);
    EXPECT_GT(left ? sight.y() : -sight.y(), 0.3);  // outwards, by 22.5 degrees
  }
}

TEST_P(EveryNao, NeighboursShareABoard) {
  const auto board = [&](const char* name) { return actuator(*model_, name).board; };
  EXPECT_EQ(board("HeadYaw"), board("HeadPitch"));
  EXPECT_EQ(board("LHipPitch"), board("LKneePitch"));
  EXPECT_NE(board("LHipPitch"), board("RHipPitch"));
  std::map<int, int> motors;
  for (const Actuator& motor : model_->actuators) ++motors[motor.board];
  EXPECT_EQ(motors.count(-1), 0u);  // every motor has one
  for (const auto& [number, count] : motors) EXPECT_LE(count, 2) << number;
}

TEST(RobotModel, MotorsAreThoseOfTheirVersion) {
  const auto knee = [](const char* name) { return actuator(*load(name), "LKneePitch"); };
  EXPECT_NEAR(knee("nao_h25_v33").stall_torque, 7.786, 5e-4);
  EXPECT_NEAR(knee("nao_h21_v40").stall_torque, 8.898, 5e-4);
  EXPECT_NEAR(knee("nao_h25_v40").no_load_speed, 6.6425, 5e-5);
  EXPECT_NEAR(knee("nao_h25_v60").stall_torque, 8.505, 5e-4);
  EXPECT_NEAR(knee("nao_h25_v60").no_load_speed, 6.9626, 5e-5);
  const auto v60 = load("nao_h25_v60");
  EXPECT_NEAR(actuator(*v60, "LShoulderPitch").stall_torque, 3.366, 5e-4);  // DCX 16S
  EXPECT_NEAR(actuator(*v60, "RWristYaw").stall_torque, 0.476, 5e-4);
  EXPECT_NEAR(actuator(*load("nao_h25_v33"), "LHand").stall_torque, 0.547, 5e-4);
}

TEST(RobotModel, OnlyTheV6ExchangesEveryTwelveMilliseconds) {
  EXPECT_EQ(load("nao_h25_v60")->cycle, std::chrono::milliseconds(12));
  EXPECT_EQ(load("nao_h25_v50")->cycle, std::chrono::milliseconds(10));
}

TEST(RobotModel, TheIdealOneDiffersInItsEffectsAlone) {
  const auto real = load("nao_h21_v33");
  const auto ideal = load("nao_h21_v33_ideal");
  EXPECT_FALSE(real->effects.empty());
  EXPECT_TRUE(ideal->effects.empty());
  EXPECT_TRUE(ideal->variation.empty());
  EXPECT_EQ(ideal->totalMass(), real->totalMass());
  EXPECT_EQ(ideal->groups, real->groups);
  EXPECT_EQ(ideal->no_collision, real->no_collision);
  EXPECT_EQ(ideal->postures.size(), real->postures.size());
}

TEST_P(EveryNao, NamesAreUnique) {
  std::set<std::string> frames;
  for (const Frame& frame : model_->frames) {
    EXPECT_TRUE(frames.insert(frame.name).second) << frame.name;
  }
  EXPECT_TRUE(frames.count("LArm") && frames.count("RLeg") && frames.count("CameraTop"));
}

}  // namespace
}  // namespace nao

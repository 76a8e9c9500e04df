#include <gtest/gtest.h>

#include <filesystem>

#include "core/check.h"
#include "core/robot_model.h"
#include "core/robot_model_parts.h"
#include "tests/core/temporary_folder.h"

// Nothing in the loader knows a Nao: any tree of hinges is a robot.
namespace nao {
namespace {

// An arm bolted down: a base without mass, a yaw, an endless wrist, a tool fixed to it.
const char* const kArm = R"(<?xml version="1.0"?>
<robot name="arm">
  <link name="base"/>
  <link name="upper">
    <inertial><mass value="2"/><origin xyz="0 0 0.1"/>
      <inertia ixx="0.02" iyy="0.02" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><geometry><mesh filename="pretty.dae"/></geometry></visual>
    <collision><geometry><cylinder radius="0.05" length="0.3"/></geometry></collision>
  </link>
  <link name="wrist">
    <inertial><mass value="1"/>
      <inertia ixx="0.001" iyy="0.001" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial>
  </link>
  <link name="tool">
    <inertial><mass value="1"/><origin xyz="0 0 0.1"/>
      <inertia ixx="0.001" iyy="0.001" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial>
  </link>
  <joint name="turn" type="revolute">
    <parent link="base"/><child link="upper"/><origin xyz="0 0 0.2"/><axis xyz="0 0 2"/>
    <limit lower="-1" upper="2" effort="10" velocity="3"/>
  </joint>
  <joint name="spin" type="continuous">
    <parent link="upper"/><child link="wrist"/><origin xyz="0 0 0.3"/><axis xyz="1 0 0"/>
    <limit effort="5" velocity="6"/>
  </joint>
  <joint name="hold" type="fixed">
    <parent link="wrist"/><child link="tool"/><origin xyz="0 0 0.1"/>
  </joint>
</robot>
)";

const char* const kDrives = R"(
drives:
  any:
    motor_no_load_speed_rpm: 6000
    motor_stall_torque_mNm: 1000
    gear_ratio: 100
    efficiency: 0.8
    rotor_inertia: 0.1
    kp: 100
    kd: 5
)";

const std::string kArmBody = "fixed_base: true" + std::string(kDrives) + R"(
actuators:
  - {name: turn, drive: any}
  - {name: spin, drive: any}
)";

class ArmTest : public ::testing::Test {
 protected:
  ArmTest() {
    folder_.write("arm/model.urdf", kArm);
    folder_.write("arm/body.yaml", kArmBody);
    model_ = loadRobotModel(folder_.path(), "arm");
  }

  TemporaryFolder folder_;
  std::shared_ptr<const RobotModel> model_;
};

TEST_F(ArmTest, LeavesOutWhatItDoesNotHave) {
  EXPECT_TRUE(model_->fixed_base);
  EXPECT_TRUE(model_->feet.empty());
  EXPECT_TRUE(model_->cameras.empty());
  EXPECT_TRUE(model_->postures.empty());
  EXPECT_TRUE(model_->contact_spheres.empty());
  EXPECT_TRUE(model_->coupled_limits.empty());
  EXPECT_EQ(model_->start_posture, "");
  EXPECT_EQ(model_->body_type, "arm");
  EXPECT_EQ(model_->cycle, std::chrono::milliseconds(10));
  EXPECT_TRUE(model_->effects.empty());
}

TEST_F(ArmTest, HasTheGroupsEveryRobotHas) {
  const std::vector<std::string> all{"turn", "spin"};
  EXPECT_EQ(model_->groups.at("Body"), all);
  EXPECT_EQ(model_->groups.at("Joints"), all);
  EXPECT_EQ(model_->groups.at("JointActuators"), all);
  EXPECT_TRUE(model_->groups.at("Actuators").empty());
}

// Two links of 1 kg whose centres are 0.2 m apart: each adds m d^2 with d = 0.1 m.
TEST_F(ArmTest, LinksFixedTogetherAreOneBody) {
  ASSERT_EQ(model_->bodies.size(), 3u);
  const Body& wrist = model_->bodies[2];
  EXPECT_EQ(wrist.name, "wrist");
  EXPECT_DOUBLE_EQ(wrist.mass, 2);
  EXPECT_NEAR(wrist.p_BoBcm.z(), 0.1, 1e-12);
  EXPECT_NEAR(wrist.I_Bcm(0, 0), 2 * 0.001 + 2 * 0.01, 1e-12);
  EXPECT_NEAR(wrist.I_Bcm(2, 2), 2 * 0.001, 1e-12);
  ASSERT_EQ(model_->frames.size(), 1u);
  EXPECT_EQ(model_->frames[0].name, "tool");
  EXPECT_EQ(model_->frames[0].body, 2);
  EXPECT_NEAR(model_->frames[0].X_BF.translation().z(), 0.1, 1e-12);
}

TEST_F(ArmTest, KeepsSolidsAndLeavesMeshesOut) {
  EXPECT_TRUE(model_->bodies[1].visuals.empty());
  ASSERT_EQ(model_->bodies[1].collisions.size(), 1u);
  EXPECT_EQ(model_->bodies[1].collisions[0].size, Vec3(0.05, 0, 0.3));
}

TEST_F(ArmTest, TurnsEndlesslyWhereTheUrdfSaysContinuous) {
  EXPECT_GT(model_->actuators[1].upper, 1000 * M_PI);
  EXPECT_LT(model_->actuators[1].lower, -1000 * M_PI);
  EXPECT_DOUBLE_EQ(model_->actuators[1].max_velocity, 6);
  EXPECT_EQ(model_->bodies[1].axis, Vec3::UnitZ());  // made a unit vector
}

TEST_F(ArmTest, AHingeWithoutADriveTurnsFreelyWhenTheFileSaysSo) {
  std::string body = kArmBody;
  body.replace(body.find("name: spin, drive: any"), 22, "name: spin, drive: none");
  folder_.write("arm/body.yaml", body);
  const auto model = loadRobotModel(folder_.path(), "arm");
  ASSERT_EQ(model->jointCount(), 2u);
  EXPECT_EQ(model->actuators[1].stall_torque, 0);
  EXPECT_EQ(model->actuators[1].kp, 0);
  EXPECT_EQ(model->actuators[1].rotor_inertia, 0);
}

TEST_F(ArmTest, BoardsAndSwitchesOfLimitsAreRead) {
  folder_.write("arm/body.yaml", kArmBody + R"(
boards: {Both: [spin, turn]}
coupled_limits:
  - {driver: turn, limited: spin, stop: false, rows: [[0, -1, 1]]}
  - {driver: spin, limited: turn, clip: false, rows: [[0, -1, 1]]}
)");
  const auto model = loadRobotModel(folder_.path(), "arm");
  EXPECT_EQ(model->actuators[0].board, 0);
  EXPECT_EQ(model->actuators[1].board, 0);
  EXPECT_FALSE(model->coupled_limits[0].stop);
  EXPECT_TRUE(model->coupled_limits[0].clip);
  EXPECT_TRUE(model->coupled_limits[1].stop);
  EXPECT_FALSE(model->coupled_limits[1].clip);
}

std::string complaintAbout(const TemporaryFolder& folder, const std::string& body) {
  folder.write("arm/body.yaml", body);
  try {
    loadRobotModel(folder.path(), "arm");
  } catch (const InputError& error) {
    return folder.withoutPath(error.what());
  }
  return "none";
}

TEST_F(ArmTest, PairsBoardsAndSonarAreChecked) {
  const std::string at = "arm/body.yaml:15: ";
  EXPECT_EQ(complaintAbout(folder_, kArmBody + "no_collision: [[upper, lower]]\n"),
            at + "`no_collision`: expected pairs of links of model.urdf, [upper, lower] is none, "
                 "found a list");
  EXPECT_EQ(complaintAbout(folder_, kArmBody + "no_collision: [[upper]]\n"),
            at + "`no_collision`: expected pairs of words, found 1");
  EXPECT_EQ(
      complaintAbout(folder_, kArmBody + "boards: {A: [turn], B: [turn]}\n"),
      at + "`B`: expected names of actuators, each on one board, 'turn' is not, found a list");
  EXPECT_EQ(complaintAbout(folder_, kArmBody + "sonar: {min: 1, max: 0.5, cone_deg: 60, "
                                               "transmitters: [], receivers: []}\n"),
            at + "`max`: expected more than `min`, found '0.5'");
  EXPECT_EQ(complaintAbout(folder_, kArmBody + "sonar: {min: 0, max: 1, cone_deg: 60, "
                                               "transmitters: [ear], receivers: []}\n"),
            at + "`transmitters`: expected names of `frames`, 'ear' is not, found a list");
}

TEST_F(ArmTest, OnlyABoltedBaseMayBeWithoutMass) {
  std::string body = kArmBody;
  body.replace(body.find("true"), 4, "false");
  folder_.write("arm/body.yaml", body);
  try {
    loadRobotModel(folder_.path(), "arm");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(folder_.withoutPath(error.what()),
              "arm/model.urdf:3: link 'base': a body that moves needs an <inertial> with a mass "
              "above 0");
  }
}

TEST(AnyRobot, ASpiderOfEighteenJointsLoads) {
  std::string urdf = "<robot name='spider'>\n";
  std::string body = std::string(kDrives) + "actuators:\n";
  const auto link = [&](const std::string& name) {
    urdf += "<link name='" + name +
            "'><inertial><mass value='0.1'/><inertia ixx='1e-4' "
            "iyy='1e-4' izz='1e-4' ixy='0' ixz='0' iyz='0'/></inertial></link>\n";
  };
  link("thorax");
  for (int leg = 0; leg < 6; ++leg) {
    std::string parent = "thorax";
    for (const char* part : {"hip", "thigh", "knee"}) {
      const std::string name = part + std::to_string(leg);
      link(name);
      urdf += "<joint name='" + name + "' type='revolute'><parent link='" + parent +
              "'/><child link='" + name +
              "'/><origin xyz='0.05 0 0'/><axis xyz='0 1 0'/>"
              "<limit lower='-1' upper='1' effort='1' velocity='5'/></joint>\n";
      body += "  - {name: " + name + ", drive: any}\n";
      parent = name;
    }
  }
  const TemporaryFolder folder;
  folder.write("spider/model.urdf", urdf + "</robot>\n");
  folder.write("spider/body.yaml", body);
  const auto spider = loadRobotModel(folder.path(), "spider");
  EXPECT_EQ(spider->jointCount(), 18u);
  EXPECT_EQ(spider->bodies[0].name, "thorax");
  EXPECT_NEAR(spider->totalMass(), 1.9, 1e-12);
}

// Robot descriptions by others, kept beside the sources where they are at hand.
class OthersUrdf : public ::testing::Test {
 protected:
  static std::string file(const std::string& name) {
    return std::string(NAO_SOURCE_DIR "/../shared/models/") + name;
  }
  void SetUp() override {
    if (!std::filesystem::exists(file("darwin.urdf"))) GTEST_SKIP() << "no ../shared/models here";
  }
};

// One motor per hinge that follows none, all alike.
std::string bodyFor(const UrdfRobot& urdf, const std::string& more) {
  std::string body = more + kDrives + "actuators:\n";
  for (const UrdfHinge& hinge : urdf.hinges) {
    if (hinge.mimics.empty()) body += "  - {name: " + hinge.name + ", drive: any}\n";
  }
  return body;
}

// Loads a stranger's URDF from a folder of our own; the complaint is empty when it loads.
std::string load(const std::string& urdf_file, const std::string& more,
                 std::shared_ptr<const RobotModel>& model) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() + "/guest");
  std::filesystem::copy_file(urdf_file, folder.path() + "/guest/model.urdf");
  try {
    folder.write("guest/body.yaml", bodyFor(readUrdf(urdf_file), more));
    model = loadRobotModel(folder.path(), "guest");
  } catch (const InputError& error) {
    return folder.withoutPath(error.what());
  }
  return {};
}

TEST_F(OthersUrdf, AibosLimitsGivenTheWrongWayRoundAreARangeAllTheSame) {
  std::shared_ptr<const RobotModel> aibo;
  ASSERT_EQ(load(file("Aibo.urdf"), "", aibo), "");
  EXPECT_EQ(aibo->jointCount(), 17u);
  const Actuator& pan = aibo->actuators[index(*aibo->findJoint("headPan"))];
  EXPECT_DOUBLE_EQ(pan.lower, -1.5882);
  EXPECT_DOUBLE_EQ(pan.upper, 1.5882);
}

TEST_F(OthersUrdf, DarwinsTensorsAreRepairedOnRequestOnly) {
  std::shared_ptr<const RobotModel> darwin;
  EXPECT_NE(load(file("darwin.urdf"), "", darwin).find("breaks the triangle inequality"),
            std::string::npos);
  ASSERT_EQ(load(file("darwin.urdf"), "repair_inertia: true\n", darwin), "");
  EXPECT_EQ(darwin->bodies.size(), 25u);
}

TEST_F(OthersUrdf, AnOlderNaoLoadsWithItsFingersAsFollowers) {
  std::shared_ptr<const RobotModel> nao;
  ASSERT_EQ(load(file("naoV32_no_mesh.urdf"), "repair_inertia: true\n", nao), "");
  EXPECT_EQ(nao->findJoint("RHipYawPitch"), nao->findJoint("LHipYawPitch"));
  EXPECT_EQ(nao->actuators[index(*nao->findJoint("RHand"))].coordinates.size(), 9u);
}

TEST_F(OthersUrdf, AnArmWithoutMassesIsRefusedWithItsLine) {
  std::shared_ptr<const RobotModel> arm;
  EXPECT_EQ(load(file("irb2400.urdf"), "fixed_base: true\n", arm),
            "guest/model.urdf:46: link 'link_1': a body that moves needs an <inertial> with a "
            "mass above 0");
}

TEST(NearestSolid, ChangesNothingThatCouldExist) {
  const Mat3 ball = Mat3::Identity();
  EXPECT_EQ(nearestSolid(ball), ball);
}

TEST(NearestSolid, ReachesTheTriangleInequalityWithTheLeastChange) {
  const Mat3 impossible = Vec3(1, 1, 5).asDiagonal();
  const Mat3 expected = Vec3(2, 2, 4).asDiagonal();  // (1, 1, -1) is the face's normal
  EXPECT_LT((nearestSolid(impossible) - expected).norm(), 1e-12);
}

}  // namespace
}  // namespace nao

#include <gtest/gtest.h>

#include "core/check.h"
#include "core/robot_model.h"
#include "tests/core/temporary_folder.h"

// A robot that is like another gives only what differs.
namespace nao {
namespace {

const char* const kUrdf = R"(<robot name="lever">
  <link name="base"/>
  <link name="arm"><inertial><mass value="2"/>
    <inertia ixx="0.02" iyy="0.02" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="turn" type="revolute"><parent link="base"/><child link="arm"/>
    <axis xyz="0 1 0"/><limit lower="-1" upper="2" effort="10" velocity="3"/></joint>
</robot>
)";

const char* const kBody = R"(fixed_base: true
version: old
cycle_ms: 8
drives:
  any:
    motor_no_load_speed_rpm: 6000
    motor_stall_torque_mNm: 1000
    gear_ratio: 100
    efficiency: 0.8
    rotor_inertia: 0.1
    kp: 100
    kd: 5
actuators:
  - {name: turn, drive: any}
effects:
  - {effect: encoder_quantum, quantum: 0.001}
)";

class LikeTest : public ::testing::Test {
 protected:
  LikeTest() {
    folder_.write("old/model.urdf", kUrdf);
    folder_.write("old/body.yaml", kBody);
    folder_.write("old/postures.yaml", "start: Up\npostures: [{name: Up, angles: {turn: 0.5}}]\n");
  }
  std::string complaintAbout(const std::string& name) const {
    try {
      loadRobotModel(folder_.path(), name);
    } catch (const InputError& error) {
      return folder_.withoutPath(error.what());
    }
    return "none";
  }
  TemporaryFolder folder_;
};

TEST_F(LikeTest, TakesFilesAndKeysThatItDoesNotGive) {
  folder_.write("young/body.yaml", "like: old\nversion: young\neffects: []\n");
  const auto young = loadRobotModel(folder_.path(), "young");
  EXPECT_EQ(young->name, "young");
  EXPECT_EQ(young->version, "young");
  EXPECT_TRUE(young->effects.empty());
  EXPECT_EQ(young->cycle, std::chrono::milliseconds(8));
  EXPECT_EQ(young->start_posture, "Up");
  EXPECT_EQ(young->totalMass(), 2);
  EXPECT_EQ(loadRobotModel(folder_.path(), "old")->effects.size(), 1u);
}

TEST_F(LikeTest, GoesOnFromRobotToRobot) {
  folder_.write("young/body.yaml", "like: old\ncycle_ms: 9\n");
  folder_.write("newest/body.yaml", "like: young\nversion: newest\n");
  folder_.write("newest/postures.yaml",
                "start: Down\npostures: [{name: Down, angles: {turn: -0.5}}]\n");
  const auto newest = loadRobotModel(folder_.path(), "newest");
  EXPECT_EQ(newest->version, "newest");
  EXPECT_EQ(newest->cycle, std::chrono::milliseconds(9));
  EXPECT_EQ(newest->start_posture, "Down");
  EXPECT_EQ(newest->actuators.size(), 1u);
}

TEST_F(LikeTest, AnUnknownRobotIsNamedWhereItIsAskedFor) {
  folder_.write("young/body.yaml", "version: young\nlike: odl\n");
  EXPECT_EQ(complaintAbout("young"),
            "young/body.yaml:2: `like`: expected one of old, young, found 'odl'");
}

TEST_F(LikeTest, RobotsLikeEachOtherAreRefused) {
  folder_.write("hen/body.yaml", "like: egg\n");
  folder_.write("egg/body.yaml", "\nlike: hen\n");
  EXPECT_EQ(complaintAbout("hen"),
            "egg/body.yaml:2: `like`: expected a robot that is not itself like this one, found "
            "'hen'");
}

TEST_F(LikeTest, ComplaintsNameTheFileTheKeyStandsIn) {
  folder_.write("young/body.yaml", "like: old\ncycle_ms: 0\n");
  EXPECT_EQ(complaintAbout("young"),
            "young/body.yaml:2: `cycle_ms`: expected a whole number in [1, 100], found '0'");
  std::string body = kBody;
  body.replace(body.find("0.8"), 3, "8.0");
  folder_.write("old/body.yaml", body);
  folder_.write("young/body.yaml", "like: old\n");
  EXPECT_EQ(complaintAbout("young"),
            "old/body.yaml:9: `efficiency`: expected a number in [0.01, 1], found '8.0'");
  folder_.write("old/body.yaml", std::string(kBody) + "wings: 2\n");
  EXPECT_EQ(complaintAbout("young").rfind("old/body.yaml:17: `wings`: unknown key", 0), 0u);
}

TEST_F(LikeTest, WithoutATreeThereIsNoRobot) {
  folder_.write("ghost/body.yaml", "version: none\n");
  EXPECT_EQ(complaintAbout("ghost"),
            "ghost/body.yaml:1: expected a model.urdf beside this file, or `like:` and the name "
            "of a robot with one");
}

// The tables give tensors about the link's origin; the parallel axis theorem takes them to the
// centre of mass: 2 kg at x = 0.1 m adds 0.02 kg m^2 about y and z.
TEST_F(LikeTest, SolidsTakeThePlaceOfTheUrdfsMasses) {
  folder_.write("young/body.yaml", R"(like: old
solids:
  arm:
    mass: 2
    com: [0.1, 0, 0]
    inertia_at_origin: [0.01, 0.03, 0.03, 0.001, 0.002, 0.003]
)");
  const auto young = loadRobotModel(folder_.path(), "young");
  const Mat3& I = young->bodies[1].I_Bcm;
  EXPECT_NEAR(I(0, 0), 0.01, 1e-15);
  EXPECT_NEAR(I(1, 1), 0.01, 1e-15);
  EXPECT_NEAR(I(2, 2), 0.01, 1e-15);
  EXPECT_EQ(I(0, 1), 0.001);
  EXPECT_EQ(I(2, 0), 0.002);
  EXPECT_EQ(I(1, 2), 0.003);
}

TEST_F(LikeTest, SolidsThatCanNotExistAreRefused) {
  folder_.write("young/body.yaml",
                "like: old\nsolids:\n  arm:\n    mass: 2\n    com: [0, 0, 0]\n"
                "    inertia_at_com: [1, 1, 3, 0, 0, 0]\n");
  EXPECT_NE(complaintAbout("young").find("its inertia breaks the triangle inequality"),
            std::string::npos);
  EXPECT_EQ(complaintAbout("young").rfind("young/body.yaml:", 0), 0u);
  folder_.write("young/body.yaml", "like: old\nsolids:\n  leg: {}\n");
  EXPECT_EQ(complaintAbout("young"),
            "young/body.yaml:3: `leg`: expected the name of a link of model.urdf, found a map");
}

}  // namespace
}  // namespace nao

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/check.h"
#include "core/random.h"
#include "core/robot_model.h"
#include "tests/core/temporary_folder.h"

// A URDF alone is a robot: what it leaves open is assumed and told, or refused, never guessed.
namespace nao {
namespace {

const char* const kInertia =
    "<inertia ixx='0.01' iyy='0.01' izz='0.01' ixy='0' ixz='0' iyz='0'/></inertial>";

std::string link(const std::string& name, const std::string& collision = "") {
  return "<link name='" + name + "'><inertial><mass value='1'/>" + kInertia + collision +
         "</link>\n";
}

std::string hinge(const std::string& name, const std::string& parent, const std::string& child,
                  const std::string& limit = "lower='-1' upper='2' effort='4' velocity='3'") {
  return "<joint name='" + name + "' type='revolute'><parent link='" + parent + "'/><child link='" +
         child + "'/><axis xyz='0 1 0'/><limit " + limit + "/></joint>\n";
}

std::string solid(const std::string& geometry, const std::string& name = "") {
  return "<collision" + (name.empty() ? "" : " name='" + name + "'") + "><geometry>" + geometry +
         "</geometry></collision>";
}

class BareUrdf : public ::testing::Test {
 protected:
  std::shared_ptr<const RobotModel> load(const std::string& elements) const {
    return loadRobotModel(
        "", folder_.write("thing.urdf", "<robot name='t'>\n" + elements + "</robot>"));
  }
  std::string complaintAbout(const std::string& elements) const {
    try {
      load(elements);
    } catch (const InputError& error) {
      return folder_.withoutPath(error.what());
    }
    return "none";
  }
  TemporaryFolder folder_;
};

bool tells(const RobotModel& model, const std::string& note) {
  return std::any_of(model.notes.begin(), model.notes.end(),
                     [&](const std::string& n) { return n.find(note) != std::string::npos; });
}

TEST_F(BareUrdf, GetsMotorsAfterItsLimitsAndSaysSo) {
  const auto model = load(link("trunk") + link("arm") + hinge("elbow", "trunk", "arm"));
  EXPECT_EQ(model->name, "thing");
  EXPECT_FALSE(model->fixed_base);
  ASSERT_EQ(model->jointCount(), 1u);
  const Actuator& motor = model->actuators[0];
  EXPECT_DOUBLE_EQ(motor.efficiency * motor.stall_torque, 4);
  EXPECT_DOUBLE_EQ(motor.no_load_speed, 3);
  EXPECT_DOUBLE_EQ(motor.kp, 200);
  EXPECT_DOUBLE_EQ(motor.kd, 1.4 * std::sqrt(1.5 * motor.kp * motor.rotor_inertia));
  EXPECT_TRUE(tells(*model, "motors after the URDF's limits"));
  EXPECT_EQ(model->groups.at("Body"), std::vector<std::string>{"elbow"});
}

TEST_F(BareUrdf, WithoutEffortTurnsFreely) {
  const auto model =
      load(link("trunk") + link("tail") +
           hinge("wag", "trunk", "tail", "lower='-1' upper='1' effort='0' velocity='0'"));
  EXPECT_EQ(model->actuators[0].stall_torque, 0);
  EXPECT_EQ(model->actuators[0].kp, 0);
  EXPECT_EQ(model->actuators[0].no_load_speed, 10);
  EXPECT_TRUE(tells(*model, "effort 0, so without a motor and turning freely: wag"));
  EXPECT_TRUE(tells(*model, "velocity 0, taken as 10 rad/s: wag"));
}

TEST_F(BareUrdf, StartsAtZeroOrNextToIt) {
  const auto model = load(link("trunk") + link("a") + link("b") + hinge("free", "trunk", "a") +
                          hinge("bent", "a", "b", "lower='0.5' upper='1' effort='1' velocity='1'"));
  const Posture* start = model->findPosture(model->start_posture);
  ASSERT_NE(start, nullptr);
  EXPECT_EQ(start->angle[0], 0);
  EXPECT_EQ(start->angle[1], 0.5);
  EXPECT_TRUE(tells(*model, "whose range is without it: bent"));
}

TEST_F(BareUrdf, RootWithoutMassIsBoltedDown) {
  const auto model = load("<link name='base'/>\n" + link("arm") + hinge("turn", "base", "arm"));
  EXPECT_TRUE(model->fixed_base);
  EXPECT_TRUE(tells(*model, "root 'base' is bolted down: it has no mass"));
}

TEST_F(BareUrdf, TheWorldIsBoltedDownWhateverIsFixedToIt) {
  const auto model = load("<link name='world'/>\n" + link("base") + link("arm") +
                          "<joint name='bolt' type='fixed'><parent link='world'/>"
                          "<child link='base'/></joint>\n" +
                          hinge("turn", "base", "arm"));
  EXPECT_TRUE(model->fixed_base);
  EXPECT_EQ(model->bodies.size(), 2u);
}

TEST_F(BareUrdf, AFloatingJointBelowTheWorldMakesARobotThatMoves) {
  const auto model = load("<link name='world'/>\n" + link("base") + link("arm") +
                          "<joint name='free' type='floating'><parent link='world'/>"
                          "<child link='base'/></joint>\n" +
                          hinge("turn", "base", "arm"));
  EXPECT_FALSE(model->fixed_base);
  EXPECT_EQ(model->bodies[0].name, "base");
  EXPECT_EQ(model->bodies[0].parent, -1);
}

TEST_F(BareUrdf, MeetsTheGroundWithItsSolids) {
  const auto model =
      load(link("ball", solid("<sphere radius='0.1'/>")) +
           link("box", solid("<box size='0.2 0.4 0.6'/>")) +
           link("can", solid("<cylinder radius='0.1' length='0.3'/>")) +
           link("pill", solid("<cylinder radius='0.1' length='0.5'/>", "a_capsule")) +
           hinge("a", "ball", "box") + hinge("b", "box", "can") + hinge("c", "can", "pill"));
  ASSERT_EQ(model->contact_spheres.size(), 1u + 8 + 16 + 2);
  EXPECT_EQ(model->contact_spheres[0].radius, 0.1);
  EXPECT_NEAR((model->contact_spheres[1].p_B - Vec3(-0.1, -0.2, -0.3)).norm(), 0, 1e-15);
  const ContactSphere& tip = model->contact_spheres.back();
  EXPECT_EQ(model->bodies[static_cast<std::size_t>(tip.body)].name, "pill");
  EXPECT_NEAR(tip.p_B.z() - tip.radius, -0.25, 1e-15);  // from tip to tip 0.5 m
}

TEST_F(BareUrdf, MeshesTouchNothingAndThatIsTold) {
  const auto model =
      load(link("trunk", solid("<mesh filename='trunk.stl'/>")) +
           link("arm", solid("<mesh filename='a.stl'/>") + solid("<sphere radius='0.1'/>")) +
           hinge("turn", "trunk", "arm"));
  EXPECT_TRUE(tells(*model, "collision meshes are left out, so these touch nothing: trunk"));
  EXPECT_FALSE(tells(*model, "nothing: trunk, arm"));
}

TEST_F(BareUrdf, BodiesOfOneHingeOrOfTwoInARowNeverTouch) {
  const auto model = load(link("a") + link("b") + link("c") + link("d") + hinge("ab", "a", "b") +
                          hinge("bc", "b", "c") + hinge("cd", "c", "d"));
  EXPECT_EQ(model->no_collision,
            (std::vector<std::pair<int, int>>{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}}));
  EXPECT_TRUE(tells(*model, "one other body between them"));
}

TEST_F(BareUrdf, WhatCanNotBeSimulatedIsRefusedWithItsLine) {
  const std::string two = link("trunk") + link("arm");
  const auto joint = [](const std::string& type, const std::string& more) {
    return "<joint name='j' type='" + type +
           "'><parent link='trunk'/><child link='arm'/><axis xyz='0 0 1'/>" + more + "</joint>\n";
  };
  const std::string limit = "<limit lower='0' upper='1' effort='1' velocity='1'/>";
  for (const char* type : {"prismatic", "planar", "floating", "hinge"}) {
    EXPECT_EQ(complaintAbout(two + joint(type, limit)),
              "thing.urdf:4: `type`: expected revolute, continuous or fixed, found '" +
                  std::string(type) + "'");
  }
  EXPECT_EQ(complaintAbout(two + link("hand") + hinge("wrist", "arm", "hand") +
                           joint("revolute", limit + "<mimic joint='wrist' multiplier='-1'/>")),
            "thing.urdf:6: `mimic`: expected multiplier 1 and offset 0, one motor turns both "
            "alike");
  EXPECT_EQ(complaintAbout(two + hinge("leg/knee", "trunk", "arm")),
            "thing.urdf:4: joint 'leg/knee': a joint that moves names keys of the robot's memory, "
            "whose parts `/` separates; expected a name without `/`");
  EXPECT_EQ(complaintAbout(link("trunk") + "<link name='arm'/>\n" + hinge("j", "trunk", "arm")),
            "thing.urdf:3: link 'arm': a body that moves needs an <inertial> with a mass above 0");
  EXPECT_EQ(complaintAbout("<link name='a'><inertial><mass value='-1'/>" + std::string(kInertia) +
                           "</link>\n"),
            "thing.urdf:2: `value` of <mass>: expected a number from 0 up, found '-1'");
  EXPECT_EQ(complaintAbout(
                two + hinge("j", "trunk", "arm", "lower='0' upper='1' effort='-2' velocity='1'")),
            "thing.urdf:4: `effort` of <limit>: expected a number from 0 up, found '-2'");
  EXPECT_EQ(complaintAbout(link("a", solid("<sphere radius='0'/>"))),
            "thing.urdf:2: `radius` of <sphere>: expected sizes above 0, found '0'");
  EXPECT_EQ(complaintAbout("<link/>\n"), "thing.urdf:2: `name`: missing in <link>");
}

TEST_F(BareUrdf, TreesWithNoneOrTwoRootsAreRefused) {
  EXPECT_EQ(complaintAbout("").rfind("thing.urdf:1: not a robot tree: ", 0), 0u);
  EXPECT_EQ(complaintAbout(link("a") + link("b")).rfind("thing.urdf:1: not a robot tree: ", 0), 0u);
  EXPECT_EQ(complaintAbout(link("a") + link("b") + hinge("ab", "a", "b") + hinge("ba", "b", "a"))
                .rfind("thing.urdf:1: not a robot tree: ", 0),
            0u);
}

// Whatever is missing or garbled, the file loads or is refused in a sentence; nothing else.
TEST_F(BareUrdf, DamagedAnywhereItIsARobotOrASentence) {
  std::ifstream stream(NAO_SOURCE_DIR "/robots/spider/model.urdf");
  const std::string whole((std::istreambuf_iterator<char>(stream)), {});
  const auto check = [&](const std::string& text) {
    const std::string file = folder_.write("damaged.urdf", text);
    try {
      EXPECT_GT(loadRobotModel("", file)->bodies.size(), 0u);
    } catch (const InputError& error) {
      EXPECT_EQ(folder_.withoutPath(error.what()).rfind("damaged.urdf:", 0), 0u) << error.what();
    }
  };
  for (std::size_t from = 0; from < whole.size(); from = whole.find('\n', from) + 1) {
    check(whole.substr(0, from) + whole.substr(whole.find('\n', from) + 1));  // a line left out
    if (whole.find('\n', from) == std::string::npos) break;
  }
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    std::string text = whole;
    for (int k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(random.uniform(0, static_cast<double>(text.size())));
      text[at] = "0<\"/ -x9"[static_cast<std::size_t>(random.uniform(0, 8))];
    }
    check(text);
  }
}

TEST_F(BareUrdf, AFileThatIsNotThereIsNamed) {
  EXPECT_THROW(loadRobotModel("", folder_.path() + "/none.urdf"), InputError);
}

TEST_F(BareUrdf, AFolderWithAUrdfAloneIsARobotToo) {
  folder_.write("robots/lone/model.urdf", "<robot name='t'>" + link("a") + "</robot>");
  const auto model = loadRobotModel(folder_.path() + "/robots", "lone");
  EXPECT_EQ(model->name, "lone");
  EXPECT_FALSE(model->notes.empty());
}

// Robot descriptions by others, as they are.
class OthersBareUrdf : public ::testing::Test {
 protected:
  static std::shared_ptr<const RobotModel> load(const std::string& name) {
    return loadRobotModel("", NAO_SOURCE_DIR "/../shared/models/" + name);
  }
  void SetUp() override {
    if (!std::filesystem::exists(NAO_SOURCE_DIR "/../shared/models/darwin.urdf")) {
      GTEST_SKIP() << "no ../shared/models here";
    }
  }
};

TEST_F(OthersBareUrdf, AiboDarwinAndAnOlderNaoLoad) {
  EXPECT_EQ(load("Aibo.urdf")->jointCount(), 17u);
  EXPECT_EQ(load("naoV32_no_mesh.urdf")->jointCount(), 25u);
  const auto darwin = load("darwin.urdf");
  EXPECT_EQ(darwin->bodies.size(), 25u);
  EXPECT_TRUE(tells(*darwin, "inertia replaced by the nearest that a solid can have"));
  EXPECT_FALSE(darwin->fixed_base);
}

TEST_F(OthersBareUrdf, AnArmWithoutMassesIsRefused) {
  try {
    load("irb2400.urdf");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("irb2400.urdf:46: link 'link_1': a body that moves needs an <inertial>"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace nao

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "core/check.h"
#include "core/robot_model.h"
#include "tests/core/temporary_folder.h"

namespace nao {
namespace {

std::string read(const std::string& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

// Line numbers are looked up, so that the robot's files may grow.
int lineOf(const std::string& text, std::size_t at) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<long>(at), '\n'));
}

/// A copy of a shipped robot in which one place is broken, and what loading it complains.
class BrokenRobot {
 public:
  /// Replaces the first `old_text` after `anchor` in `file`; remembers the line.
  BrokenRobot(const std::string& file, const std::string& anchor, const std::string& old_text,
              const std::string& new_text) {
    for (const char* part :
         {"model.urdf", "body.yaml", "postures.yaml", "ways.yaml", "cameras.yaml"}) {
      std::string text = read(std::string(NAO_SOURCE_DIR "/robots/nao_h21_v33/") + part);
      if (file == part) text = replaced(text, anchor, old_text, new_text);
      folder_.write(std::string("broken/") + part, text);
    }
  }

  /// The complaint, with the line of the broken place written as @.
  std::string complaint() const {
    try {
      loadRobotModel(folder_.path(), "broken");
    } catch (const InputError& error) {
      std::string text = folder_.withoutPath(error.what());
      const std::string line = ":" + std::to_string(line_) + ":";
      const auto at = text.find(line);
      return at == std::string::npos ? text : text.replace(at, line.size(), ":@:");
    }
    return "no complaint";
  }

 private:
  std::string replaced(std::string text, const std::string& anchor, const std::string& old_text,
                       const std::string& new_text) {
    const auto start = text.find(anchor);
    EXPECT_NE(start, std::string::npos) << anchor;
    const auto at = text.find(old_text, start);
    EXPECT_NE(at, std::string::npos) << old_text;
    line_ = lineOf(text, at);
    return text.replace(at, old_text.size(), new_text);
  }

  TemporaryFolder folder_;
  int line_ = 0;
};

std::string complaintAbout(const std::string& file, const std::string& anchor,
                           const std::string& old_text, const std::string& new_text) {
  return BrokenRobot(file, anchor, old_text, new_text).complaint();
}

TEST(BrokenRobot, IsWholeUntilBroken) {
  EXPECT_EQ(complaintAbout("body.yaml", "cycle_ms", "10", "20"), "no complaint");
}

TEST(BrokenRobot, UnknownNameListsTheKnownOnes) {
  try {
    loadRobotModel(NAO_SOURCE_DIR "/robots", "pepper");
    FAIL();
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.rfind("robot 'pepper' is unknown, expected one of: ", 0), 0u) << text;
    EXPECT_NE(text.find("nao_h21_v33, nao_h21_v33_ideal, nao_h21_v33_no_hull"), std::string::npos)
        << text;
  }
}

TEST(BrokenRobot, NamesAreNoPaths) {
  EXPECT_THROW(loadRobotModel(NAO_SOURCE_DIR "/worlds", "../robots/nao_h21_v33"), InputError);
  EXPECT_THROW(loadRobotModel(NAO_SOURCE_DIR "/robots", ""), InputError);
  EXPECT_THROW(loadRobotModel("/nowhere", "nao_h21_v33"), InputError);
}

TEST(BrokenRobot, UrdfComplaintsNameTheLine) {
  const auto urdf = [](const std::string& anchor, const std::string& from, const std::string& to) {
    return complaintAbout("model.urdf", anchor, from, to);
  };
  EXPECT_EQ(urdf("<link name=\"LKneePitch\"", "0.29159", "heavy"),
            "broken/model.urdf:@: `value` of <mass>: expected a number, found 'heavy'");
  EXPECT_EQ(urdf("<joint name=\"LKneePitch\"", "0 0 -0.1\"", "0 0\""),
            "broken/model.urdf:@: `xyz` of <origin>: expected 3 numbers, found '0 0'");
  EXPECT_EQ(urdf("<joint name=\"LKneePitch\"", "parent link=\"LHipPitch\"", "parent link=\"Hip\""),
            "broken/model.urdf:@: `link`: expected the name of a <link>, found 'Hip'");
  EXPECT_EQ(urdf("<joint name=\"LKneePitch\"", "revolute", "prismatic"),
            "broken/model.urdf:@: `type`: expected revolute, continuous or fixed, found "
            "'prismatic'");
  EXPECT_EQ(urdf("<joint name=\"LKneePitch\"", "lower=\"-0.092346\"", "lower=\"2.112528\""),
            "broken/model.urdf:@: `lower`: expected another number than `upper`, found '2.112528'");
  EXPECT_EQ(urdf("<mimic", "LHipYawPitch", "LHip"),
            "broken/model.urdf:@: `joint`: expected the name of a <joint>, found 'LHip'");
  EXPECT_EQ(urdf("<link name=\"RKneePitch\"", "RKneePitch", "LKneePitch"),
            "broken/model.urdf:@: `LKneePitch`: a <link> given twice");
  EXPECT_EQ(urdf("<link name=\"LHipRoll\"", "LHipRoll", ""),
            "broken/model.urdf:@: `name`: missing in <link>");
}

TEST(BrokenRobot, BrokenXmlNamesTheLine) {
  const std::string complaint =
      complaintAbout("model.urdf", "<joint name=\"LKneePitch\"", "</joint>", "</joind>");
  EXPECT_EQ(complaint.rfind("broken/model.urdf:", 0), 0u) << complaint;
  EXPECT_NE(complaint.find(": not XML: "), std::string::npos) << complaint;
}

TEST(BrokenRobot, BodiesThatCanNotExistAreRefused) {
  // Found when the bodies are whole: the line is the <link>'s.
  const std::string anchor = "<link name=\"LKneePitch\"";
  const std::string knee = "link 'LKneePitch': ";
  EXPECT_NE(complaintAbout("model.urdf", anchor, "izz=\"0.000181565916\"", "izz=\"1\"")
                .find(knee + "its inertia breaks the triangle inequality"),
            std::string::npos);
  EXPECT_NE(complaintAbout("model.urdf", anchor, "izz=\"0.000181565916\"", "izz=\"-1\"")
                .find(knee + "its inertia is not positive definite"),
            std::string::npos);
  EXPECT_NE(complaintAbout("model.urdf", anchor, "mass value=\"0.29159\"", "mass value=\"0\"")
                .find(knee + "a body that moves needs an <inertial> with a mass above 0"),
            std::string::npos);
}

TEST(BrokenRobot, BodyComplaintsNameTheLine) {
  const auto body = [](const std::string& anchor, const std::string& from, const std::string& to) {
    return complaintAbout("body.yaml", anchor, from, to);
  };
  EXPECT_EQ(body("drives:", "efficiency: 0.7", "efficiency: 7"),
            "broken/body.yaml:@: `efficiency`: expected a number in [0.01, 1], found '7'");
  EXPECT_EQ(
      body("cycle_ms", "cycle_ms", "cycle"),
      "broken/body.yaml:@: `cycle`: unknown key, expected one of actuators, aliases, battery, "
      "boards, "
      "body_type, contact_spheres, coupled_limits, cycle_ms, drives, effects, feet, "
      "fixed_base, frames, groups, imu, like, no_collision, noise, repair_inertia, solids, sonar, "
      "variation, version");
  EXPECT_EQ(body("name: LKneePitch", "LKneePitch", "LKnee"),
            "broken/body.yaml:@: `name`: expected a joint of model.urdf, or a `range` beside it, "
            "found 'LKnee'");
  EXPECT_EQ(body("name: LKneePitch", "leg_pitch", "rocket"),
            "broken/body.yaml:@: `drive`: expected one of `drives`, or none, found 'rocket'");
  EXPECT_EQ(body("name: LKneePitch", "LKneePitch", "RHipYawPitch"),
            "broken/body.yaml:@: `name`: expected a hinge of its own: RHipYawPitch follows "
            "LHipYawPitch, found 'RHipYawPitch'");
  EXPECT_EQ(body("driver: LAnklePitch", "LAnklePitch", "LAnkle"),
            "broken/body.yaml:@: `driver`: expected the name of an actuator, found 'LAnkle'");
  EXPECT_EQ(body("imu:", "body: Torso", "body: Chest"),
            "broken/body.yaml:@: `body`: expected the name of a link of model.urdf, found 'Chest'");
  EXPECT_EQ(body("imu:", "gyro_axes: 2", "gyro_axes: 4"),
            "broken/body.yaml:@: `gyro_axes`: expected a whole number in [2, 3], found '4'");
  EXPECT_EQ(body("groups:", "Head: [HeadYaw, HeadPitch]", "Head: [HeadYaw, HeadPit]"),
            "broken/body.yaml:@: `Head`: expected names of joints or groups, 'HeadPit' is "
            "neither, found a list");
}

TEST(BrokenRobot, AHingeWithoutAMotorIsNamedWhereItStands) {
  const std::string complaint =
      complaintAbout("body.yaml", "actuators:", "  - {name: LKneePitch, drive: leg_pitch}\n", "");
  EXPECT_NE(complaint.find("joint 'LKneePitch': expected an actuator for it in body.yaml"),
            std::string::npos)
      << complaint;
  EXPECT_EQ(complaint.rfind("broken/model.urdf:", 0), 0u);
}

TEST(BrokenRobot, PostureComplaintsNameTheLine) {
  const auto postures = [](const std::string& anchor, const std::string& from,
                           const std::string& to) {
    return complaintAbout("postures.yaml", anchor, from, to);
  };
  EXPECT_EQ(postures("name: Stand\n", "LKneePitch: ", "LKneePitch: 9"),
            "broken/postures.yaml:@: `LKneePitch`: expected a number in [-0.092446, 2.11263], "
            "found '9-0.09233'");
  EXPECT_EQ(postures("start:", "Crouch", "Fly"),
            "broken/postures.yaml:@: `start`: expected one of `postures`, found 'Fly'");
}

// A key that is missing has no line of its own: the line is that of the map around it.
TEST(BrokenRobot, MissingKeysAreLookedForInTheirMap) {
  const std::string drive = complaintAbout("body.yaml", "drives:", "gear_ratio: 150.27\n", "\n");
  const std::string posture = complaintAbout("postures.yaml", "name: Crouch", "HeadYaw: 0\n", "\n");
  const std::string text = read(NAO_SOURCE_DIR "/robots/nao_h21_v33/body.yaml");
  const int line = lineOf(text, text.find("head_yaw:"));
  EXPECT_EQ(drive, "broken/body.yaml:" + std::to_string(line) +
                       ": `gear_ratio`: missing, expected a number above 0");
  EXPECT_NE(posture.find(": `HeadYaw`: missing, expected a number in [-2.0858, 2.0858]"),
            std::string::npos)
      << posture;
}

TEST(BrokenRobot, CameraComplaintsNameTheLine) {
  EXPECT_EQ(complaintAbout("cameras.yaml", "hfov_deg", "47.8", "478"),
            "broken/cameras.yaml:@: `hfov_deg`: expected a number in [1, 170], found '478'");
  EXPECT_EQ(complaintAbout("cameras.yaml", "frame_rates", "[5, 10", "[15, 10"),
            "broken/cameras.yaml:@: `frame_rates`: expected one rate or more, rising, found a "
            "list");
}

TEST(BrokenRobot, WaysNameTheLineOfTheirFault) {
  const std::string way = "name: LieBack";
  const std::string families =
      "Crouching, Knee, LyingBack, LyingBelly, LyingLeft, LyingRight, Sitting, Standing, Unknown";
  EXPECT_EQ(complaintAbout("ways.yaml", way, "to: LyingBack", "to: Lying"),
            "broken/ways.yaml:@: `to`: expected families of postures (" + families +
                "), not Lying, found 'Lying'");
  EXPECT_EQ(complaintAbout("ways.yaml", way, "[Sitting]", "[Sitting, Seated]"),
            "broken/ways.yaml:@: `from`: expected families of postures (" + families +
                "), not Seated, found a list");
  EXPECT_EQ(complaintAbout("ways.yaml", way, "HipYawPitch: -0.3", "HipYawPich: -0.3"),
            "broken/ways.yaml:@: `HipYawPich`: expected a joint of this robot, found '-0.3'");
  EXPECT_EQ(complaintAbout("ways.yaml", way, "HipPitch: -1.0", "HipPitch: -2.0"),
            "broken/ways.yaml:@: `HipPitch`: expected an angle in the range of LHipPitch, found "
            "'-2.0'");
  EXPECT_EQ(complaintAbout("ways.yaml", way, "time: 0.8", "time: -1"),
            "broken/ways.yaml:@: `time`: expected a number above 0, found '-1'");
  EXPECT_EQ(complaintAbout("ways.yaml", way, "time: 0.8\n", "patience: 1\n"),
            "broken/ways.yaml:@: `time`: missing, expected a number above 0");
  EXPECT_EQ(complaintAbout("ways.yaml", way, "time: 0.8",
                           "pitch: [1, 0]\n        patience: 1\n        time: 0.8"),
            "broken/ways.yaml:@: `pitch`: expected a low angle and a higher one, found a list");
  EXPECT_EQ(complaintAbout("ways.yaml", way, "name: LieBack", "name: SitBackDown"),
            "broken/ways.yaml:@: `name`: expected a name that no other way has, found "
            "'SitBackDown'");
}

// A file cut off anywhere is refused with a sentence, or whole enough to load; nothing else.
TEST(BrokenRobot, FilesCutOffAnywhereAreRefusedInASentence) {
  const std::string robot = NAO_SOURCE_DIR "/robots/nao_h21_v33/";
  const TemporaryFolder folder;
  const std::vector<std::string> parts{"model.urdf", "body.yaml", "postures.yaml", "ways.yaml",
                                       "cameras.yaml"};
  for (const std::string& part : parts) folder.write("cut/" + part, read(robot + part));
  for (const std::string& part : parts) {
    const std::string whole = read(robot + part);
    for (std::size_t i = 0; i < 60; ++i) {
      folder.write("cut/" + part, whole.substr(0, whole.size() * i / 60));
      try {
        loadRobotModel(folder.path(), "cut");
      } catch (const InputError& error) {
        EXPECT_EQ(folder.withoutPath(error.what()).rfind("cut/", 0), 0u) << error.what();
      }
    }
    folder.write("cut/" + part, whole);
  }
  EXPECT_NO_THROW(loadRobotModel(folder.path(), "cut"));
}

}  // namespace
}  // namespace nao

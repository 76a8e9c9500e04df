#include <gtest/gtest.h>

#include "core/check.h"
#include "motion/timeline/motion_file.h"
#include "motion/timeline/pml.h"
#include "motion/timeline/xar.h"
#include "tests/core/temporary_folder.h"
#include "tests/motion/test_robot.h"

namespace nao::motion {
namespace {

constexpr double kExact = 1e-9;

std::string nod(const std::string& inner) {
  return "<ChoregrapheProject xar_version=\"3\"><Box name=\"nod\" id=\"-1\">"
         "<Timeline enable=\"1\" fps=\"10\" start_frame=\"0\"><ActuatorList>"
         "<ActuatorCurve actuator=\"HeadPitch\" unit=\"0\"><Key frame=\"15\" value=\"9\"/>"
         "</ActuatorCurve></ActuatorList>" +
         inner + "</Timeline></Box></ChoregrapheProject>";
}

std::string package(const std::string& behaviors) {
  return "<?xml version=\"1.0\"?>\n<Package name=\"p\" format_version=\"4\">\n"
         "<BehaviorDescriptions>" +
         behaviors + "</BehaviorDescriptions></Package>\n";
}

std::string errorOf(const std::string& text) {
  try {
    behaviorOfPackage(text, "p.pml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Pml, ThePackagesBehaviorIsPlayed) {
  const TemporaryFolder folder;
  folder.write("nod/behavior.xar", nod(""));
  const std::string file = folder.write(
      "p.pml", package("<BehaviorDescription name=\"b\" src=\"nod\" xar=\"behavior.xar\"/>"));
  const auto robot = makeTestRobot();
  EXPECT_NEAR(loadMotion(file, *robot).length, 1.5, kExact);
  EXPECT_NEAR(loadMotion(folder.path() + "/nod", *robot).length, 1.5, kExact);
}

TEST(Pml, WhatIsWrongIsToldWithItsLine) {
  EXPECT_EQ(errorOf("<a/>"), "p.pml:1: expected a <Package>");
  EXPECT_EQ(errorOf(package("")), "p.pml:2: this package has no behavior");
  EXPECT_EQ(errorOf(package("<BehaviorDescription src=\"a\"/><BehaviorDescription src=\"b\"/>")),
            "p.pml:2: this package has several behaviors; name one of a/behavior.xar "
            "b/behavior.xar");
}

TEST(Xar, EachBoxCanBePlayedAlone) {
  const std::string inner =
      "<BehaviorLayer><BehaviorKeyframe index=\"0\"><Diagram><Box name=\"yaw\" id=\"1\">"
      "<Timeline enable=\"1\" fps=\"40\" start_frame=\"0\"><ActuatorList>"
      "<ActuatorCurve actuator=\"HeadYaw\" unit=\"0\"><Key frame=\"100\" value=\"9\"/>"
      "</ActuatorCurve></ActuatorList></Timeline></Box></Diagram></BehaviorKeyframe>"
      "</BehaviorLayer>";
  const auto boxes = readXarBoxes(nod(inner), "a.xar", *makeTestRobot());
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_EQ(boxes[0].box, "nod");
  EXPECT_NEAR(boxes[0].timeline.length, 2.5, kExact);  // nobody links to "yaw": all start at once
  EXPECT_EQ(boxes[1].box, "yaw");
  EXPECT_NEAR(boxes[1].timeline.length, 2.5, kExact);
  EXPECT_EQ(boxes[1].timeline.curves.size(), 1u);
}

// Lengths are last frame - start frame over fps, read off the files.
TEST(Xar, WhatOnlyAChoiceWouldStartPlaysBoxByBox) {
  const std::string motions = NAO_SOURCE_DIR "/../shared/motions/";
  if (!std::filesystem::exists(motions)) GTEST_SKIP() << "no " << motions << " here";
  const std::vector<std::pair<std::string, std::vector<std::pair<std::string, double>>>> files = {
      {"kouretes+Monas/StandUpX.xar",
       {{"SitToCrouch", 7.2},
        {"CrouchToStand", 1.5},
        {"BellyToStand", 10},
        {"BackToStand", 10.5},
        {"SideToBelly", 1}}},
      {"mxochicale+nao/hri-tutorial__behavior_1__behavior.xar",
       {{"High Five", 3.96}, {"Hello", 4.56}, {"Wipe Forehead", 5.04}}}};
  for (const auto& [name, wanted] : files) {
    std::ifstream file(motions + name);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const auto boxes = readXarBoxes(text, name, *makeTestRobot());
    ASSERT_EQ(boxes.size(), wanted.size()) << name;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_EQ(boxes[i].box, wanted[i].first);
      EXPECT_NEAR(boxes[i].timeline.length, wanted[i].second, kExact) << boxes[i].box;
    }
  }
}

}  // namespace
}  // namespace nao::motion

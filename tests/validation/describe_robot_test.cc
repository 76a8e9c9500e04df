#include "validation/describe_robot.h"

#include <gtest/gtest.h>

#include "tests/support/models.h"

namespace nao::validation {
namespace {

const std::vector<Row>& rowsOf(const Report& report, const std::string& name) {
  static const std::vector<Row> none;
  for (const Figure& figure : report.figures) {
    if (figure.name == name) return std::get<std::vector<Row>>(figure.value);
  }
  return none;
}

TEST(DescribeRobot, TellsAllOfANao) {
  const auto model = test::robot("nao_h25_v60");
  const Report report = describeRobot(*model);
  EXPECT_EQ(rowsOf(report, "bodies").size(), model->bodies.size());
  EXPECT_EQ(rowsOf(report, "joints").size(), 25u);
  EXPECT_EQ(rowsOf(report, "motors").size(), 25u);
  EXPECT_EQ(rowsOf(report, "coupled_limits").size(), 13u + 7 + 7);
  EXPECT_EQ(rowsOf(report, "cameras").size(), 2u);
  EXPECT_EQ(rowsOf(report, "effects").size(), model->effects.size() + model->variation.size());
  EXPECT_TRUE(rowsOf(report, "notes").empty());
  const std::string json = toJson(report);
  EXPECT_NE(json.find("\"mass_kg\":5.35975"), std::string::npos);
  EXPECT_NE(json.find("\"hinges\":\"LHipYawPitch RHipYawPitch\""), std::string::npos);
}

TEST(DescribeRobot, NotesAreForPeopleAndPrograms) {
  RobotModel model;
  model.bodies.emplace_back();
  model.notes = {"the tail turns freely"};
  const Report report = describeRobot(model);
  EXPECT_NE(toText(report).find("the tail turns freely"), std::string::npos);
  EXPECT_NE(toJson(report).find("the tail turns freely"), std::string::npos);
}

}  // namespace
}  // namespace nao::validation

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <ostream>
#include <sstream>

#include "core/robot_model.h"

// Each Nao weighs what its documented solids weigh.
namespace nao {
namespace {

struct Published {
  const char* robot;
  const char* body;     // as in the table of masses
  const char* version;  // likewise
  double sum;           // [kg] of the documented solids; the H21's forearms once
  double declared;      // [kg] that the documentation calls the whole; 0: none
  double torso[6];      // [kg m^2] about the centre of mass: xx, yy, zz, xy, xz, yz
};

void PrintTo(const Published& one, std::ostream* out) { *out << one.robot; }

// From the tables of NAOqi 2.1.4.13 (masses pages) and NAOH25V60.urdf.
const Published kPublished[] = {
    {"nao_h21_v33",
     "H21",
     "V3.3",
     4.88083,
     4.879,
     {3.08278389e-3, 2.88881415e-3, 1.57994585e-3, 1.247398e-5, -1.92152524e-5, -2.477669e-5}},
    {"nao_h21_v33_ideal",
     "H21",
     "V3.3",
     4.88083,
     4.879,
     {3.08278389e-3, 2.88881415e-3, 1.57994585e-3, 1.247398e-5, -1.92152524e-5, -2.477669e-5}},
    {"nao_h21_v40",
     "H21",
     "V4",
     5.03761,
     5.029339,
     {3.08353366e-3, 2.88342586e-3, 1.59239712e-3, 1.43115803e-5, -3.30282794e-5, -2.70793407e-5}},
    {"nao_h25_v33",
     "H25",
     "V3.3",
     4.99837,
     4.996,
     {3.08278389e-3, 2.88881415e-3, 1.57994585e-3, 1.247398e-5, -1.92152524e-5, -2.477669e-5}},
    {"nao_h25_v40",
     "H25",
     "V4",
     5.19539,
     5.19535,
     {3.08353366e-3, 2.88342586e-3, 1.59239712e-3, 1.43115803e-5, -3.30282794e-5, -2.70793407e-5}},
    {"nao_h25_v50",
     "H25",
     "V5",
     5.30539,
     5.30535,
     {3.08353366e-3, 2.88342586e-3, 1.59239712e-3, 1.43115803e-5, -3.30282794e-5, -2.70793407e-5}},
    {"nao_h25_v60",
     "H25",
     "V6",
     5.35975,
     0,
     {3.08361e-3, 2.8835e-3, 1.5924e-3, 1.43116e-5, -3.30211e-5, -2.70793e-5}},
};

constexpr double kDigits = 1e-11;  // [kg m^2] the tables' last digit, and its rounding here

class NaoMasses : public ::testing::TestWithParam<Published> {
 protected:
  const std::shared_ptr<const RobotModel> model_ =
      loadRobotModel(NAO_SOURCE_DIR "/robots", GetParam().robot);
};
INSTANTIATE_TEST_SUITE_P(Robots, NaoMasses, ::testing::ValuesIn(kPublished),
                         [](const auto& test) { return std::string(test.param.robot); });

// Rounding of 21 to 25 solids to 10 mg each.
TEST_P(NaoMasses, AreTheSumOfTheSolids) {
  EXPECT_NEAR(model_->totalMass(), GetParam().sum, 25 * 5e-6);
}

// The documentation does not quite add up: H21 V4 declares 8.3 g less than its solids weigh.
TEST(NaoDeclaredMasses, DifferFromTheSolidsByUpToNineGrams) {
  for (const Published& nao : kPublished) {
    if (nao.declared == 0) continue;
    EXPECT_NEAR(nao.sum, nao.declared, 0.009) << nao.robot;
  }
}

TEST_P(NaoMasses, HaveThePublishedTorso) {
  const Mat3& I = model_->bodies[0].I_Bcm;
  const double found[] = {I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)};
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(found[i], GetParam().torso[i], kDigits) << i;
}

// A table with a header, by column; cells are never quoted in the ones read here.
std::vector<std::map<std::string, std::string>> readTable(const std::string& file) {
  std::ifstream stream(file);
  const auto split = [](const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream words(line);
    for (std::string cell; std::getline(words, cell, ',');) cells.push_back(cell);
    return cells;
  };
  std::string line;
  std::getline(stream, line);
  const auto header = split(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(stream, line)) {
    const auto cells = split(line);
    rows.emplace_back();
    for (std::size_t i = 0; i < std::min(cells.size(), header.size()); ++i) {
      rows.back()[header[i]] = cells[i];
    }
  }
  return rows;
}

// On an H21 the hand's solid contains the forearm, which has a row of its own nevertheless.
bool countsTwice(const std::map<std::string, std::string>& row) {
  return row.at("body") == "H21" &&
         row.at("doc_section").find("Motorized ForeArm") != std::string::npos;
}

TEST_P(NaoMasses, EqualTheirTableSolidBySolid) {
  const bool v6 = std::string(GetParam().version) == "V6";
  const std::string file = std::string(NAO_SOURCE_DIR "/../shared/data/") +
                           (v6 ? "masses_v6_zero_pose.csv" : "masses_doc.csv");
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  std::size_t solids = 0;
  for (const auto& row : readTable(file)) {
    if (row.at("body") != GetParam().body || row.at("version") != GetParam().version) continue;
    if (!v6 && countsTwice(row)) continue;
    ++solids;
    const std::string frame = row.at("frame") == "base_link" ? "Torso" : row.at("frame");
    const Body& body = model_->bodies.at(static_cast<std::size_t>(*model_->findBody(frame)));
    const auto number = [&](const char* column) { return std::stod(row.at(column)); };
    EXPECT_NEAR(body.mass, number("mass_kg"), 1e-9) << frame;
    EXPECT_LT((body.p_BoBcm - Vec3(number("com_x"), number("com_y"), number("com_z"))).norm(), 1e-9)
        << frame;
    const Vec3 diagonal(number("Ig_xx"), number("Ig_yy"), number("Ig_zz"));
    const Vec3 products(number("Ig_xy"), number("Ig_xz"), number("Ig_yz"));
    const Mat3& I = body.I_Bcm;
    EXPECT_LT((I.diagonal() - diagonal).norm(), kDigits) << frame;
    EXPECT_LT((Vec3(I(0, 1), I(0, 2), I(1, 2)) - products).norm(), kDigits) << frame;
  }
  EXPECT_EQ(solids, model_->bodies.size());
}

}  // namespace
}  // namespace nao

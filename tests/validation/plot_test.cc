#include "validation/plot.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "core/check.h"
#include "tests/core/temporary_folder.h"

namespace nao::validation {
namespace {

Picture twoPanels() {
  Panel left = makePanel("It's a line", "time [s]", "angle [deg]");
  left.series = {{"ours", {0, 1, 2}, {0, 1, 4}, Stroke::Line, Ink::Blue},
                 {"thesis", {0, 2}, {0, 3}, Stroke::Points, Ink::Thesis}};
  Panel right = makePanel("Parts", "", "time [us]");
  right.series = {{"", {0, 1}, {3, 4}, Stroke::Bars, Ink::Green}};
  right.categories = {"physics", "sensors"};
  return {"Two panels", {left, right}, 2, 800, 400};
}

class Plot : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v gnuplot >/dev/null 2>&1") != 0) {
      GTEST_SKIP() << "gnuplot is not installed: pictures are not drawn here";
    }
  }
  std::string file(const char* name) const { return folder_.path() + "/" + name; }

  TemporaryFolder folder_;
};

std::string contents(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

TEST_F(Plot, DrawsVectorPicturesWithTheirLabels) {
  draw(twoPanels(), file("a.svg"));
  const std::string svg = contents(file("a.svg"));
  EXPECT_EQ(svg.rfind("<?xml", 0), 0u);
  for (const char* label : {"Two panels", "time [s]", "angle [deg]", "ours", "physics"}) {
    EXPECT_NE(svg.find(label), std::string::npos) << label;
  }
  EXPECT_GE(svg.find("</svg>"), 2000u);
}

TEST_F(Plot, DrawsPixelPictures) {
  draw(twoPanels(), file("a.png"));
  const std::string png = contents(file("a.png"));
  EXPECT_EQ(png.substr(0, 4), "\x89PNG");
  EXPECT_GT(png.size(), 4000u);  // an empty page of this size has 2 KB
}

// gnuplot writes a degree sign as it knows it from the language of the machine, which may have none.
TEST_F(Plot, SaysNothingWhereNoLanguageIsSet) {
  const char* found = std::getenv("LC_ALL");
  const std::string before = found == nullptr ? "" : found;
  setenv("LC_ALL", "C", 1);
  testing::internal::CaptureStderr();
  draw(twoPanels(), file("a.svg"));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  setenv("LC_ALL", before.c_str(), 1);  // empty is as good as none
}

TEST_F(Plot, SaysWhereItCanNotWrite) {
  EXPECT_THROW(draw(twoPanels(), file("no/such/folder/a.png")), InputError);
}

TEST(PlotErrors, RefusesOtherEndings) { EXPECT_THROW(draw(twoPanels(), "a.pdf"), InputError); }

TEST(PlotErrors, SaysThatGnuplotIsMissing) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nonexistent", 1);
  try {
    draw(twoPanels(), "a.png");
    ADD_FAILURE() << "drew without gnuplot";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("scripts/setup"), std::string::npos);
  }
  setenv("PATH", path.c_str(), 1);
}

}  // namespace
}  // namespace nao::validation

#include "motion/timeline/xml_mender.h"

#include <gtest/gtest.h>
#include <tinyxml2.h>

namespace nao::motion {
namespace {

// "line: sentence" of every break.
std::vector<std::string> breaksOf(const MendedXml& mended) {
  std::vector<std::string> told;
  for (const auto& b : mended.breaks) told.push_back(std::to_string(b.line) + ": " + b.sentence);
  return told;
}

using Told = std::vector<std::string>;

TEST(XmlMender, LeavesWellFormedTextAlone) {
  const std::string text =
      "<?xml version=\"1.0\"?>\n<!DOCTYPE a>\n<a b='1' c = \"2>3\">\n<!-- <x> --><d/>x &amp; y"
      "<![CDATA[if 1 < 2: <a>]]><e \n/></a>\n";
  const MendedXml mended = mendXml(text);
  EXPECT_EQ(mended.text, text);
  EXPECT_TRUE(mended.breaks.empty());
}

TEST(XmlMender, ClosesWhatATruncatedTextLeavesOpen) {
  const MendedXml mended = mendXml("<a>\n<b x=\"1\">\n<c/>\n<c y=\"");
  EXPECT_EQ(mended.text, "<a>\n<b x=\"1\">\n<c/>\n</b></a>");
  EXPECT_EQ(breaksOf(mended), (Told{"4: the tag <c is not well-formed; it is left out",
                                    "4: the text ends within the <b> of line 2"}));
}

TEST(XmlMender, ATagThatIsNotWellFormedIsLeftOutAloneAndLinesKeepTheirNumbers) {
  const MendedXml mended =
      mendXml("<a>\n<k f=\"1/>\n<k f=2/>\n<k\nf=\"3\"/>\n<k f=\"4\"g=\"5\"/></a>");
  EXPECT_EQ(mended.text, "<a>\n\n\n<k\nf=\"3\"/>\n</a>");
  EXPECT_EQ(mended.breaks.size(), 3u);
  EXPECT_EQ(mended.breaks.back().line, 6);
}

TEST(XmlMender, ElementsThatWereNotClosedEndWhereTheNextOfTheirNameBegins) {
  const MendedXml mended = mendXml("<a><k f=\"1\">\n<k f=\"2\"/></a>");
  EXPECT_EQ(mended.text, "<a><k f=\"1\">\n</k><k f=\"2\"/></a>");
  EXPECT_EQ(breaksOf(mended), Told{"1: <k> is not closed"});
}

TEST(XmlMender, EndsThatCrossAreSetRight) {
  const MendedXml mended = mendXml("<a><b><c></b>\n</c></a></d>");
  EXPECT_EQ(mended.text, "<a><b><c></c></b>\n</a>");
  EXPECT_EQ(breaksOf(mended),
            (Told{"1: <c> is not closed", "2: </c> ends what is not open; it is left out",
                  "2: </d> ends what is not open; it is left out"}));
}

TEST(XmlMender, ACommentWithoutEndTakesTheRest) {
  EXPECT_EQ(mendXml("<a><b/><!-- x\n</a>").text, "<a><b/>\n</a>");
}

// Every prefix of a text is something that the parser takes.
TEST(XmlMender, WhereverATextIsCutTheRestIsWellFormed) {
  const std::string text =
      "<?xml version=\"1.0\"?><a b='1'>\n<!-- c --><d e=\"f\"><g/></d>\n<![CDATA[h]]></a>\n";
  for (std::size_t length = text.find("<a b='1'>") + 9; length < text.size(); ++length) {
    tinyxml2::XMLDocument document;
    const std::string mended = mendXml(text.substr(0, length)).text;
    EXPECT_EQ(document.Parse(mended.c_str()), tinyxml2::XML_SUCCESS) << mended;
  }
}

}  // namespace
}  // namespace nao::motion

#include "validation/play_page.h"

#include <algorithm>
#include <cmath>

#include "validation/html.h"
#include "validation/play_report.h"
#include "validation/png.h"

namespace nao::validation {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr std::size_t kMostPoints = 400;  // of a curve: more than a picture has columns for it

std::string faultsOf(const RobotModel& model, const Played& played) {
  if (played.faults.empty()) return "<p>No faults.</p>\n";
  TextTable table;
  table.title = "Faults";
  table.head = {"kind", "joint", "from [s]", "to [s]", "frame", "what"};
  for (const motion::MotionFault& fault : played.faults) {
    table.lines.push_back(
        {nameOf(fault.kind), fault.joint ? model.actuators[index(*fault.joint)].name : "",
         fixed(fault.time, 2), fixed(fault.until, 2), fixed(fault.frame, 1), fault.text});
  }
  return toHtml(table);
}

std::string stillsOf(const std::vector<Still>& stills) {
  std::string out = "<div class=\"stills\">\n";
  for (const Still& still : stills) {
    out += "<figure><img alt=\"\" src=\"data:image/png;base64," + toBase64(still.png) +
           "\"><figcaption>" + fixed(still.time, 2) + " s</figcaption></figure>\n";
  }
  return out + "</div>\n";
}

Picture drawTorso(const Played& played) {
  const PlayTracks& tracks = played.tracks;
  Panel tilt = makePanel("Tilt of the torso", "time [s]", "tilt [deg]");
  Panel height = makePanel("Height of the torso", "time [s]", "height [m]");
  Series tilts, heights;
  const std::size_t stride = tracks.time.size() / kMostPoints + 1;
  for (std::size_t i = 0; i < tracks.time.size(); i += stride) {
    tilts.x.push_back(tracks.time[i]);
    tilts.y.push_back(tracks.tilt[i] / kDegree);
    heights.x.push_back(tracks.time[i]);
    heights.y.push_back(tracks.height[i]);
  }
  tilt.series = {std::move(tilts)};
  height.series = {std::move(heights)};
  return {"Torso", {tilt, height}, 2, 900, 300};
}

std::string plotsOf(const RobotModel& model, const Played& played) {
  if (played.tracks.time.empty()) return {};
  std::string out = "<h2>Course</h2>\n" + drawSvg(drawTorso(played));
  const auto chains = model.groups.find("Chains");
  if (chains == model.groups.end()) return out;
  for (const std::string& chain : chains->second) {
    const Picture picture = drawTracking(model, played, chain);
    if (!picture.panels.empty()) out += drawSvg(picture);
  }
  return out;
}

}  // namespace

std::string playPage(const RobotModel& model, const Report& report, const Played& played,
                     const std::vector<Still>& stills) {
  const std::string title = report.remarks.empty() ? "Motion" : report.remarks.back();
  std::string page =
      "<h1>" + escapeHtml(report.robot) + "</h1>\n<p>" + escapeHtml(title) + "</p>\n";
  page += stillsOf(stills) + faultsOf(model, played);
  for (const std::string& remark : report.remarks) {
    if (remark.rfind("left out: ", 0) == 0) page += "<p>" + escapeHtml(remark) + "</p>\n";
  }
  for (const TextTable& table : report.tables) page += toHtml(table);
  return htmlPage(title, page + plotsOf(model, played));
}

}  // namespace nao::validation

#include "validation/play_report.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace nao::validation {
namespace {

using motion::MotionFault;

constexpr double kDegree = M_PI / 180;
constexpr std::size_t kMostPoints = 400;  // of a curve: more than a picture has columns for it
constexpr MotionFault::Kind kKinds[] = {
    MotionFault::Kind::File,         MotionFault::Kind::Key,      MotionFault::Kind::JointLimit,
    MotionFault::Kind::CoupledLimit, MotionFault::Kind::Velocity, MotionFault::Kind::Torque,
    MotionFault::Kind::Collision,    MotionFault::Kind::Fall};

std::string jointName(const RobotModel& model, const MotionFault& fault) {
  return fault.joint ? model.actuators[index(*fault.joint)].name : std::string();
}

Row rowOf(const RobotModel& model, const MotionFault& fault) {
  return {{"kind", std::string(nameOf(fault.kind))},
          {"joint", jointName(model, fault)},
          {"time_s", fault.time},
          {"until_s", fault.until},
          {"frame", fault.frame},
          {"value", fault.value},
          {"limit", fault.limit},
          {"text", fault.text}};
}

// How far a joint was from where it was told to be a cycle ago.
struct Tracking {
  double worst = 0;  // [rad]
  double rms = 0;    // [rad]
  double last = 0;   // [rad] at the very end
};

Tracking trackingOf(const PlayTracks& tracks, std::size_t joint) {
  Tracking found;
  const std::size_t cycles = tracks.time.size();
  for (std::size_t i = 1; i < cycles; ++i) {
    found.last = std::abs(tracks.sensed[joint][i] - tracks.asked[joint][i - 1]);
    found.worst = std::max(found.worst, found.last);
    found.rms += found.last * found.last / static_cast<double>(cycles - 1);
  }
  found.rms = std::sqrt(found.rms);
  return found;
}

// A joint that stands still is a line, not its encoder's noise from edge to edge.
void widen(Panel& panel, const std::vector<double>& asked, const std::vector<double>& sensed) {
  constexpr double kNarrowest = 4;  // [deg]
  const auto [a, b] = std::minmax_element(asked.begin(), asked.end());
  const auto [c, d] = std::minmax_element(sensed.begin(), sensed.end());
  const double low = std::min(*a, *c), high = std::max(*b, *d);
  if (high - low >= kNarrowest) return;
  const double middle = std::round((low + high) / 2);
  panel.y_range = {middle - kNarrowest / 2 - 1, middle + kNarrowest / 2 + 1};
}

void addFaults(const RobotModel& model, const Played& played, Report& report) {
  for (const MotionFault::Kind kind : kKinds) {
    const auto count = std::count_if(played.faults.begin(), played.faults.end(),
                                     [kind](const MotionFault& f) { return f.kind == kind; });
    report.figures.push_back({std::string(nameOf(kind)) + "_faults", static_cast<double>(count)});
  }
  std::vector<Row> rows;
  for (const MotionFault& fault : played.faults) {
    rows.push_back(rowOf(model, fault));
    report.remarks.push_back(fixed(fault.time, 2) + " to " + fixed(fault.until, 2) + " s, frame " +
                             fixed(fault.frame, 1) + ", " + nameOf(fault.kind) + ": " + fault.text);
  }
  report.figures.push_back({"faults", std::move(rows)});
}

void addTracking(const RobotModel& model, const motion::Timeline& timeline, const Played& played,
                 Report& report) {
  std::vector<Row> rows;
  TextTable table;
  table.title = "How the joints followed";
  table.head = {"joint", "rms [deg]", "worst [deg]", "at the end [deg]"};
  for (const motion::Curve& curve : timeline.curves) {
    const Actuator& actuator = model.actuators[index(curve.joint)];
    if (actuator.coordinates.empty()) continue;
    const Tracking t = trackingOf(played.tracks, index(curve.joint));
    rows.push_back({{"joint", actuator.name},
                    {"rms_deg", t.rms / kDegree},
                    {"worst_deg", t.worst / kDegree},
                    {"last_deg", t.last / kDegree}});
    table.lines.push_back({actuator.name, fixed(t.rms / kDegree, 2), fixed(t.worst / kDegree, 2),
                           fixed(t.last / kDegree, 2)});
  }
  report.figures.push_back({"tracking", std::move(rows)});
  report.tables.push_back(std::move(table));
}

std::string summaryOf(const std::string& name, const Played& played) {
  std::string text = name + ": played in " + fixed(played.duration, 2) + " s";
  if (!played.done) text = name + ": not played to its end";
  if (played.fell) text += "; the robot fell";
  text += played.upright ? "; it is upright at the end" : "; it is not upright at the end";
  const auto count = played.faults.size();
  if (std::any_of(played.faults.begin(), played.faults.end(),
                  [](const MotionFault& f) { return f.kind == MotionFault::Kind::File; })) {
    text += "; its file is broken and this is the rest of it";
  }
  return text + "; " + (count == 0 ? "no" : std::to_string(count)) + " fault" +
         (count == 1 ? "." : "s.");
}

}  // namespace

Report reportPlay(const std::string& name, const motion::Timeline& timeline,
                  const PlaySettings& settings, const Played& played) {
  Report report;
  report.command = "play";
  report.robot = settings.model->name;
  report.seed = settings.seed;
  report.step_s = toSeconds(settings.step);
  report.hash = played.hash;
  report.draw = played.draw;
  report.figures = {{"length_s", timeline.length},
                    {"duration_s", played.duration},
                    {"done", played.done ? 1.0 : 0.0},
                    {"fell", played.fell ? 1.0 : 0.0},
                    {"upright", played.upright ? 1.0 : 0.0},
                    {"joints", static_cast<double>(timeline.curves.size())}};
  addFaults(*settings.model, played, report);
  addTracking(*settings.model, timeline, played, report);
  std::vector<Row> rows;
  for (const std::string& warning : timeline.warnings) {
    rows.push_back({{"text", warning}});
    report.remarks.push_back("left out: " + warning);
  }
  report.figures.push_back({"left_out", std::move(rows)});
  report.remarks.push_back(summaryOf(name, played));
  return report;
}

Picture drawTracking(const RobotModel& model, const Played& played, const std::string& chain) {
  Picture picture;
  picture.title = chain;
  picture.columns = 2;
  const PlayTracks& tracks = played.tracks;
  const std::size_t stride = tracks.time.size() / kMostPoints + 1;
  const auto group = model.groups.find(chain);
  std::set<std::size_t> done;
  if (group == model.groups.end()) return picture;
  for (const std::string& name : group->second) {
    const auto joint = model.findJoint(name);
    if (!joint || model.actuators[index(*joint)].coordinates.empty()) continue;
    if (tracks.time.empty() || !done.insert(index(*joint)).second) continue;
    Panel panel = makePanel(name, "time [s]", "angle [deg]");
    Series asked{"asked", {}, {}, Stroke::Line, Ink::Orange};
    Series sensed{"sensed", {}, {}, Stroke::Line, Ink::Blue};
    for (std::size_t i = 0; i < tracks.time.size(); i += stride) {
      asked.x.push_back(tracks.time[i]);
      asked.y.push_back(tracks.asked[index(*joint)][i] / kDegree);
      sensed.x.push_back(tracks.time[i]);
      sensed.y.push_back(tracks.sensed[index(*joint)][i] / kDegree);
    }
    panel.key = "tmargin right horizontal";  // above the plot, where it hides no curve
    widen(panel, asked.y, sensed.y);
    panel.series = {std::move(asked), std::move(sensed)};
    picture.panels.push_back(std::move(panel));
  }
  const int rows = (static_cast<int>(picture.panels.size()) + 1) / 2;
  picture.height = 60 + 270 * rows;
  return picture;
}

}  // namespace nao::validation

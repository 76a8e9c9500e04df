#include "ci/page.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "ci/junit.h"
#include "ci/sentence.h"
#include "core/check.h"
#include "validation/html.h"
#include "validation/play_report.h"
#include "validation/plot.h"

namespace nao::ci {
namespace {

using validation::escapeHtml;
using ModelOf = std::function<std::shared_ptr<const RobotModel>(const std::string&)>;

std::string titleOf(const Result& result) {
  return result.scenario + ", seed " + std::to_string(result.seed);
}

std::string tableOf(const std::vector<JobResult>& results) {
  validation::TextTable table;
  table.title = "Runs";
  table.head = {"", "scenario", "seed", "what it is about", "simulated [s]", "wall [s]"};
  for (const JobResult& job : results) {
    const Result& result = job.result;
    table.lines.push_back({result.passed() ? "passed" : "FAILED", result.scenario,
                           std::to_string(result.seed), result.about, shown(result.time),
                           shown(job.wall)});
  }
  return validation::toHtml(table);
}

std::string verdictsOf(const Result& result) {
  if (result.verdicts.empty()) return {};
  validation::TextTable table;
  table.title = "Expectations";
  table.head = {"", "line", "expected", "seen", "at [s]"};
  for (const Verdict& verdict : result.verdicts) {
    table.lines.push_back({verdict.passed ? "kept" : "FAILED",
                           verdict.line > 0 ? std::to_string(verdict.line) : "", verdict.expected,
                           verdict.seen, shown(toSeconds(verdict.at))});
  }
  return validation::toHtml(table);
}

std::string filmstripOf(const Course& course) {
  if (course.stills.empty()) return {};
  std::string out = "<h2>The last seconds</h2>\n<div class=\"stills\">\n";
  for (const Course::Still& still : course.stills) {
    out += "<figure><img alt=\"\" src=\"data:image/png;base64," + still.png + "\"><figcaption>" +
           shown(still.time) + " s</figcaption></figure>\n";
  }
  return out + "</div>\n";
}

// As wide as what was, and half a metre at least: who stands still is a point.
std::array<double, 2> rangeOf(const std::vector<validation::Series>& series,
                              std::vector<double> validation::Series::*axis) {
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  for (const validation::Series& one : series) {
    for (const double value : one.*axis) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  const double room = std::max(0.05 * (high - low), 0.25 - 0.5 * (high - low));
  return {low - room, high + room};
}

// A picture, or why there is none.
std::string draw(const validation::Picture& picture) {
  try {
    return validation::drawSvg(picture);
  } catch (const InputError& error) {
    return "<p>" + escapeHtml(error.what()) + "</p>\n";
  }
}

// Where robots and balls were on the floor, from above.
std::string tracksOf(const Course& course) {
  validation::Panel panel = validation::makePanel("Tracks on the floor", "x [m]", "y [m]");
  const validation::Ink inks[] = {validation::Ink::Blue, validation::Ink::Vermilion,
                                  validation::Ink::Green, validation::Ink::Purple};
  const auto add = [&](const std::string& name, const auto& thing, validation::Stroke stroke) {
    const auto ink = inks[panel.series.size() % std::size(inks)];
    panel.series.push_back({name, thing.x, thing.y, stroke, ink});
  };
  for (const auto& robot : course.robots) add(robot.name, robot, validation::Stroke::Line);
  for (const auto& ball : course.balls) add(ball.name, ball, validation::Stroke::Points);
  panel.key = "outside";
  panel.x_range = rangeOf(panel.series, &validation::Series::x);
  panel.y_range = rangeOf(panel.series, &validation::Series::y);
  return draw({"", {panel}, 1, 700, 420});
}

// As validation plots a motion that was played.
std::string jointsOf(const Course& course, const Course::Robot& robot, const ModelOf& model_of) {
  const auto model = model_of(robot.model);
  validation::Played played;
  played.tracks.time = course.time;
  played.tracks.asked = robot.asked;
  played.tracks.sensed = robot.sensed;
  std::string out = "<h2>" + escapeHtml(robot.name) + "'s joints</h2>\n";
  const auto chains = model->groups.find("Chains");
  if (chains == model->groups.end()) return out;
  for (const std::string& chain : chains->second) {
    const validation::Picture picture = validation::drawTracking(*model, played, chain);
    if (!picture.panels.empty()) out += draw(picture);
  }
  return out;
}

std::string sectionOf(const JobResult& job, const ModelOf& model_of) {
  const Result& result = job.result;
  std::string out = "<hr><h1>" + escapeHtml(titleOf(result)) + "</h1>\n<p>" +
                    escapeHtml(result.about) + "</p>\n<ul>";
  for (const std::string& failure : failuresOf(result)) {
    out += "<li class=\"verdict\">" + escapeHtml(failure) + "</li>\n";
  }
  out += "</ul>\n<p>Again: <code>" + escapeHtml(replayCommand(result)) + "</code></p>\n";
  if (!job.recording.empty()) {
    out +=
        "<p>Its recording: <code>usarnaoqi replay " + escapeHtml(job.recording) + "</code></p>\n";
  }
  out += verdictsOf(result) + filmstripOf(result.course);
  if (!result.course.time.empty()) {
    out += tracksOf(result.course);
    for (const auto& robot : result.course.robots) out += jointsOf(result.course, robot, model_of);
  }
  if (!job.output.empty()) {
    out += "<h2>What was printed</h2>\n<pre>" + escapeHtml(job.output) + "</pre>\n";
  }
  return out;
}

}  // namespace

std::string toPage(const std::vector<JobResult>& results, const ModelOf& model_of) {
  std::size_t failed = 0;
  for (const JobResult& job : results) failed += job.result.passed() ? 0 : 1;
  const std::string title = failed == 0 ? "All " + std::to_string(results.size()) + " runs passed"
                                        : std::to_string(failed) + " of " +
                                              std::to_string(results.size()) + " runs failed";
  std::string page = "<h1>" + title + "</h1>\n" + tableOf(results);
  for (const JobResult& job : results) {
    if (!job.result.passed()) page += sectionOf(job, model_of);
  }
  return validation::htmlPage(title, page);
}

}  // namespace nao::ci

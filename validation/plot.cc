#include "validation/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/check.h"
#include "core/files.h"

namespace nao::validation {
namespace {

namespace fs = std::filesystem;

// gnuplot's single quotes know one escape: the quote itself, doubled.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
  return out + "'";
}

const char* colorOf(Ink ink) {
  switch (ink) {
    case Ink::Blue:
      return "#0072b2";
    case Ink::Orange:
      return "#e69f00";
    case Ink::Green:
      return "#009e73";
    case Ink::Vermilion:
      return "#d55e00";
    case Ink::Purple:
      return "#cc79a7";
    case Ink::Sky:
      return "#56b4e9";
    case Ink::Black:
      return "#222222";
    case Ink::Thesis:
      return "#8a8a8a";
  }
  return "#000000";
}

std::string styleOf(const Series& series) {
  const std::string color = std::string(" lc rgb '") + colorOf(series.ink) + "'";
  const std::string point =
      series.ink == Ink::Thesis ? " pt 6 ps 1.1 lw 1.8" : " pt 7 ps 0.7 lw 1.8";
  switch (series.stroke) {
    case Stroke::Line:
      return "lines lw 2" + color;
    case Stroke::Dashed:
      return "lines lw 2 dt (8,5)" + color;
    case Stroke::Points:
      return "points" + point + color;
    case Stroke::LinePoints:
      return "linespoints" + point + color;
    case Stroke::Steps:
      return "steps lw 1.6" + color;
    case Stroke::Bars:
      return "boxes fs solid 0.85 noborder" + color;
  }
  return "lines";
}

class Script {
 public:
  Script(const Picture& picture, const std::string& file) {
    out_.precision(12);
    const bool svg = fs::path(file).extension() == ".svg";
    out_ << "set encoding utf8\nset terminal " << (svg ? "svg font 'sans-serif,13'" : "pngcairo")
         << " size " << picture.width << "," << picture.height << " background rgb 'white'"
         << (svg ? "" : " font 'DejaVu Sans,11'") << " noenhanced\n"
         << "set output " << quoted(file) << "\n";
    const auto panels = static_cast<int>(picture.panels.size());
    const int rows = (panels + picture.columns - 1) / picture.columns;
    out_ << "set multiplot layout " << rows << "," << picture.columns << " title "
         << quoted(picture.title) << " font ',15' offset 0,-0.2\n";
    for (const Panel& panel : picture.panels) add(panel);
    out_ << "unset multiplot\n";
  }
  std::string text() const { return out_.str(); }

 private:
  void add(const Panel& panel) {
    const std::size_t first = blocks_;
    for (const Series& series : panel.series) addData(series);
    out_ << "reset\nset grid lc rgb '#dddddd' lt 1 lw 0.7\nset border 3 lc rgb '#555555'\n"
         << "set tics nomirror out scale 0.6\nset title " << quoted(panel.title) << "\nset xlabel "
         << quoted(panel.x_label) << "\nset ylabel " << quoted(panel.y_label) << "\n"
         << "set boxwidth 0.7\nset offsets 0, 0, graph 0.06, graph 0.04\n"
         << (panel.key == "outside" ? std::string("set key outside right center Left reverse")
                                    : "set key " + panel.key + " opaque Left reverse")
         << " samplen 2 spacing 1.2\n";
    if (panel.log_x) out_ << "set logscale x\n";
    if (panel.log_y) out_ << "set logscale y\nset format y '%g'\n";
    if (!panel.categories.empty()) out_ << "set yrange [0:*]\nset rmargin 4\n";
    if (panel.y_range[0] != panel.y_range[1]) {
      out_ << "set yrange [" << panel.y_range[0] << ":" << panel.y_range[1] << "]\n";
    }
    addXAxis(panel);
    const char* separator = "plot ";
    for (std::size_t i = 0; i < panel.series.size(); ++i, separator = ", ") {
      const Series& series = panel.series[i];
      out_ << separator << "$d" << first + i << " with " << styleOf(series)
           << (series.label.empty() ? " notitle" : " title " + quoted(series.label));
    }
    out_ << "\n";
  }

  // As wide as the data, with a little room at both ends.
  void addXAxis(const Panel& panel) {
    double low = panel.series.front().x.front();
    double high = low;
    for (const Series& series : panel.series) {
      low = std::min(low, *std::min_element(series.x.begin(), series.x.end()));
      high = std::max(high, *std::max_element(series.x.begin(), series.x.end()));
    }
    const bool bars = !panel.categories.empty();
    const double least = 1e-4 * std::max({std::abs(low), std::abs(high), 1e-3});  // no range at all
    const double room = bars          ? 0.6
                        : panel.log_x ? 0.03 * std::log(high / low)
                                      : std::max(0.015 * (high - low), least);
    if (panel.x_range[0] != panel.x_range[1]) {
      out_ << "set xrange [" << panel.x_range[0] << ":" << panel.x_range[1] << "]\n";
    } else if (panel.log_x) {
      out_ << "set xrange [" << low * std::exp(-room) << ":" << high * std::exp(room) << "]\n";
    } else {
      out_ << "set xrange [" << low - room << ":" << high + room << "]\n";
    }
    addXTicks(panel);
  }

  void addXTicks(const Panel& panel) {
    const bool bars = !panel.categories.empty();
    const std::size_t count = bars ? panel.categories.size() : panel.x_ticks.size();
    if (count == 0) return;
    out_ << "set xtics " << (bars ? "rotate by 30 right (" : "(");
    for (std::size_t i = 0; i < count; ++i) {
      out_ << (i == 0 ? "" : ", ");
      bars ? out_ << quoted(panel.categories[i]) << " " << i : out_ << panel.x_ticks[i];
    }
    out_ << ")\n";
  }

  void addData(const Series& series) {
    NAO_CHECK(series.x.size() == series.y.size() && !series.x.empty());
    out_ << "$d" << blocks_++ << " << EOD\n";
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      out_ << series.x[i] << " ";
      std::isfinite(series.y[i]) ? out_ << series.y[i] << "\n" : out_ << "NaN\n";
    }
    out_ << "EOD\n";
  }

  std::ostringstream out_;
  std::size_t blocks_ = 0;
};

// A folder of its own for the script, gone at the end.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (fs::temp_directory_path() / "usarnaoqi-plot-XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw InputError("--plot: can not write to " + pattern);
    path_ = pattern;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

Panel makePanel(std::string title, std::string x_label, std::string y_label) {
  Panel panel;
  panel.title = std::move(title);
  panel.x_label = std::move(x_label);
  panel.y_label = std::move(y_label);
  return panel;
}

void requireGnuplot() {
  const char* variable = std::getenv("PATH");
  std::istringstream path(variable ? variable : "");
  for (std::string folder; std::getline(path, folder, ':');) {
    if (fs::exists(fs::path(folder) / "gnuplot")) return;
  }
  throw InputError(
      "pictures are drawn by gnuplot, which is not installed; "
      "scripts/setup installs it (Debian package gnuplot-nox)");
}

void requirePlot(const std::string& file) {
  const std::string ending = fs::path(file).extension().string();
  if (ending != ".svg" && ending != ".png") {
    throw InputError("--plot " + file + ": expected a file name ending in .svg or .png");
  }
  requireGnuplot();
  if (!std::ofstream(file, std::ios::app)) {
    throw InputError("--plot " + file + ": the file can not be written");
  }
}

void draw(const Picture& picture, const std::string& file) {
  requirePlot(file);
  const ScratchFolder scratch;
  const fs::path script = scratch.path() / "plot.gp";
  writeFile("", script.string(), Script(picture, file).text());
  const std::string command = "LC_ALL=C.UTF-8 gnuplot '" + script.string() + "' >&2";
  if (std::system(command.c_str()) != 0) {
    throw InputError("--plot " + file + ": gnuplot could not draw it, see its message above");
  }
}

std::string drawSvg(const Picture& picture) {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "picture.svg";
  draw(picture, file.string());
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::size_t begin = text.find("<svg");  // a page has a head of its own
  return begin == std::string::npos ? std::string() : text.substr(begin);
}

}  // namespace nao::validation

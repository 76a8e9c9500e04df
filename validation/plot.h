#pragma once

#include <array>
#include <string>
#include <vector>

namespace nao::validation {

/// How a curve is drawn.
enum class Stroke { Line, Dashed, Points, LinePoints, Steps, Bars };

/// Colours that people who confuse red and green still tell apart (Okabe and Ito, 2008). What the
/// thesis measured is always grey.
enum class Ink { Blue, Orange, Green, Vermilion, Purple, Sky, Black, Thesis };

struct Series {
  std::string label;  // in the key; empty: not in the key
  std::vector<double> x;
  std::vector<double> y;
  Stroke stroke = Stroke::Line;
  Ink ink = Ink::Blue;
};

/// One pair of axes. Labels carry the unit: "time [s]".
struct Panel {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Series> series;
  bool log_x = false;
  bool log_y = false;
  std::array<double, 2> x_range{0, 0};  // equal: as wide as the data
  std::array<double, 2> y_range{0, 0};  // equal: as the data ask
  std::vector<double> x_ticks;          // empty: as the data ask
  std::string key = "top right";        // where the labels stand; "outside": beside the axes
  std::vector<std::string> categories;  // names below x = 0, 1, 2 ... instead of numbers
};

/// A panel still without curves.
Panel makePanel(std::string title, std::string x_label, std::string y_label);

struct Picture {
  std::string title;
  std::vector<Panel> panels;
  int columns = 1;
  int width = 900;   // [px]
  int height = 560;  // [px]
};

/// Told before the work: @throws InputError where there is no gnuplot.
void requireGnuplot();

/// Whether draw() could write this file, told before the work that the picture shows.
/// @throws InputError for another ending than .svg and .png, without gnuplot, or when the file can
/// not be written.
void requirePlot(const std::string& file);

/// Draws with gnuplot. @throws InputError as requirePlot().
void draw(const Picture& picture, const std::string& file);

/// The same as the text of an SVG, to stand in a page.
std::string drawSvg(const Picture& picture);

}  // namespace nao::validation

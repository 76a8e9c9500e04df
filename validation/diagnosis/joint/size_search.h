#pragma once

#include <map>
#include <vector>

#include "validation/diagnosis/joint/stage.h"
#include "validation/diagnosis/maths/chords.h"

namespace nao::validation {

/// The size of one cause beside a stage's model, by ensembles of look_runs; further numbers of the
/// cause stay as they are.
class SizeSearch {
 public:
  /// What simulates: coarse runs cost ten times as much as rough ones, as the neighbours' motion is
  /// calculated for each size.
  enum class Runs { Rough, Coarse };

  struct Point {
    std::vector<double> x;
    double gain = 0, scale = 0;  // [nats]; of x, that would be best if the cause were linear
  };

  /// All of it must outlive the search.
  SizeSearch(Ensemble& ensemble, const Stage& stage, const std::vector<Cause>& causes,
             std::size_t cause, const Effort& effort, Runs runs);

  /// The best size that is found from these numbers, as the kind of cause asks for.
  Point from(const std::vector<double>& x) const;
  /// The best size close to these numbers.
  Point near(const std::vector<double>& x) const;
  /// From these, the best with what shapes the cause half and a quarter of its starts' way further
  /// or less, two shapes at once too; the size goes along. Fits of all at once creep along where
  /// one makes up for the other.
  Point reshaped(const std::vector<double>& x) const;

 private:
  Point at(const std::vector<double>& x) const;
  Point reshaped(const Point& best, const std::vector<double>& from,
                 const std::map<std::size_t, double>& moves) const;
  Point scanned(Point best) const;
  Point reached(const Point& from) const;
  Point beating(Point best) const;
  Point alongBend(Point best) const;
  Point shortened(Point best) const;
  Point followed(Point best) const;
  Point partOfTheWay(const Point& from, double factor) const;
  Point withSize(const Point& from, double size) const;
  Point scaled(const Point& from, double factor) const;
  Response responseTo(double size) const;
  Halves changeAt(const std::vector<double>& x) const;
  const FreeNumber& size() const { return causes_[cause_].free[0]; }

  Ensemble& ensemble_;
  const Stage& stage_;
  const std::vector<Cause>& causes_;
  std::size_t cause_;
  const Effort& effort_;
  Runs runs_;
  Eigen::VectorXd residual_;
};

}  // namespace nao::validation

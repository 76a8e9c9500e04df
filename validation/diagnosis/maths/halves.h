#pragma once

#include <Eigen/Core>

namespace nao::validation {

/// A mean of runs, or what a cause changes of it, by two halves that share no random number.
/// Friction and play make runs part ways at the slightest change: an ensemble's change then holds
/// chance of hundreds of squared SDs. What both halves show is none.
struct Halves {
  Eigen::VectorXd first, second;

  Eigen::VectorXd mean() const { return (first + second) / 2; }
  Halves operator-(const Halves& other) const {
    return {first - other.first, second - other.second};
  }
  Halves operator*(double factor) const { return {first * factor, second * factor}; }
  /// Both halves through a linear `map` of vectors.
  template <class Map>
  Halves through(Map map) const {
    return {map(first), map(second)};
  }
  /// The cosine of the angle between the halves: 1 without chance, about 0 for nothing else.
  double coherence() const;
};

/// Half the squares of a residual that a change explains [nats], chance left out; both whitened.
/// The change's squares count as a part of themselves at least, so that no scale divides by nearly
/// nothing.
class Explained {
 public:
  Explained(const Halves& change, const Eigen::VectorXd& residual);

  double square() const { return square_; }  // of the change
  double along() const { return along_; }    // change times residual
  /// By this many times the change.
  double gain(double scale = 1) const { return scale * along_ - scale * scale * square_ / 2; }
  /// At which that is most.
  double bestScale() const { return square_ > 0 ? along_ / square_ : 0; }

 private:
  double along_, square_;
};

}  // namespace nao::validation

#pragma once

#include <functional>
#include <map>
#include <vector>

namespace nao::validation {

/// One number for several joints; remembers what every number gains.
class SharedFit {
 public:
  /// `gains_at`: what each joint gains with a number [nats].
  SharedFit(std::function<std::vector<double>(double)> gains_at, double lower, double upper);

  /// Brackets the best by three numbers, from `centre` on, and narrows the bracket by parabolas.
  void narrow(double centre);
  void tryAll(const std::vector<double>& numbers);
  /// Goes to either side of the best by `width`, then by half of that and so on.
  void halve(double width);

  double best() const;
  /// Of each joint, at the best.
  const std::vector<double>& gains() const { return tried_.at(best()); }
  double gain() const;  // of all

 private:
  double gainAt(double x);

  std::function<std::vector<double>(double)> gains_at_;
  double lower_, upper_;
  std::map<double, std::vector<double>> tried_;  // by number: of each joint
};

}  // namespace nao::validation

#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/robot_model.h"
#include "validation/log/robot_log.h"

namespace nao::validation {

/// The random part of a joint's runs, as the repeats of a set show it.
struct JointNoise {
  double torque_sd = 0;    // [N m] of the Ornstein-Uhlenbeck torque
  double torque_time = 0;  // [s] its correlation time
  double start_sd = 0;     // [s] of the moment a run begins, drawn once per run
  double quantum = 0;      // [rad] of the encoder
  double jitter = 0;       // [rad] by which half of the readings are off, to either side
};

/// One motion of one joint as the diagnosis sees it: every repeat on one grid of times.
struct JointMotion {
  std::string motion;
  Split split = Split::Fit;
  double dt = 0;  // [s] between rows
  /// A row per time, a column per signal: the angle [rad], then the current [A] where it is known.
  std::vector<Eigen::MatrixXd> repeats;
};

/// A joint that is led beside its own course, row by row.
struct LedRun {
  Eigen::VectorXd torque;  // [N m] that led it: what the model lacks
  Eigen::VectorXd error;   // [rad] its servo's, command less angle; 0 where it gives all it has
  Eigen::VectorXd angle;   // [rad] of its own course, told or not
};

/// Predicts one joint's signals under any list of causes: the model of the joint level. The other
/// joints move as they were measured. One object may be asked by several threads at once.
class JointSimulator {
 public:
  virtual ~JointSimulator() = default;

  virtual std::string joint() const = 0;
  virtual const std::vector<JointMotion>& measured() const = 0;

  /// Where causes of this joint alone act, for EffectSetting::joints.
  virtual std::vector<Joint> place() const { return {}; }

  /// Joints whose links this one carries.
  virtual std::vector<Joint> carried() const { return {}; }

  /// The inertia that the links it turns have of their own, as a part of the rotor's: to the joint
  /// a rotor that is heavier.
  virtual double linkInertia() const { return 0; }

  /// One run of measured()[motion] with the model's own effects and these, on the grid of its
  /// repeats; the same `stream` draws the same random numbers whatever the causes. Noise of zero:
  /// the noise-free run.
  /// A cause is a deviation from the model: what the model's own effect of that name already does
  /// adds to it (merge_effects.h).
  virtual Eigen::MatrixXd run(const std::vector<EffectSetting>& causes, std::size_t motion,
                              std::uint64_t stream, const JointNoise& noise) const = 0;

  /// What the noise-free joint lacks to move `off` [rad] beside the course that it takes by itself,
  /// on the grid of measured()[motion], where its encoder reads `misread` [rad] more. Empty: the
  /// simulator can not tell.
  virtual LedRun led(const std::vector<EffectSetting>& /*causes*/, std::size_t /*motion*/,
                     const Eigen::VectorXd& /*off*/, const Eigen::VectorXd& /*misread*/) const {
    return {};
  }

  /// The same joint in longer steps, cheaper: for what causes change, where the error of a step
  /// falls out. Streams of even and of odd numbers share no chance; of four in a row the last two
  /// mirror the first two (run_noise.h).
  virtual const JointSimulator& coarse() const { return *this; }

  /// As coarse(), but neighbours do to the joint what they would without causes, as long as these
  /// do not act on masses or between motor and link: for looks at what may be worth a fit.
  virtual const JointSimulator& rough() const { return coarse(); }

  /// The same joint without what run() approximates, ten times as slow: for what is compared with
  /// the measurement.
  virtual const JointSimulator& exact() const { return *this; }

  /// Whether another joint limits this one in the model: else a limit that moves with another joint
  /// is not tried here, as it is a stop like any other to a joint alone.
  virtual bool isCoupled() const { return true; }

  /// Lines [rad/rad, rad] of a stop at the joint's upper or lower end that moves with another
  /// joint, each of which just touches what was measured in motions to fit; none: not known.
  virtual std::vector<std::vector<double>> touchedLines(bool /*upper*/) const { return {}; }

  /// The joint's own mechanical stops in the model [rad]: lowest and highest angle.
  virtual std::pair<double, double> range() const {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    return {-kNone, kNone};
  }

  /// How far from neutral the model's own effect of that name already is at this joint.
  virtual double present(const std::string& /*effect*/, const std::string& /*parameter*/) const {
    return 0;
  }
};

}  // namespace nao::validation

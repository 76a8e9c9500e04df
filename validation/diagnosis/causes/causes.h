#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "sim/effects/catalogue.h"
#include "validation/diagnosis/ensemble/joint_simulator.h"
#include "validation/diagnosis/maths/number_form.h"

namespace nao::validation {

/// Whether a cause is one joint's own, or first tried as one number for all joints.
enum class Scope { Joint, Robot };

/// A number that is fitted. 0 is always the nominal model.
struct FreeNumber {
  std::string parameter;       // of the effect
  std::vector<double> starts;  // where fits begin; the first is the first look
  Form form = Form::Offset;
  // Filled in by the catalogue and the joint:
  std::string unit;
  double neutral = 0;
  double lower = 0, upper = 0;
  double smallest = 0;  // size of interest
  bool stays = false;   // where it began: no slope tells of it
};

/// A candidate of the diagnosis: an effect, and which of its parameters are free.
struct Cause {
  std::string id;  // of the effect; "effect.parameter" where an effect has several causes
  std::string effect;
  std::vector<FreeNumber> free;  // the first is its size; the others shape it
  Scope scope = Scope::Joint;
  /// Of Scope::Robot, and cannot be one joint's own: there is one gravity.
  bool one_for_all = false;
  std::vector<Joint> joints{};  // it acts on; filled in by boundedAt(); empty: all
  /// The response is nearly proportional to the size, so that one look serves both signs.
  bool linear = true;
  /// But a gross size answers otherwise: each of the starts is looked at.
  bool gross = false;
  /// Sizes to look at one by one, where the response to one says little of the next: what every
  /// run's own late start takes off a delay leaves its bends alone. Empty: `starts` are enough.
  std::vector<double> scan{};
  /// A clock that beats with that of the log: sizes are told apart as beatingSizes() does.
  bool beats = false;
  bool coupled = false;  // needs a joint that another limits
  /// Where fits begin, all numbers at once, where one says where the others may be. Empty: all
  /// combinations of their `starts`.
  std::vector<std::vector<double>> together{};
  /// Causes, by id, whose number of the same size to either side does nearly the same to one joint:
  /// where this one fits, they are tried there too, however far that is from their own starts.
  std::vector<std::string> twins{};
  /// Undeclared spread of this number between equal robots [its unit]: what a robot's maker calls
  /// the same. Less than the smallest size of interest; 0: none is expected.
  double spread = 0;
  /// Its numbers are a torque that ripples, periods per turn and a phase. A large one is no
  /// multiple of a small one: where it acts as `Signature::ripple` says is where fits begin, too.
  bool ripples = false;
  /// Is tried only where nothing was found, and by no looks: part of a period of a ripple, which
  /// beside other laws of the angle would be any of them.
  bool alone = false;
  /// The number is where a joint is stopped: encoders' zeros move it, and how much wrong it is
  /// tells nothing of how far around it a slope holds.
  bool stop = false;
  /// The size is a part of which all is a law as good as any: a fit that ends there did not flee.
  bool whole = false;
  /// Of the number where it is x already: a part of a nominal value is one of what the robot has,
  /// stops are spread as zeros are.
  double spreadAt(double x) const;
  /// One SD of what the number is off by because no robot keeps to a catalogue's law to the last
  /// per cent, and what equal robots differ by acts through what is wrong as well: a part of x.
  /// Nothing of a stop or a rate where commands end, which are read off.
  double lawErrorAt(double x) const;
  /// The size is a rate: of interest is what comes to this on the mean of the longest run; 0: it is
  /// none.
  double smallest_mean = 0;
  bool spread_beyond = false;  // so do the joints that this one carries, and it feels them
  bool of_link = false;        // of what hangs on the joint: all joints that carry the link feel it
  /// Of laws that stand in for each other, such as "friction": what one of them leaves over of a
  /// robot's own law another explains best. Empty: of none.
  std::string family{};
  std::string sentence;  // for the report, "{joint}" and "{value}" filled in
  std::string separate;  // the experiment that tells it from its rivals

  std::string fill(const std::string& joint, const std::string& value) const;
};

/// The causes that a single joint's angle (and current) can show, in the order of the report.
const std::vector<Cause>& jointCauses();
/// jointCauses(), and the forms of load friction that only several gains and loads can tell apart.
const std::vector<Cause>& benchCauses();

/// `cause` at this joint, with units and bounds of the catalogue's effect, as far as the joint's
/// model allows: a play can shrink by no more than there is.
Cause boundedAt(const Cause& cause, const JointSimulator& joint,
                const sim::EffectCatalogue& catalogue);

/// And of each cause that ripples, less than a period.
std::vector<Cause> withPartsOfRipples(std::vector<Cause> causes);

/// Of a look at a rough cause, how many times its size a guess may reach: it says nothing beyond.
constexpr double kFurthest = 1.5;

/// Where fits of a cause begin, within its bounds: `together`, else all combinations of its
/// numbers' starts, sizes first.
std::vector<std::vector<double>> startsOf(const Cause& cause);

/// The setting that stands for these numbers, one per `cause.free`, on the cause's joints.
EffectSetting settingOf(const Cause& cause, const std::vector<double>& numbers);

/// The parameter's value that a number stands for, as a person reads it.
double shownValue(const FreeNumber& number, double x);

}  // namespace nao::validation

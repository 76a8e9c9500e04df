#pragma once

#include <string>
#include <utility>
#include <vector>

#include "naoqi_api/value.h"

namespace nao::wire {

/// One actuator frame of LoLA: a MessagePack map of any of these keys in any order, numbers of any
/// width.
///
///   Position 25 [rad, hands 0..1], Stiffness 25 [0..1, below 0: motor off]
///   LEar 10, REar 10, LEye 24, REye 24, Chest 3, Skull 12, LFoot 3, RFoot 3 [0..1]
///   Sonar 2 [bool]
struct LolaActuators {
  std::vector<double> position;   // in the order of kLolaJoints; empty: not in the frame
  std::vector<double> stiffness;  // likewise
  std::vector<std::pair<std::string, double>> leds;  // NaoQi's device name, 0 to 1
  std::vector<std::string> unknown;                  // keys that LoLA has not
};

/// @throws rpc::CallError with one sentence: another kind of value, list or number, or no number.
LolaActuators readLolaActuators(const rpc::Value& frame);

}  // namespace nao::wire

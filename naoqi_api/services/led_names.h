#pragma once

#include <string>
#include <vector>

namespace nao::services {

/// Which of a robot's lights (core/leds.h) ALLeds, or the DCM, means by a name: a group such as
/// FaceLeds or RightFaceLedsRed, a sector such as FaceLed3 or LeftEarLed10, or a device name, with
/// or without what stands before and after it. Empty: none.
std::vector<std::size_t> findLedsNamed(const std::vector<std::string>& lights,
                                       const std::string& name);

/// The names of ALLeds' groups.
std::vector<std::string> ledGroupNames();

}  // namespace nao::services

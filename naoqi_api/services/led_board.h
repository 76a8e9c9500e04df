#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/leds.h"
#include "naoqi_api/pending.h"
#include "naoqi_api/robot_link.h"
#include "naoqi_api/tasks.h"

namespace nao::services {

/// A colour: red, green and blue, 0 to 1.
using Rgb = std::array<float, 3>;

/// The lights of one robot and the fades they are in, in simulated time. A light follows the fade
/// that was asked for last. Lives in a shared_ptr. I/O thread.
class LedBoard : public std::enable_shared_from_this<LedBoard> {
 public:
  LedBoard(RobotLink& link, rpc::CallLater later);

  /// The lights' names, as Face/Led/Red/Left/0Deg; numbers below are places in it.
  const std::vector<std::string>& names() const { return names_; }

  /// The lights of a group, of a part of the body or of one name: ALLeds' names, those of groups
  /// that clients made, and device names. @throws CallError if there are none.
  std::vector<std::size_t> lightsOf(const std::string& name) const;

  /// ALLeds' own groups and those that clients made.
  std::vector<std::string> groups() const;
  void makeGroup(const std::string& name, const std::vector<std::string>& lights);

  /// 0 to 1, as the robot shows it.
  float brightness(std::size_t light) const;

  /// All of these to one brightness; ends after `duration` [s].
  rpc::Pending<void> fade(const std::vector<std::size_t>& lights, float to, double duration);
  /// Each of these to its part of a colour; lights of no colour take the brightest part.
  rpc::Pending<void> fade(const std::vector<std::size_t>& lights, const Rgb& to, double duration);

  /// Ends when `seconds` have passed.
  rpc::Pending<void> pass(double seconds);

 private:
  struct Target {
    std::size_t light = 0;
    float from = 0;
    float to = 0;
  };
  struct Fade {
    std::uint64_t id = 0;
    std::vector<Target> targets;
    SimTime begin{};
    double duration = 0;  // [s]
    rpc::Pending<void> done;
  };

  rpc::Pending<void> begin(std::vector<Target> targets, double duration);
  void tick();
  void show(const Fade& fade, double part);
  void light(std::size_t light, float brightness);

  RobotLink& link_;
  rpc::CallLater later_;
  std::vector<std::string> names_;
  std::map<std::string, std::vector<std::size_t>> made_;  // by clients
  std::vector<Fade> fades_;
  std::vector<float> asked_;          // what was last asked for
  std::vector<std::uint64_t> owner_;  // the fade that a light follows
  std::uint64_t last_fade_ = 0;
  bool ticking_ = false;
};

}  // namespace nao::services

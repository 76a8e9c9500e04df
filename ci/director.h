#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "ci/hearing.h"
#include "ci/judge.h"
#include "ci/last_seconds.h"
#include "ci/result.h"
#include "ci/scenario.h"
#include "ci/violations.h"
#include "core/mailbox.h"
#include "daemon/daemon.h"
#include "daemon/director.h"

namespace nao::ci {

/// Lets a scenario happen in a daemon's world and judges it. Made before Daemon::run(), asked for
/// its result after it.
class Director final : public daemon::Director {
 public:
  /// Who runs it.
  struct Stage {
    std::function<void()> over;  // told once, on any thread: there is nothing more to see
    std::function<std::vector<EndedClient>()> take_ended;  // I/O thread, at every beat
  };
  Director(Scenario scenario, daemon::Daemon& daemon, Stage stage);
  ~Director() override;

  /// After Daemon::run().
  Result result();

  bool look(const daemon::LoopState& state) override;
  bool waits(SimTime now) override;
  void direct(runtime::Simulation& simulation) override;

 private:
  struct Look {  // at the services
    SimTime time{};
    Heard heard;
    std::vector<EndedClient> ended;
  };
  Moment makeMoment(runtime::Simulation& simulation);
  void act(runtime::Simulation& simulation);
  void disturbWires(SimTime now);
  void end(std::string trouble = {});

  const Scenario scenario_;
  daemon::Daemon& daemon_;
  const Stage stage_;
  Mailbox<Look> looks_{1U << 16U};

  // Of the I/O thread.
  Hearing hearing_;
  std::optional<SimTime> looked_;
  std::size_t next_wire_event_ = 0;
  bool told_diverged_ = false;

  // Of the simulation thread.
  Judge judge_;
  ViolationFinder violations_;
  LastSeconds last_seconds_;
  std::vector<Look> new_looks_;
  std::size_t next_event_ = 0;
  bool is_over_ = false;
  SimTime now_{};
  std::string trouble_;
};

}  // namespace nao::ci

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "daemon/qi_client.h"
#include "validation/log/robot_log.h"

namespace nao::recorder {

/// Rows of RobotLog 1 from ALMemory of a robot, real or simulated: one whenever the robot's own
/// clock (DCM/Time) has gone on. A simulation that is paused is stepped by one cycle for each, so
/// that a recording of it is the same however fast this machine is.
class MemoryRows {
 public:
  /// Finds out which columns the robot has keys for; joints as `model` names them. `patience`:
  /// readings of a clock that stands, 1 ms apart, until it is an error.
  MemoryRows(daemon::QiClient& client, const RobotModel& model, int patience = 10000);

  /// Adds the next row to a run; returns its time within the run [s], 0 for the first.
  /// @throws InputError if the robot's clock stands still or goes back.
  double add(validation::LogRun& run);

  /// Adds rows until the run is this long [s].
  void addUntil(validation::LogRun& run, double t);

  /// What a call ends with, while rows are read and let go: it may take any time of the robot's.
  rpc::Value await(const daemon::QiClient::Ticket& ticket);

 private:
  struct Source {
    std::string column;
    double scale = 1;
  };
  void findSources(const RobotModel& model);
  void findSimulation(const RobotModel& model);
  std::vector<rpc::Value> readNext();
  bool goOn(const rpc::Value& clock);

  daemon::QiClient& client_;
  int patience_;
  std::vector<Source> sources_;
  rpc::Value keys_;                   // of the clock, then of the sources
  std::int64_t steps_ = 0;            // of physics for a row of a paused simulation; 0: none
  std::int64_t clock_ = -1;           // [ms] as it was read last; -1: never
  std::int64_t now_ = 0, begun_ = 0;  // [ms] since the first reading; begun_: of the run
};

}  // namespace nao::recorder

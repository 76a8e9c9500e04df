#pragma once

#include <map>
#include <string>
#include <vector>

#include "motion/kinematics.h"
#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// The numbered postures behind ALRobotPosture, as its methods with an underscore see them: those
/// of the robot's file, and those that clients save, which are gone when the daemon ends. Nobody
/// documents these methods; they do what their names and arguments say. I/O thread.
class PostureLibrary {
 public:
  explicit PostureLibrary(RobotLink& link);
  void declare(rpc::Service& service);

  /// Whether a client saved a posture of this name.
  bool holds(const std::string& name) const;
  std::vector<std::string> savedNames() const;

  /// Brings the joints there straight on; true if they get there.
  rpc::Pending<bool> goTo(const std::string& saved_name, double fraction);

 private:
  struct Entry {
    std::string name;
    std::string family;  // of those of the robot's file
    JointArray<double> angle;
    bool saved = false;  // by a client
  };

  void declareNames(rpc::Service& service);
  void declareSaving(rpc::Service& service);
  void declareDistances(rpc::Service& service);
  void declareGoing(rpc::Service& service);
  void declareKept(rpc::Service& service);

  const Entry& at(int id) const;
  int idOf(const std::string& name) const;
  bool save(int id, const std::string& name);
  bool rename(int id, const std::string& name);
  double jointDistance(const Entry& entry) const;  // [rad] the largest
  std::vector<float> effectorDistances(const Entry& entry);
  bool isIn(const Entry& entry, double joints) const;
  rpc::Pending<bool> goToEntry(const Entry& entry, double fraction);
  void goThrough(std::vector<int> ids, double fraction, const rpc::Pending<bool>& done);

  RobotLink& link_;
  motion::Kinematics kinematics_;
  std::map<int, Entry> entries_;
};

}  // namespace nao::services

#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "motion/kinematics.h"
#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"
#include "naoqi_api/services/kept_lines.h"

namespace nao::services {

/// The numbered postures behind ALRobotPosture, as its methods with an underscore see them: those
/// of the robot's file, and those that clients save, which are gone when the daemon ends unless a
/// client writes them to a library below the data directory. Nobody documents these methods; they
/// do what their names and arguments say. I/O thread.
class PostureLibrary {
 public:
  PostureLibrary(RobotLink& link, std::filesystem::path data_dir);
  void declare(rpc::Service& service);

  /// Whether a client saved a posture of this name.
  bool holds(const std::string& name) const;
  std::vector<std::string> savedNames() const;

  /// Brings the joints there straight on; true if they get there.
  rpc::Pending<bool> goTo(const std::string& saved_name, double fraction);

  /// The robot is on its way to a posture until `done`: what _getCurrentPath tells.
  void follow(const std::string& name, const rpc::Pending<bool>& done);

 private:
  static constexpr std::size_t kMostPostures = 1024;
  struct Entry {
    std::string name;
    std::string family;  // of those of the robot's file
    JointArray<double> angle;
    bool saved = false;  // by a client
  };

  // Through postures one after the other.
  struct Journey {
    std::vector<int> left;  // to go to, the present one first
    double fraction = 1;    // of top speed
    rpc::Pending<bool> done;
  };

  void declareNames(rpc::Service& service);
  void declareSaving(rpc::Service& service);
  void declareDistances(rpc::Service& service);
  void declareGoing(rpc::Service& service);
  void declareKept(rpc::Service& service);
  void declareFiles(rpc::Service& service);

  const Entry& at(int id) const;
  int idOf(const std::string& name) const;
  bool save(int id, const std::string& name);
  bool rename(int id, const std::string& name);
  void eraseSaved();
  KeptLines fileOf(const std::string& library) const;
  bool saveLibrary(const std::string& library) const;
  bool loadLibrary(const std::string& library);
  std::pair<int, Entry> readEntry(const KeptLines::Line& line) const;
  double jointDistance(const Entry& entry) const;  // [rad] the largest
  std::vector<float> effectorDistances(const Entry& entry);
  bool isIn(const Entry& entry, double joints) const;
  rpc::Pending<bool> goToEntry(const Entry& entry, double fraction);
  void goOn(const std::shared_ptr<Journey>& journey);
  std::vector<float> currentPath() const;

  RobotLink& link_;
  motion::Kinematics kinematics_;
  std::filesystem::path data_dir_;
  std::map<int, Entry> entries_;
  std::shared_ptr<Journey> journey_;  // the last one
};

}  // namespace nao::services

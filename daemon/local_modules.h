#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

struct UsarnaoqiPictures;  // usarnaoqi_sdk/local_host.h

namespace nao::daemon {

/// Whose modules are asked for, and their files.
struct ModuleChoice {
  std::size_t robot = 0;
  std::vector<std::string> files;
};

/// Of options of the form [ROBOT=]FILE; who names no robot means the first.
/// @throws InputError for a robot that does not exist, and for two: the C++ library knows one.
ModuleChoice chooseModules(const std::vector<std::string>& options,
                           const std::vector<std::string>& robots);

/// Libraries of modules (`serve --module`) that run in this process: they call the robot through
/// its port as any client does, on threads of theirs, and are called at every cycle, while
/// simulated time waits for them.
class LocalModules {
 public:
  struct Robot {
    std::string host;
    std::uint16_t port = 0;
    std::string token;  // of the user kUser; empty: none is asked for
    const UsarnaoqiPictures* pictures = nullptr;
  };
  static constexpr char kUser[] = "usarnaoqi-module";

  /// Loads them. @throws InputError if a file is no library of modules.
  explicit LocalModules(const std::vector<std::string>& files);
  ~LocalModules();
  LocalModules(const LocalModules&) = delete;
  LocalModules& operator=(const LocalModules&) = delete;

  /// Makes the modules after the first cycle, on a thread of their own. `done` is called there
  /// after every cycle.
  void start(const Robot& robot, std::function<void()> done);

  /// Begins what they do at the end of a cycle; false if they are busy still, or there is nothing.
  bool beginCycle();
  /// Whether simulated time has to wait for that. After kPatience it does not: a module that
  /// itself waits for simulated time would wait forever.
  bool holdsTime();

  bool isOver();
  /// Ends the modules, which may take time, then calls `ended`, on their thread. Once.
  void end(std::function<void()> ended);

 private:
  static constexpr std::chrono::seconds kPatience{1};

  struct Library {
    std::string name;
    void* handle = nullptr;
    void* create = nullptr;
  };
  enum class State { Starting, Idle, InCycle, Ending, Over };

  static Library load(const std::string& file);
  void run(const Robot& robot);
  void create(const Robot& robot) const;

  std::vector<Library> libraries_;
  std::function<void()> done_;
  std::thread thread_;
  std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  State state_ = State::Starting;
  bool cycle_seen_ = false;
  bool end_asked_ = false;
  bool given_up_ = false;  // on the cycle under way
  std::chrono::steady_clock::time_point begun_;
  std::function<void()> ended_;
};

}  // namespace nao::daemon

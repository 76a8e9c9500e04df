#pragma once

#include <usarnaoqi_sdk/export.h>

/// What a process that hosts a robot and the library say to each other about local modules. The
/// host finds these functions by their names, in whatever a module's library is linked with.
extern "C" {

/// A camera's picture in the host's memory, to be read only, until its owner is given back.
struct UsarnaoqiPicture {
  int width, height, layers;
  int color;  // NaoQi's number of its colour space
  int seconds, microseconds;
  int camera;
  float angles[4];  // [rad] left, top, right, bottom
  const void* pixels;
  int size;  // [bytes]
  void* owner;
};

/// How a module gets the pictures of its windows without a copy. Any thread.
struct UsarnaoqiPictures {
  void* host;
  /// The newest picture of a window, or its camera's raw one: false if there is no such window.
  /// Waits for the first.
  bool (*lend)(void* host, const char* window, bool raw, UsarnaoqiPicture* picture);
  void (*giveBack)(void* owner);
};

/// The robot of this process, and who modules are to it; user and token may be empty.
struct UsarnaoqiRobot {
  const char* host;
  int port;
  const char* user;
  const char* token;
  const UsarnaoqiPictures* pictures;  // stays for as long as modules do
};

/// Takes texts for the log.
typedef void (*UsarnaoqiTell)(const char* text);

/// Makes modules: `create` is a library's _createModule. From now on every address that a module
/// names means this robot. Blocks as long as the modules' constructors do. False if it failed; why
/// is told. Errors of later cycles go to `tell`, too.
USARNAOQI_SDK_API bool usarnaoqi_sdk_start(const UsarnaoqiRobot* robot, const char* name,
                                           void* create, UsarnaoqiTell tell);

/// Calls what modules have connected to the DCM's loop; whoever calls holds simulated time.
USARNAOQI_SDK_API void usarnaoqi_sdk_cycle();

/// Ends all modules: they may still call the robot.
USARNAOQI_SDK_API void usarnaoqi_sdk_stop();

typedef bool (*UsarnaoqiStart)(const UsarnaoqiRobot*, const char*, void*, UsarnaoqiTell);
typedef void (*UsarnaoqiCycle)();
typedef void (*UsarnaoqiStop)();

}  // extern "C"

// Nods the head of a robot over LoLA, the socket of a NAO V6's body: a frame of what it senses
// comes every 12 ms, a map of what its motors shall do goes back. On the robot the socket is
// /tmp/robocup:
//
//   usarnaoqi serve --lola &
//   g++ -std=c++17 -O2 examples/lola_sine.cc -o lola_sine && ./lola_sine [PATH [SECONDS]]

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>  // reads and writes MessagePack
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Json = nlohmann::json;

constexpr double kCycle = 0.012;           // [s]
constexpr std::size_t kSensorFrame = 896;  // bytes, always
constexpr std::size_t kJoints = 25;
constexpr std::size_t kHeadYaw = 0;

int connectTo(const std::string& path) {
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
  if (connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
    throw std::runtime_error("no robot at " + path);
  }
  return socket;
}

Json receive(int socket) {
  std::vector<unsigned char> frame(kSensorFrame);
  if (recv(socket, frame.data(), frame.size(), MSG_WAITALL) != static_cast<ssize_t>(frame.size())) {
    throw std::runtime_error("the robot closed the connection");
  }
  return Json::from_msgpack(frame);
}

void send(int socket, const Json& actuators) {
  const std::vector<unsigned char> bytes = Json::to_msgpack(actuators);
  if (::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL) < 0) {
    throw std::runtime_error("the robot closed the connection");
  }
}

void nod(int socket, double seconds) {
  double furthest = 0;
  std::vector<float> position(kJoints), stiffness(kJoints);
  stiffness[kHeadYaw] = 1;  // all other joints stay limp
  for (double time = 0; time < seconds; time += kCycle) {
    const Json sensors = receive(socket);
    const double angle = sensors["Position"][kHeadYaw];
    furthest = std::max(furthest, std::abs(angle));
    position[kHeadYaw] = static_cast<float>(0.5 * std::sin(M_PI * time));  // every two seconds
    send(socket, {{"Position", position}, {"Stiffness", stiffness}, {"Chest", {0, 0, 1}}});
  }
  std::printf("the head went %.2f rad to the sides\n", furthest);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int socket = connectTo(argc > 1 ? argv[1] : "/tmp/robocup");
    nod(socket, argc > 2 ? std::atof(argv[2]) : 10);
    close(socket);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}

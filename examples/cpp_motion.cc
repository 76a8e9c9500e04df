// A robot stands up, waves with its left arm while it walks, and rests:
//   cpp_motion HOST [PORT]

#include <alerror/alerror.h>
#include <alproxies/almotionproxy.h>
#include <alproxies/alrobotpostureproxy.h>

#include <cstdlib>
#include <iostream>

namespace {

void wave(AL::ALMotionProxy& motion) {
  const AL::ALValue names = AL::ALValue::array("LShoulderPitch", "LElbowRoll");
  const AL::ALValue angles = AL::ALValue::array(AL::ALValue::array(-1.0f, -1.0f, 1.4f),
                                                AL::ALValue::array(-1.4f, -0.3f, -1.0f));
  const AL::ALValue times = AL::ALValue::array(1.0f, 1.8f, 3.0f);
  motion.angleInterpolation(names, AL::ALValue::array(angles[0], angles[1]),
                            AL::ALValue::array(times, times), true);
}

void show(const std::string& host, int port) {
  AL::ALMotionProxy motion(host, port);
  AL::ALRobotPostureProxy posture(host, port);
  motion.wakeUp();
  posture.goToPosture("StandInit", 0.5f);
  motion.setMoveArmsEnabled(false, true);
  const int walk = motion.post.moveTo(0.2f, 0.0f, 0.0f);  // does not wait
  wave(motion);
  motion.wait(walk, 0);
  const std::vector<float> place = motion.getRobotPosition(true);
  std::cout << "walked " << place[0] << " m" << std::endl;
  motion.rest();
}

}  // namespace

int main(int argc, char* argv[]) {
  if (argc < 2) {
    std::cerr << "Usage: " << argv[0] << " HOST [PORT]" << std::endl;
    return 2;
  }
  try {
    show(argv[1], argc > 2 ? std::atoi(argv[2]) : 9559);
  } catch (const AL::ALError& error) {
    std::cerr << error.what() << std::endl;
    return 1;
  }
  return 0;
}

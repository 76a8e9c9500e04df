#include "naoqi_api/services/pose_names.h"

namespace nao::services {

const std::map<std::string, std::string>& poseNames() {
  static const std::map<std::string, std::string> names = {
      {"Standing", "Stand"},   {"Sitting", "Sit"},        {"Crouching", "Crouch"},
      {"LyingBelly", "Belly"}, {"LyingBack", "Back"},     {"LyingLeft", "Left"},
      {"LyingRight", "Right"}, {"SittingOnChair", "Sit"}, {"Kneeling", "Knee"},
      {"Frog", "Frog"}};
  return names;
}

std::string poseOf(const std::string& family) {
  const auto found = poseNames().find(family);
  return found == poseNames().end() ? "Unknown" : found->second;
}

}  // namespace nao::services

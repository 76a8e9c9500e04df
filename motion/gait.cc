#include "motion/gait.h"

namespace nao::motion {

void archiveConfig(Archive& archive, GaitConfig& config) {
  for (double* number :
       {&config.max_step_x, &config.min_step_x, &config.max_step_y, &config.max_step_theta,
        &config.max_step_frequency, &config.step_height, &config.torso_wx, &config.torso_wy}) {
    archive.value(*number);
  }
}

}  // namespace nao::motion

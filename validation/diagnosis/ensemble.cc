#include "validation/diagnosis/ensemble.h"

#include "validation/diagnosis/joint_data.h"

namespace nao::validation {
namespace {

Eigen::MatrixXd meanRun(const JointSimulator& joint, const std::vector<EffectSetting>& causes,
                        std::size_t motion, const JointNoise& noise, StreamUse use, int first,
                        int runs) {
  Eigen::MatrixXd sum = joint.run(causes, motion, streamOf(use, motion, first), noise);
  for (int r = 1; r < runs; ++r) {
    sum += joint.run(causes, motion, streamOf(use, motion, first + r), noise);
  }
  return sum / runs;
}

}  // namespace

Ensemble::Ensemble(const JointSimulator& joint, const JointData& data, const JointNoise& noise,
                   long granted)
    : joint_(joint), data_(data), noise_(noise), granted_(granted) {}

std::vector<EffectSetting> Ensemble::withGiven(const std::vector<EffectSetting>& causes) const {
  std::vector<EffectSetting> all = given_;
  all.insert(all.end(), causes.begin(), causes.end());
  return all;
}

Eigen::VectorXd Ensemble::mean(const std::vector<EffectSetting>& causes, int runs, StreamUse use,
                               int first) {
  const std::vector<EffectSetting> all = withGiven(causes);
  std::vector<Eigen::MatrixXd> means;
  for (const MotionSpan& span : data_.spans()) {
    means.push_back(meanRun(joint_, all, span.motion, noise_, use, first, runs));
    used_ += runs;
  }
  return data_.stack(means);
}

Eigen::VectorXd Ensemble::measuredAgain(const std::vector<EffectSetting>& causes, StreamUse use,
                                        int set) {
  const std::vector<EffectSetting> all = withGiven(causes);
  std::vector<Eigen::MatrixXd> means;
  for (const MotionSpan& span : data_.spans()) {
    means.push_back(
        meanRun(joint_, all, span.motion, noise_, use, set * span.repeats, span.repeats));
    used_ += span.repeats;
  }
  return data_.stack(means);
}

}  // namespace nao::validation

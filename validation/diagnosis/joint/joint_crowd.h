#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "validation/diagnosis/joint/diagnose.h"

namespace nao::validation {

/// Whether a joint is to be searched once more by the usual noise of its repeats [N m, SD of the
/// torque]: they scatter as under far more, and this verdict does not tell why. What it tells may
/// be of no interest: in such noise a joint that sticks tells no size.
bool isLoud(const JointVerdict& verdict, double fitted, double usual);

/// The best that looks at a cause of a joint's own link promise.
struct LinkLook {
  std::size_t cause = 0;
  std::vector<double> x;
  double gain = 0;  // [nats]
};

/// What the others must know of a joint that was looked at.
struct JointLooks {
  NullRecord nulls;
  double best = 0;    // [nats] the largest gain of any look
  double square = 0;  // of the residual
  std::vector<SharedPart> shared;
  std::vector<LinkLook> links;
};

/// All joints of a set, searched side by side: by the threads of this process, and by the other
/// processes of the team, each of which has joints of its own. All of them know what every joint
/// answers. What was simulated and concluded before is taken from the kept work.
class JointCrowd {
 public:
  /// Tasks, causes, team and kept work must outlive it.
  JointCrowd(const std::vector<JointTask>& tasks, const std::vector<Cause>& causes,
             const DiagnosisOptions& options);
  ~JointCrowd();

  std::size_t size() const { return searches_.size(); }
  const std::vector<Cause>& causes() const { return searches_.front()->causes(); }
  const JointData& data(std::size_t joint) const { return searches_[joint]->data(); }

  /// Looks at every cause at every joint.
  void begin();
  /// Of all joints, since begin() or give().
  const std::vector<JointLooks>& looks() const { return looks_; }
  /// The largest of all joints, by null set.
  NullRecord largestNulls() const { return allBut(size()).nulls; }
  /// Whether the one joint carries the other's link.
  bool carries(std::size_t joint, std::size_t other) const;
  /// What each joint gains with this number [nats].
  std::vector<double> gainsAt(std::size_t cause, double x);
  /// With these numbers of one joint's link.
  std::vector<double> gainsAt(std::size_t cause, const std::vector<double>& x, std::size_t link);
  /// Where each joint would have the number instead.
  std::vector<SharedStep> stepsFrom(std::size_t cause, double x);
  /// What exact runs with this number leave at each joint [nats].
  std::vector<double> leftAt(std::size_t cause, double x);
  /// Sizes that a joint proposes for a cause that beats.
  std::vector<double> beatingSizesOf(std::size_t joint, std::size_t cause);
  /// Takes a cause for given at all joints and looks anew.
  void give(std::size_t cause, double x);
  /// Takes for given, at the joints that carry it, these numbers of a joint's link; neither they
  /// nor that joint try `ruled_out`. They look anew.
  void giveLink(std::size_t link, std::size_t cause, const std::vector<double>& x,
                std::size_t ruled_out);
  /// The verdicts of all joints. What was found of a link is taken for given where the joints that
  /// carry it found something, too, if it helps there: these are searched once more.
  std::vector<JointVerdict> conclude();

 private:
  struct Done {
    std::atomic<double> look{0}, rest{0};  // parts of the two that are done, 0 to 1
  };

  std::vector<std::string> ask(const std::string& question,
                               const std::function<std::string(std::size_t)>& work);
  void taped(std::size_t joint, const std::string& question, const std::function<void()>& work);
  void watched(std::size_t joint, double usual, std::atomic<double>& part,
               const std::function<void()>& work);
  void lookAnew(const std::string& question, const std::function<void(std::size_t)>& work);
  OtherJoints allBut(std::size_t joint) const;
  static std::string questionOf(const std::string& what, std::size_t cause,
                                const std::vector<double>& x);
  std::vector<double> answersOf(const std::string& question,
                                const std::function<double(std::size_t)>& work);
  std::vector<EffectSetting> carriedBy(std::size_t joint,
                                       const std::vector<JointVerdict>& verdicts) const;
  JointVerdict searchedAnew(std::size_t joint, const std::vector<JointVerdict>& verdicts);
  void searchAbove(std::vector<JointVerdict>& verdicts);
  JointVerdict searchedQuietly(std::size_t joint, JointVerdict loud) const;
  std::string unitOf(std::size_t joint, const std::string& question) const;
  void tell() const;

  const std::vector<JointTask>& tasks_;
  const std::vector<Cause>& causes_;  // as they are before a joint bounds them
  const DiagnosisOptions& options_;
  std::vector<std::unique_ptr<JointSearch>> searches_;
  std::vector<JointLooks> looks_;
  std::vector<Done> done_;
  std::string step_;
  bool given_ = false;  // whether joints take something for given
};

}  // namespace nao::validation

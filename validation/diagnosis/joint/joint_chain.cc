// The part of JointCrowd that knows which joint carries which: what a link weighs is felt by all
// joints up to the base.
#include <algorithm>

#include "validation/diagnosis/jobs/packed.h"
#include "validation/diagnosis/joint/joint_crowd.h"

namespace nao::validation {
namespace {

bool contains(const std::vector<Joint>& all, Joint joint) {
  return std::find(all.begin(), all.end(), joint) != all.end();
}

bool foundSomething(const JointVerdict& verdict) {
  return verdict.verdict != Verdict::NoDiscrepancy && verdict.verdict != Verdict::Unfinished;
}

// What was named of the joint's link, as it acts.
std::vector<EffectSetting> linkOf(const JointVerdict& verdict, const std::vector<Cause>& causes,
                                  const std::vector<Joint>& place) {
  std::vector<EffectSetting> found;
  for (const Finding* finding : verdict.named()) {
    const auto cause = std::find_if(causes.begin(), causes.end(),
                                    [&](const Cause& one) { return one.id == finding->cause; });
    if (cause == causes.end() || !cause->of_link) continue;
    std::vector<double> x;
    for (const FoundNumber& number : finding->numbers) x.push_back(number.deviation);
    found.push_back(settingOf(*cause, x));
    found.back().joints = place;
  }
  return found;
}

// Of `before`, what is no longer needed beside what another joint's link explains.
void tellWhatWentAway(const JointVerdict& before, JointVerdict& now) {
  for (const Finding* old : before.named()) {
    const auto named = now.named();
    const bool still = std::any_of(named.begin(), named.end(),
                                   [&](const Finding* one) { return one->cause == old->cause; });
    if (!still) {
      now.rejected.push_back({old->cause, old->gain, "a link that the joint carries explains it"});
    }
  }
}

}  // namespace

bool JointCrowd::carries(std::size_t joint, std::size_t other) const {
  const std::vector<Joint> carried = tasks_[joint].joint->carried();
  const std::vector<Joint> place = tasks_[other].joint->place();
  return joint != other && place.size() == 1 && contains(carried, place.front());
}

void JointCrowd::giveLink(std::size_t link, std::size_t cause, const std::vector<double>& x,
                          std::size_t ruled_out) {
  EffectSetting setting = settingOf(causes()[cause], x);
  setting.joints = tasks_[link].joint->place();
  given_ = true;
  lookAnew(questionOf("given" + std::to_string(link), cause, x), [&](std::size_t j) {
    Beside beside{{}, {ruled_out}};
    if (carries(j, link)) beside.effects = {setting};
    if (j == link || carries(j, link)) searches_[j]->give(beside);
  });
}

// What was found of links that this joint carries.
std::vector<EffectSetting> JointCrowd::carriedBy(std::size_t joint,
                                                 const std::vector<JointVerdict>& verdicts) const {
  std::vector<EffectSetting> all;
  for (std::size_t other = 0; other < size(); ++other) {
    if (!carries(joint, other)) continue;
    for (EffectSetting& one : linkOf(verdicts[other], causes(), tasks_[other].joint->place())) {
      all.push_back(std::move(one));
    }
  }
  return all;
}

JointVerdict JointCrowd::searchedAnew(std::size_t joint,
                                      const std::vector<JointVerdict>& verdicts) {
  JointVerdict before = verdicts[joint];
  searches_[joint] = std::make_unique<JointSearch>(
      *tasks_[joint].joint, tasks_[joint].noise, causes_, options_.effort, options_.runs_per_joint);
  searches_[joint]->begin({carriedBy(joint, verdicts), {}});
  JointVerdict now = searches_[joint]->conclude(allBut(joint));
  now.runs = before.runs += now.runs;
  if (now.misfit_before >= before.misfit_before) return before;
  now.misfit_before = before.misfit_before;
  tellWhatWentAway(before, now);
  return now;
}

// From the ends of the limbs up: what is itself searched anew is not yet given to others.
void JointCrowd::searchAbove(std::vector<JointVerdict>& verdicts) {
  std::vector<bool> open(size());
  for (std::size_t j = 0; j < size(); ++j) {
    open[j] = foundSomething(verdicts[j]) && !carriedBy(j, verdicts).empty();
  }
  step_ = "searching joints that carry such a link";
  while (std::find(open.begin(), open.end(), true) != open.end()) {
    std::vector<bool> now(size());
    for (std::size_t j = 0; j < size(); ++j) {
      now[j] = open[j];
      for (std::size_t other = 0; other < size(); ++other) {
        if (open[other] && carries(j, other)) now[j] = false;
      }
    }
    const auto answers = ask("above", [&](std::size_t j) {
      if (!now[j]) return std::string();
      return options_.kept.remember(unitOf(j, "above"),
                                    [&] { return pack(searchedAnew(j, verdicts)); });
    });
    for (std::size_t j = 0; j < size(); ++j) {
      if (now[j]) verdicts[j] = unpack<JointVerdict>(answers[j]);
      if (now[j]) open[j] = false;
    }
  }
}

}  // namespace nao::validation

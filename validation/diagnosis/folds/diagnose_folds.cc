#include "validation/diagnosis/folds/diagnose_folds.h"

#include <algorithm>

#include "validation/diagnosis/jobs/packed.h"
#include "validation/report.h"

namespace nao::validation {
namespace {

std::vector<std::string> notesOf(const FoldDiagnosis& found) {
  std::vector<std::string> notes{
      "without repeats: causes were chosen by what they predict of folds that their numbers were "
      "not fitted to; intervals draw the logs again"};
  for (std::size_t f = 0; f < found.folds.size(); ++f) {
    notes.push_back(found.folds[f].name + " by numbers fitted to the others: mean error " +
                    fixed(1e3 * found.before.held_out[f], 1) + " -> " +
                    fixed(1e3 * found.after.held_out[f], 1) + " mrad");
  }
  notes.push_back("all folds together: held out " + fixed(1e3 * found.after.mean(), 1) +
                  " mrad, fitted " + fixed(1e3 * found.fitted, 1) + " mrad");
  return notes;
}

}  // namespace

bool isWithoutRepeats(const JointSimulator& joint) {
  return std::all_of(joint.measured().begin(), joint.measured().end(),
                     [](const JointMotion& motion) { return motion.repeats.size() < 2; });
}

FoldedSet diagnoseByFolds(const std::vector<JointTask>& tasks, const std::vector<Cause>& causes,
                          const FoldSearchOptions& options, const Team& team,
                          const KeptWork& kept) {
  const auto answers = askAll(team, "folds", tasks.size(), 1, [&](std::size_t j) {
    const JointSimulator& joint = *tasks[j].joint;
    return kept.remember(joint.joint() + ".folds", [&] {
      // Long steps err by far less than what folds disagree by.
      return pack(searchByFolds(joint.coarse(), causes, options));
    });
  });
  FoldedSet result;
  for (const std::string& answer : answers) {
    FoldDiagnosis found = unpack<FoldDiagnosis>(answer);
    for (const std::string& note : notesOf(found)) {
      result.notes += found.verdict.joint + ": " + note + "\n";
    }
    result.diagnosis.joints.push_back(std::move(found.verdict));
  }
  result.diagnosis.verdict = overall(result.diagnosis.joints);
  return result;
}

}  // namespace nao::validation

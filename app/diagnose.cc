#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>

#include "app/commands.h"
#include "app/mpi_team.h"
#include "app/source_paths.h"
#include "app/stand_by.h"
#include "core/config.h"
#include "core/files.h"
#include "validation/diagnosis/extend/gain.h"
#include "validation/diagnosis/joint_level.h"
#include "validation/diagnosis/report/diagnosis_json.h"
#include "validation/diagnosis/report/diagnosis_page.h"
#include "validation/diagnosis/report/verdict_record.h"
#include "validation/diagnosis/whole/whole_diagnosis.h"
#include "validation/log/data_faults.h"
#include "validation/log/file_hash.h"
#include "validation/plot.h"

namespace nao::app {
namespace {

constexpr char kKept[] = "/unfinished";  // in --out
constexpr char kRecord[] = "validation/record/diagnosis.yaml";

struct Arguments {
  std::string set, model, out, budget, joint, from;
  std::string level = "joint";
  std::string robots_dir = "robots", record = kRecord;
  int jobs = 1;
  bool json = false;
};

// "5min", "90s", "1h", or seconds.
double secondsOf(const std::string& text) {
  std::size_t end = 0;
  double number = 0;
  try {
    number = std::stod(text, &end);
  } catch (const std::logic_error&) {
    end = 0;
  }
  const std::string unit = text.substr(end);
  if (end > 0 && number > 0 && (unit.empty() || unit == "s")) return number;
  if (end > 0 && number > 0 && unit == "min") return 60 * number;
  if (end > 0 && number > 0 && unit == "h") return 3600 * number;
  throw InputError("--budget " + text + ": expected a time such as 5min, 90s or 1h");
}

std::string partOf(const std::string& file) { return file + ".part"; }

// An earlier file of the name stays until this one is whole.
void write(const std::string& file, const std::string& text) {
  writeFile("--out", partOf(file), text);
  std::error_code failed;
  std::filesystem::rename(partOf(file), file, failed);
  if (failed) throw InputError(file + ": can not be written");
}

// What can not be written or drawn is told before the work.
void prepareFolder(const std::string& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) throw InputError("--out " + folder + ": the folder can not be made");
  const std::string report = folder + "/report.json";
  writeFile("--out", partOf(report), "");
  std::filesystem::remove(partOf(report));
  validation::requireGnuplot();
}

// What the set can not answer is told before the work.
void requireWhatIsAsked(const Arguments& arguments, const validation::LogSet& set) {
  requireRuns(set, {validation::Split::Fit});
  const auto is_asked = [&](const auto& joint) { return joint.name == arguments.joint; };
  if (!arguments.joint.empty() && std::none_of(set.joints.begin(), set.joints.end(), is_asked)) {
    throw InputError("--joint " + arguments.joint + ": expected a joint of the set");
  }
}

// One encoder's coarse steps are a cause of its joint. A walk answers its sensors: repeats of it
// need not have the same commands, and each run is replayed with its own.
void stopAtFaults(const validation::LogSet& set, const RobotModel& model, const std::string& level,
                  const validation::Team& team) {
  auto faults = validation::findDataFaults(set, &model);
  const auto is_allowed = [&](const validation::DataFault& fault) {
    return level == "joint" ? validation::isOneCoarseEncoder(fault)
                            : fault.kind == validation::DataFaultKind::Misaligned;
  };
  faults.erase(std::remove_if(faults.begin(), faults.end(), is_allowed), faults.end());
  if (!validation::anyFault(faults)) return;
  if (team.rank() > 0) throw CLI::RuntimeError(0);
  std::printf("verdict: data_fault\n%s", toText(validation::reportDataFaults(set, faults)).c_str());
  throw CLI::RuntimeError(exitCodeOf(validation::Verdict::DataFault));
}

// Who repeats it gets the same, whatever the number of threads; a budget must be given again.
std::string commandOf(const Arguments& arguments) {
  std::string command = "usarnaoqi diagnose " + arguments.set;
  if (!arguments.model.empty()) command += " --model " + arguments.model;
  if (!arguments.joint.empty()) command += " --joint " + arguments.joint;
  if (arguments.level != "joint") command += " --level " + arguments.level;
  if (!arguments.from.empty()) command += " --from " + arguments.from;
  if (!arguments.budget.empty()) command += " --budget " + arguments.budget;
  if (arguments.robots_dir != Arguments().robots_dir) {
    command += " --robots-dir " + arguments.robots_dir;
  }
  if (arguments.record != kRecord) command += " --record " + arguments.record;
  return command;
}

validation::Provenance provenanceOf(const Arguments& arguments, const validation::LogSet& set,
                                    const std::string& model) {
  return {set.name,
          model,
          commandOf(arguments),
          arguments.level,
          validation::sha256OfFolder(arguments.set,
                                     {arguments.out, validation::testOpeningsFile(arguments.set)}),
          validation::sha256OfFolder(findSourceFile(arguments.robots_dir) + "/" + model),
          validation::countTestOpenings(arguments.set)};
}

// All that decides what the parts of a diagnosis come to. A program is known by its size and time.
std::string keyOf(const Arguments& arguments, const validation::Provenance& provenance) {
  std::ostringstream from;  // its folder may be that of --out, in which parts are kept
  if (!arguments.from.empty()) from << std::ifstream(arguments.from + "/report.json").rdbuf();
  const std::string program = "/proc/self/exe";
  const auto built = std::filesystem::last_write_time(program).time_since_epoch().count();
  return "program " + std::to_string(std::filesystem::file_size(program)) + " " +
         std::to_string(built) + "\nset " + provenance.set_sha256 + "\nmodel " + provenance.model +
         "\nrobots " +
         validation::sha256OfFolder(findSourceFile(arguments.robots_dir), {arguments.out}) +
         "\nlevel " + arguments.level + "\njoint " + arguments.joint + "\nbudget " +
         arguments.budget + "\nfrom " + validation::sha256Of(from.str()) + "\n";
}

// The first process decides whether what is there is of this diagnosis.
validation::KeptWork takeUp(const Arguments& arguments, const validation::Provenance& provenance,
                            const validation::Team& team, StandBy& stand_by) {
  if (arguments.out.empty()) return {};
  const std::string folder = arguments.out + kKept;
  const std::string key =
      validation::askFirst(team, "key", [&] { return keyOf(arguments, provenance); });
  validation::KeptWork kept;
  if (team.rank() == 0) kept = validation::KeptWork(folder, key);
  team.exchange("");
  if (team.rank() > 0) kept = validation::KeptWork(folder, key);
  if (kept.found() == validation::KeptWork::Found::Same) {
    stand_by.say("going on with what is finished in " + folder);
  } else if (kept.found() == validation::KeptWork::Found::Other) {
    stand_by.say(folder + " is of another set, model or program or of other options: begun anew");
  }
  return kept;
}

void writeReport(const Arguments& arguments, const std::string& json, const std::string& page) {
  if (arguments.out.empty()) return;
  write(arguments.out + "/report.json", json + "\n");
  write(arguments.out + "/report.html", page);
}

void report(const Arguments& arguments, const std::string& json, const std::string& text,
            validation::Verdict verdict) {
  std::printf("%s", (arguments.json ? json + "\n" : text).c_str());
  const int code = exitCodeOf(verdict);
  if (code != 0) throw CLI::RuntimeError(code);
}

validation::VerdictRecords recordsOf(const Arguments& arguments) {
  const std::string file = findSourceFile(arguments.record);
  if (arguments.record != kRecord && !std::filesystem::exists(file)) {
    throw InputError("--record " + arguments.record + ": expected a file, found none");
  }
  return validation::VerdictRecords::read(file);
}

int leastRepeats(const validation::LogSet& set) {
  std::map<std::string, int> repeats;
  for (const validation::LogRun& run : set.runs) ++repeats[run.motion];
  int least = 1000;
  for (const auto& [motion, count] : repeats) least = std::min(least, count);
  return least;
}

// Limb and robot level: the whole robot is replayed.
void runWhole(const Arguments& arguments, const validation::LogSet& set,
              const std::shared_ptr<const RobotModel>& model, const std::string& name,
              StandBy& stand_by) {
  if (!arguments.joint.empty()) {
    throw InputError("--joint " + arguments.joint + ": expected --level joint");
  }
  const validation::VerdictRecords records = recordsOf(arguments);
  validation::WholeDiagnosisOptions options;
  options.level = arguments.level == "limb" ? validation::Level::Limb : validation::Level::Robot;
  options.jobs = arguments.jobs;
  if (!arguments.from.empty()) {
    options.handed_on = validation::readHandedOn(arguments.from + "/report.json", arguments.level);
  }
  if (!arguments.budget.empty()) options.seconds = secondsOf(arguments.budget);
  options.progress = [&](const std::string& what, double part) { stand_by.tell(what, part); };
  const validation::Provenance provenance = provenanceOf(arguments, set, name);
  options.kept = takeUp(arguments, provenance, validation::Team(), stand_by);
  auto found = validation::diagnoseWhole(set, model, options);
  addRecords(found.set, records, arguments.level, "whole robot", leastRepeats(set));
  const std::string json = toJson(found, provenance);
  writeReport(arguments, json, arguments.out.empty() ? "" : wholePage(found, provenance));
  options.kept.discard();
  report(arguments, json, toText(found), found.set.verdict);
}

// Joint level: each joint alone.
void runJoints(const Arguments& arguments, const validation::LogSet& set,
               const std::shared_ptr<const RobotModel>& model, const std::string& name,
               const std::shared_ptr<const validation::Team>& team, StandBy& stand_by) {
  if (!arguments.from.empty()) {
    throw InputError("--from " + arguments.from + ": expected --level limb or robot");
  }
  const validation::VerdictRecords records = recordsOf(arguments);  // its mistakes cost no search
  const validation::Provenance provenance = provenanceOf(arguments, set, name);
  validation::JointLevelOptions options;
  options.jobs = arguments.jobs;
  options.team = team;
  options.only = arguments.joint;
  if (!arguments.budget.empty()) options.seconds = secondsOf(arguments.budget);
  options.examine = !arguments.out.empty();
  options.kept = takeUp(arguments, provenance, *team, stand_by);
  options.progress = [&](const std::string& what, double part) { stand_by.tell(what, part); };
  const auto [found, notes, examined] =
      validation::diagnoseJointLevel(set, model, records, options);
  const std::string json = toJson(found, provenance);
  if (options.examine && team->rank() == 0) {
    writeReport(arguments, json, diagnosisPage(found, examined, provenance));
  }
  team->exchange("");  // nobody goes, or throws away what is kept, before the report is written
  options.kept.discard();
  if (team->rank() == 0) report(arguments, json, toText(found) + notes, found.verdict);
}

void diagnose(const Arguments& arguments, const std::shared_ptr<const validation::Team>& team,
              StandBy& stand_by) {
  const validation::LogSet set = validation::readLogSet(arguments.set);
  requireWhatIsAsked(arguments, set);
  const std::string name = arguments.model.empty() ? set.robot : arguments.model;
  const auto model = loadRobotModel(findSourceFile(arguments.robots_dir), name);
  stopAtFaults(set, *model, arguments.level, *team);
  if (team->rank() == 0 && !arguments.out.empty()) prepareFolder(arguments.out);
  if (arguments.level == "joint") {
    runJoints(arguments, set, model, name, team, stand_by);
  } else if (team->rank() == 0) {  // the others have nothing to do
    runWhole(arguments, set, model, name, stand_by);
  }
}

void run(const Arguments& arguments) {
  StandBy stand_by(arguments.out.empty()
                       ? "interrupted; nothing was kept"
                       : "interrupted; the same command goes on with what is finished in " +
                             arguments.out + kKept);
  const std::shared_ptr<const validation::Team> team = joinTeam();
  if (team->rank() > 0) stand_by.hush();
  try {
    diagnose(arguments, team, stand_by);
  } catch (const InputError& error) {
    if (team->size() == 1) throw;
    std::fprintf(stderr, "usarnaoqi: %s\n", error.what());
    team->abandon(2);  // the others would wait for this one
  }
}

}  // namespace

void addDiagnose(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "diagnose",
      "Names what a recorded set (docs/robot_log.md) shows that the model does not, joint by\n"
      "joint, limb by limb or of the whole robot. Exit code 0: no discrepancy, 10 named, 11 "
      "ambiguous, 12 unknown or partly "
      "explained,\n"
      "13 unfinished, 20 data fault.");
  command->add_option("set", arguments->set, "The set's folder.")->required();
  command->add_option("--model", arguments->model,
                      "The nominal robot; the set's own if not given.");
  command->add_option("--joint", arguments->joint, "This joint only.");
  command
      ->add_option(
          "--level", arguments->level,
          "joint: each joint alone, of a robot hung up. limb: stops that two joints share,\n"
          "masses of a chain. robot: ground, timing, sides and joints from whole runs of a\n"
          "robot that stands, kicks or walks.")
      ->check(CLI::IsMember({"joint", "limb", "robot"}))
      ->capture_default_str();
  command->add_option("--from", arguments->from,
                      "Folder of a lower level's report: what it found competes again, begun from "
                      "its\nnumbers.");
  command
      ->add_option("--jobs", arguments->jobs,
                   "Threads; the result is the same for any number, and for any number of "
                   "processes\nthat mpirun starts.")
      ->check(CLI::PositiveNumber);
  command->add_option("--budget", arguments->budget, "Time to stop after, such as 5min.");
  command->add_option("--out", arguments->out,
                      "Folder for report.json and report.html. What is finished is kept there: "
                      "after an\ninterruption the same command goes on.");
  command->add_option("--robots-dir", arguments->robots_dir, "Where the robots' folders are.")
      ->capture_default_str();
  command
      ->add_option("--record", arguments->record,
                   "How diagnoses of hidden sets turned out; `usarnaoqi bench diagnosis --record`\n"
                   "writes it.")
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "The report instead of text.");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace nao::app

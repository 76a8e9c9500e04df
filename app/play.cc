#include "validation/play.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/modes.h"
#include "app/source_paths.h"
#include "core/check.h"
#include "core/files.h"
#include "motion/timeline/motion_file.h"
#include "validation/film.h"
#include "validation/play_page.h"
#include "validation/play_report.h"
#include "validation/png.h"

namespace nao::app {
namespace {

constexpr int kBrokenFile = 3;  // exit code: not all of the motion could be read

struct Arguments {
  std::string file;
  std::string box;
  std::string robot = "nao_h21_v33";
  std::string robots_dir = "robots";
  std::string world;
  double step = 0.002;  // [s]
  std::string mode = "implicit";
  validation::PlaySettings settings;
  std::string video;
  std::string page;
  bool json = false;
  bool strict = false;
};

// The pictures of a motion that the user asked for, taken while it plays.
class Pictures {
 public:
  Pictures(const Arguments& arguments, double length)
      : every_(arguments.page.empty() ? 0 : std::max(length / (kStills - 1), 0.1)) {
    if (arguments.video.empty()) return;
    film_ = std::make_unique<validation::Film>(arguments.video, findEncoder());
  }

  void look(const sim::World& world, double time) {
    const bool still_due = every_ > 0 && stills_.size() < kStills &&
                           time >= every_ * static_cast<double>(stills_.size());
    if (film_ && film_->isDue(time)) film_->add(world.scene());
    if (still_due) stills_.push_back({time, validation::encodePng(camera_.picture(world.scene()))});
  }
  void close() {
    if (film_) film_->close();
  }
  const std::vector<validation::Still>& stills() const { return stills_; }

 private:
  static constexpr std::size_t kStills = 9;  // free choice: three rows of a page

  double every_;  // [s] 0: no stills
  std::unique_ptr<validation::Film> film_;
  validation::OutsideCamera camera_{{300, 225}};
  std::vector<validation::Still> stills_;
};

motion::Timeline load(const Arguments& arguments) {
  const std::string file = findMotionFile(arguments.file, arguments.robot);
  const RobotModel& model = *arguments.settings.model;
  if (!arguments.box.empty()) return motion::loadBox(file, arguments.box, model);
  return motion::loadMotion(file, model);
}

void run(Arguments& arguments) {
  validation::PlaySettings& settings = arguments.settings;
  settings.model = loadRobotModel(findSourceFile(arguments.robots_dir), arguments.robot);
  settings.world = std::make_shared<WorldModel>();
  if (!arguments.world.empty()) settings.world = loadWorldModel(findSourceFile(arguments.world));
  settings.step = fromSeconds(arguments.step);
  settings.mode = parseMode(arguments.mode);
  const motion::Timeline timeline = load(arguments);
  Pictures pictures(arguments, timeline.length);
  const auto watch = [&](const sim::World& world, double time) { pictures.look(world, time); };
  const validation::Played played = validation::play(timeline, settings, watch);
  pictures.close();
  const validation::Report report = reportPlay(arguments.file, timeline, settings, played);
  if (!arguments.page.empty()) {
    writeFile("--report", arguments.page,
              playPage(*settings.model, report, played, pictures.stills()));
  }
  std::printf("%s", (arguments.json ? toJson(report) + "\n" : toText(report)).c_str());
  if (!timeline.broken.empty()) throw CLI::RuntimeError(kBrokenFile);
  if (arguments.strict && !played.faults.empty()) throw CLI::RuntimeError(1);
}

}  // namespace

void addPlay(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "play", "Plays a motion file on a simulated robot and tells what is wrong with it.");
  command
      ->add_option("file", arguments->file,
                   "A motion file of any kind (.xar .crg .pml .qianim .motion .kme .pos .mof .kfm\n"
                   ".json), a behavior's folder, or the name of a motion shipped here.")
      ->required();
  command->add_option("--box", arguments->box, "Plays only this box of a behavior.");
  command->add_option("--robot", arguments->robot, "A robot of the folder robots/.")
      ->capture_default_str();
  command->add_option("--robots-dir", arguments->robots_dir, "Where the robots' folders are.")
      ->capture_default_str();
  command->add_option("--world", arguments->world, "A YAML file. Default: a flat ground.");
  command->add_option("--from", arguments->settings.from,
                      "The posture before the motion, or 'first': the motion's own first pose.\n"
                      "Default: StandInit.");
  command->add_option("--hold", arguments->settings.hold, "Time to watch after the end [s].")
      ->check(CLI::Range(0.0, 600.0))
      ->capture_default_str();
  command->add_option("--step", arguments->step, "Length of a physics step [s], 0.001 to 0.005.")
      ->capture_default_str();
  command->add_option("--mode", arguments->mode, "How to integrate: implicit, rk4 or reference.")
      ->capture_default_str();
  command
      ->add_option("--seed", arguments->settings.seed, "Start of all random numbers; 0: no chance.")
      ->capture_default_str();
  command->add_option("--video", arguments->video,
                      "Also films it from outside, 25 pictures a second: FILE.mp4, or a folder\n"
                      "for PNG files.");
  command->add_option("--report", arguments->page,
                      "Also writes one HTML page: faults, pictures, how each joint followed.");
  command->add_flag("--strict", arguments->strict, "Ends with exit code 1 if there is any fault.");
  command->add_flag("--json", arguments->json, "One JSON object instead of tables.");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace nao::app

// Thesis section 5.3.3, figures 25 and 26. One joint follows an angleInterpolation while pictures
// are drawn at some frame rate and a client reads the angles at some status interval. In USARSim
// commands arrived once per frame at most, and so the frame rate changed the motion; here it must
// change nothing, and the interval only what the client sees.
#include <array>
#include <cmath>

#include "camera/render_queue.h"
#include "core/check.h"
#include "runtime/simulation.h"
#include "validation/experiment.h"
#include "validation/motion_trial.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""ms;

constexpr double kDegree = M_PI / 180;
constexpr std::array<int, 6> kFrameRates{0, 2, 5, 25, 50, 60};
constexpr std::array<Duration, 2> kStatusIntervals{10ms, 100ms};
constexpr Duration kAwake = 4000ms;
constexpr Duration kMotion = 5000ms;

/// One angle over time.
struct Curve {
  std::vector<double> t, angle_deg;  // [s] since the motion began, [deg]
  void add(double seconds, double radians) {
    t.push_back(seconds);
    angle_deg.push_back(radians / kDegree);
  }
};

struct Trial {
  Curve command, truth, client;  // truth and command by cycle, client by status interval
  std::vector<JointCommand> commands;
  std::uint64_t hash = 0;
  std::map<std::string, double> draw;
};

Joint headYaw(const RobotModel& model) {
  const auto joint = model.findJoint("HeadYaw");
  if (!joint) throw InputError("robot " + model.name + ": expected a joint HeadYaw");
  return *joint;
}

// As a daemon with a camera client and a polling client would run, on one thread.
class Watched {
 public:
  Watched(const ExperimentSettings& settings, int frame_rate)
      : simulation_(loadWorld(settings), {{"nao", loadRobot(settings), {}}}, optionsOf(settings)),
        feed_(std::make_shared<camera::ImageFeed>()),
        queue_(std::make_shared<camera::RenderQueue>(feed_)),
        joint_(headYaw(simulation_.robot(0).model())),
        cycle_(simulation_.robot(0).model().cycle) {
    if (frame_rate == 0) return;
    if (simulation_.robot(0).model().cameras.empty()) {
      throw InputError("robot " + settings.robot + ": expected a camera");
    }
    camera::ImageRequest request;
    request.size = {160, 120};
    request.frame_rate = frame_rate;
    feed_->subscribe(request);
    simulation_.showTo(queue_, 0);
  }

  Trial run(Duration status_interval) {
    Trial trial;
    ask(1, motion::WakeUp{});
    advanceTo(SimTime(kAwake));
    ask(2, swing());
    for (Duration t{}; t < kMotion; t += cycle_) {
      advanceTo(SimTime(kAwake + t + cycle_));
      look(toSeconds(t + cycle_), trial);
      if ((t + cycle_) % status_interval == Duration::zero()) poll(toSeconds(t + cycle_), trial);
    }
    trial.hash = simulation_.hash();
    trial.draw = simulation_.world().draw();
    return trial;
  }

 private:
  static sim::WorldOptions optionsOf(const ExperimentSettings& settings) {
    sim::WorldOptions options(settings.step);
    options.seed = settings.seed;
    return options;
  }

  // Left, right and back, as smooth as angleInterpolation makes it.
  motion::Interpolate swing() const {
    motion::Curve curve;
    curve.joint = joint_;
    for (const auto& [time, angle_deg] : {std::pair{1.0, 60.0}, {3.0, -60.0}, {4.5, 0.0}}) {
      motion::Key key;
      key.time = time;
      key.angle = angle_deg * kDegree;
      curve.keys.push_back(key);
    }
    motion::Interpolate request;
    request.curves.push_back(curve);
    return request;
  }

  void ask(motion::RequestId id, const motion::MotionAction& action) {
    NAO_CHECK(simulation_.robot(0).ports()->requests.post({id, action}));
  }

  void advanceTo(SimTime time) {
    while (simulation_.now() < time) {
      simulation_.advanceTo(simulation_.now() + simulation_.stepSize());
      while (queue_->renderNext(renderer_)) continue;
    }
  }

  void look(double t, Trial& trial) {
    const JointCommand command = simulation_.robot(0).ports()->state.get()->command;
    trial.commands.push_back(command);
    trial.command.add(t, command.angle[joint_]);
    trial.truth.add(t, calcHingeAngle(simulation_.world().scene().robots[0], joint_));
  }

  void poll(double t, Trial& trial) {
    trial.client.add(t, simulation_.robot(0).ports()->sensors.get()->angle[joint_]);
  }

  runtime::Simulation simulation_;
  std::shared_ptr<camera::ImageFeed> feed_;
  std::shared_ptr<camera::RenderQueue> queue_;
  camera::Renderer renderer_;
  Joint joint_;
  Duration cycle_;
};

double largestDifference(const Curve& a, const Curve& b) {
  NAO_CHECK(a.t.size() == b.t.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.t.size(); ++i) {
    largest = std::max(largest, std::abs(a.angle_deg[i] - b.angle_deg[i]));
  }
  return largest;
}

// What USARSim made of the same commands: the newest is handed over once per frame, and the angle
// is reported once per frame too.
Curve asUsarSim(const ExperimentSettings& settings, const std::vector<JointCommand>& commands,
                int frame_rate) {
  const auto model = loadRobot(settings);
  const Joint joint = headYaw(*model);
  sim::World world(loadWorld(settings), {{"nao", model, {}}}, settings.step);
  world.placeRobot(0, {}, &commands.front().angle);
  Curve seen;
  JointCommand held = commands.front();
  double reported = world.readSensors(0).angle[joint];
  std::int64_t frame = -1;
  for (std::size_t k = 0; k < commands.size(); ++k) {
    const SimTime now = world.now();
    if (camera::pictureNumber(now, frame_rate) != frame) {
      frame = camera::pictureNumber(now, frame_rate);
      held = commands[k];
      reported = world.readSensors(0).angle[joint];
    }
    world.setCommand(0, held);
    seen.add(toSeconds(now) + toSeconds(model->cycle), reported);
    while (world.now() < now + model->cycle) world.step();
  }
  return seen;
}

// How far the reported angle lags behind the command at 1 Hz, by the phases of both.
double calcShift_ms(const ExperimentSettings& settings) {
  constexpr double kAmplitude = 0.3;  // [rad] stays below the joint's top speed
  constexpr double kOmega = 2 * M_PI;
  const auto model = loadRobot(settings);
  const Joint joint = headYaw(*model);
  sim::World world(loadWorld(settings), {{"nao", model, {}}}, settings.step);
  const Posture* posture = model->findPosture("StandInit");
  JointCommand command{posture ? posture->angle : JointArray<double>(model->jointCount()),
                       JointArray<double>(model->jointCount(), 1.0)};
  world.placeRobot(0, {}, &command.angle);
  double in_phase = 0;
  double behind = 0;
  while (world.now() < SimTime(5000ms)) {
    const SimTime now = world.now();
    const double t = toSeconds(now);
    command.angle[joint] = kAmplitude * std::sin(kOmega * t);
    const double angle = world.readSensors(0).angle[joint];
    world.setCommand(0, command);
    if (now >= SimTime(1000ms)) {  // four whole periods, settled
      in_phase += angle * std::sin(kOmega * t);
      behind -= angle * std::cos(kOmega * t);
    }
    while (world.now() < now + model->cycle) world.step();
  }
  return std::atan2(behind, in_phase) / kOmega * 1e3;
}

class HeadYaw {
 public:
  explicit HeadYaw(const ExperimentSettings& settings) : settings_(settings) {
    for (const int rate : kFrameRates) {
      for (const Duration interval : kStatusIntervals) add(rate, interval);
    }
    for (const int rate : {2, 5, 25, 50}) {
      usarsim_.push_back(asUsarSim(settings_, first_.commands, rate));
      usarsim_rates_.push_back(rate);
    }
    shift_ms_ = calcShift_ms(settings_);
  }

  Outcome take() {
    Outcome outcome;
    fillReport(outcome.report);
    outcome.picture = plot();
    return outcome;
  }

 private:
  void add(int rate, Duration interval) {
    Trial trial = Watched(settings_, rate).run(interval);
    if (first_.truth.t.empty()) first_ = trial;
    if (interval == kStatusIntervals.back()) slow_client_ = trial.client;
    const double deviation = largestDifference(trial.truth, first_.truth);
    largest_ = std::max(largest_, deviation);
    hash_ = combineHash(hash_, trial.hash);
    rows_.push_back({{"frame_rate_per_s", static_cast<double>(rate)},
                     {"status_interval_s", toSeconds(interval)},
                     {"max_deviation_deg", deviation},
                     {"same_state", trial.hash == first_.hash ? 1.0 : 0.0}});
    lines_.push_back({std::to_string(rate), fixed(toSeconds(interval) * 1e3, 0),
                      fixed(deviation, 9), trial.hash == first_.hash ? "equal" : "differs"});
  }

  void fillReport(Report& report) {
    report = startReport("headyaw", settings_);
    report.hash = hash_;
    report.draw = first_.draw;
    TextTable ours{"HeadYaw by angleInterpolation: difference from the first run",
                   {"frames/s", "status [ms]", "max deviation [deg]", "final state"},
                   lines_};
    TextTable theirs{"The same commands handed over once per frame, as in USARSim",
                     {"frames/s", "max deviation [deg]"},
                     {}};
    std::vector<Row> usarsim_rows;
    for (std::size_t i = 0; i < usarsim_.size(); ++i) {
      const double deviation = largestDifference(usarsim_[i], first_.truth);
      usarsim_rows.push_back({{"frame_rate_per_s", static_cast<double>(usarsim_rates_[i])},
                              {"max_deviation_deg", deviation}});
      theirs.lines.push_back({std::to_string(usarsim_rates_[i]), fixed(deviation, 2)});
    }
    report.tables = {std::move(ours), std::move(theirs)};
    report.figures = {{"max_deviation_deg", largest_},
                      {"command_to_sensor_shift_ms", shift_ms_},
                      {"rows", rows_},
                      {"once_per_frame_rows", std::move(usarsim_rows)}};
    report.remarks.push_back("A 1 Hz sine comes back from the encoder " + fixed(shift_ms_, 1) +
                             " ms after the command, servo included.");
    report.remarks.push_back(
        "Thesis (figures 25, 26): jagged and late at 2 and 5 frames/s; reported in stairs of the "
        "status interval.");
  }

  Picture plot() const {
    Panel ours = makePanel("Ours: the same at 0, 2, 5, 25, 50 and 60 frames per second", "time [s]",
                           "HeadYaw [deg]");
    const Curve& command = first_.command;
    ours.series = {{"command", command.t, command.angle_deg, Stroke::Line, Ink::Sky},
                   {"joint", first_.truth.t, first_.truth.angle_deg, Stroke::Line, Ink::Vermilion},
                   {"client, every 10 ms", first_.client.t, first_.client.angle_deg, Stroke::Steps,
                    Ink::Green},
                   {"client, every 100 ms", slow_client_.t, slow_client_.angle_deg, Stroke::Steps,
                    Ink::Black}};
    Panel theirs = makePanel("Commands and angles once per frame, as in USARSim (thesis figure 25)",
                             "time [s]", "HeadYaw [deg]");
    const Ink inks[] = {Ink::Purple, Ink::Vermilion, Ink::Orange, Ink::Green};
    theirs.series = {{"command", command.t, command.angle_deg, Stroke::Line, Ink::Sky}};
    for (std::size_t i = 0; i < usarsim_.size(); ++i) {
      theirs.series.push_back({std::to_string(usarsim_rates_[i]) + " frames/s", usarsim_[i].t,
                               usarsim_[i].angle_deg, Stroke::Line, inks[i]});
    }
    return {"Frame rate and status interval (thesis section 5.3.3)", {ours, theirs}, 1, 900, 900};
  }

  ExperimentSettings settings_;
  Trial first_;
  Curve slow_client_;
  std::vector<Curve> usarsim_;
  std::vector<int> usarsim_rates_;
  std::vector<Row> rows_;
  std::vector<std::vector<std::string>> lines_;
  double largest_ = 0;
  double shift_ms_ = 0;
  std::uint64_t hash_ = 0;
};

}  // namespace

Experiment headYawExperiment() {
  Experiment e;
  e.name = "headyaw";
  e.summary = "Frame rate and status interval: do they change a motion? (thesis figures 25, 26)";
  e.choices = {Choice::Robot, Choice::World, Choice::Step, Choice::Seed};
  e.run = [](const ExperimentSettings& settings) { return HeadYaw(settings).take(); };
  return e;
}

}  // namespace nao::validation

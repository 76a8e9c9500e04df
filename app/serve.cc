#include <CLI/CLI.hpp>
#include <cinttypes>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/commands.h"
#include "app/modes.h"
#include "app/source_paths.h"
#include "daemon/daemon.h"
#include "daemon/descriptor_limit.h"
#include "daemon/large_blocks.h"

namespace nao::app {
namespace {

struct Arguments {
  daemon::Options options;
  std::vector<std::string> robots;
  std::vector<std::string> behaviors;
  std::vector<std::string> lola;
  std::string lola_battery = "status-first";
  std::optional<double> lola_lockstep;
  std::string speed = "1";
  std::string mode = "implicit";
  bool scripts = false;
};

void printReady(daemon::Daemon& daemon, const daemon::Options& options) {
  const std::string& listen = options.listen.front();
  for (std::size_t i = 0; i < daemon.robotCount(); ++i) {
    std::printf("ready: %s (%s) at tcp://%s:%d\n", daemon.robotName(i).c_str(),
                daemon.robotModel(i).name.c_str(), listen.c_str(), daemon.port(i));
    for (const std::string& address : daemon.endpoints(i).otherAddresses()) {
      std::printf("       and at %s\n", address.c_str());
    }
    const char* camera = "top";
    for (const std::uint16_t port : daemon.lolaCameraPorts(i)) {
      std::printf("       and LoLA's %s camera at tcp://127.0.0.1:%d\n",
                  std::exchange(camera, "bottom"), port);
    }
    if (const daemon::LolaServer* lola = daemon.lola(i)) {
      std::printf("       and LoLA at %s%s\n", lola->path().c_str(),
                  options.lola_lockstep ? ", where the world waits for its client" : "");
    }
  }
  for (const auto& [name, value] : daemon.draw()) {
    std::printf("drawn: %s = %.9g\n", name.c_str(), value);
  }
  std::fflush(stdout);
}

// What the robots' files left open and how it was filled in: once, before anything moves.
void printNotes(daemon::Daemon& daemon) {
  for (std::size_t i = 0; i < daemon.robotCount(); ++i) {
    for (const std::string& note : daemon.robotModel(i).notes) {
      std::fprintf(stderr, "%s: %s\n", daemon.robotName(i).c_str(), note.c_str());
    }
  }
}

void serve(Arguments& arguments) {
  daemon::Options& options = arguments.options;
  for (const std::string& robot : arguments.robots) {
    options.robots.push_back(daemon::parseRobot(robot));
  }
  for (const std::string& lola : arguments.lola) {
    options.lola.push_back(daemon::parseLola(lola));
  }
  options.lola_battery = daemon::parseLolaBattery(arguments.lola_battery);
  options.lola_lockstep = arguments.lola_lockstep;
  options.speed = daemon::parseSpeed(arguments.speed);
  options.mode = parseMode(arguments.mode);
  options.world = findSourceFile(options.world);
  options.robots_dir = findSourceFile(options.robots_dir);
  options.pages = findSourceFile("naoqi_api/sdk/js");
  if (arguments.scripts) options.scripts = findSourceFile("naoqi_api/sdk/python");
  options.behaviors = shippedMotions();
  for (const std::string& folder : arguments.behaviors) options.behaviors.push_back(folder);

  daemon::raiseDescriptorLimit();
  daemon::keepLargeBlocks();
  daemon::Daemon daemon(options);
  printNotes(daemon);
  daemon.stopOnSignals();
  daemon.run([&] { printReady(daemon, options); });
  const daemon::LoopState end = daemon.state();
  std::printf("stopped at %.3f s of simulated time, seed %" PRIu64 ", state %016" PRIx64
              ", run %016" PRIx64 "\n",
              toSeconds(end.time), options.seed, end.hash, daemon.runHash());
  if (const std::string failure = daemon.recordingFailure(); !failure.empty())
    std::fprintf(stderr, "the recording ends early: %s\n", failure.c_str());
  if (const std::int64_t dropped = daemon.droppedPictures(); dropped > 0)
    std::printf("%" PRId64 " pictures came too late and were not drawn\n", dropped);
}

void addPort(CLI::App& command, const char* name, std::optional<std::uint16_t>& port,
             const std::string& meaning) {
  command.add_option(name, port, meaning + "; 0 takes any free one.");
}

void addWires(CLI::App& command, daemon::Options& options) {
  command.add_option("--auth", options.auth,
                     "Lets in only clients that name a user and token of this FILE, lines of\n"
                     "'user token': qi by auth_user and auth_token, msgpack-RPC by authenticate,\n"
                     "the web by its password dialogue.");
  command.add_flag("--insecure", options.insecure,
                   "Lets everybody in, also where --listen is more than this machine.");
  addPort(command, "--tls-port", options.tls_port, "Speaks qi over TLS (tcps) on this port, too");
  addPort(command, "--msgpack-port", options.msgpack_port, "Speaks MessagePack-RPC on this port");
  addPort(command, "--http-port", options.http_port,
          "Serves qi.js, its wire and a page on this port");
  command.add_option("--tls-dir", options.tls_dir,
                     "Where the certificate is; made at the first start. Default:\n"
                     "~/.local/state/usarnaoqi.");
  command.add_option("--allow-origin", options.origins,
                     "Lets pages of this address, such as http://localhost:3000, use the robot\n"
                     "through --http-port. Repeat it for more.");
}

void addLola(CLI::App& command, Arguments& arguments) {
  CLI::Option* lola =
      command
          .add_option(
              "--lola", arguments.lola,
              "Offers LoLA, the protocol of a V6's body, on a socket of this PATH:\n"
              "[ROBOT=]PATH, by default /tmp/robocup of the first robot without one, which is a\n"
              "nao_h25_v60 if no robot is named. Repeat it for more.")
          ->expected(0, 1)
          ->default_str("")
          ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
      .add_option("--lola-battery", arguments.lola_battery,
                  "What clients find behind the battery's charge: status-first or current-first.")
      ->capture_default_str()
      ->needs(lola);
  command
      .add_option("--lola-camera-port", arguments.options.lola_camera_port,
                  "Sends pictures to LoLA programs: the top camera's on this port (10001 if not\n"
                  "said), the bottom camera's on the next, then the next robot's; 0 takes any\n"
                  "free ones.")
      ->expected(0, 1)
      ->default_str("10001")
      ->needs(lola);
  command
      .add_option("--lola-camera-memory", arguments.options.lola_camera_memory,
                  "Writes pictures for LoLA programs to shared memory NAME.ROBOT.top and .bottom;\n"
                  "NAME is usarnaoqi if not said.")
      ->expected(0, 1)
      ->default_str("usarnaoqi")
      ->needs(lola);
  command
      .add_option(
          "--lola-lockstep", arguments.lola_lockstep,
          "The world waits for LoLA clients: for the first one of each robot, and then for\n"
          "the answer to every frame, so many seconds at most (5 if not said).")
      ->expected(0, 1)
      ->default_str("5")
      ->needs(lola);
}

}  // namespace

void addServe(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  daemon::Options& options = arguments->options;
  CLI::App* command = app.add_subcommand("serve", "Hosts robots until Ctrl-C.");
  command->add_option(
      "--robot", arguments->robots,
      "A robot of the folder robots/ or a FILE.urdf, as MODEL or NAME=MODEL. Repeat\n"
      "it for more: number i listens on port + i. Default: those of the world, else\n"
      "nao_h21_v33, or nao_h25_v60 with --lola.");
  command->add_option("--world", options.world, "The world, a YAML file.")->capture_default_str();
  command->add_option("--listen", options.listen, "The address to listen on. Repeat it for more.")
      ->capture_default_str();
  command->add_option("--port", options.port, "The first robot's port; 0 takes any free ones.")
      ->capture_default_str();
  addWires(*command, options);
  addLola(*command, *arguments);
  command
      ->add_option("--speed", arguments->speed,
                   "Simulated seconds per second, or 'max' for as fast as it goes.")
      ->capture_default_str();
  command->add_flag("--paused", options.paused,
                    "Time stands at first, until UsarSim.resume or UsarSim.step.");
  command->add_flag("--hung-up", options.hung_up,
                    "Hangs every robot up by its torso, feet in the air, as `record` needs it.");
  command
      ->add_option(
          "--seed", options.seed,
          "Draws what makes real runs differ, as the robots' files list it under\n"
          "`variation`: joint zeros, start pose, floor friction, encoder jitter, IMU noise.\n"
          "The same seed draws the same; 0: no variation.")
      ->capture_default_str();
  command->add_option("--record", options.record,
                      "Writes the run into this FILE, for `usarnaoqi replay`.");
  command->add_option("--mode", arguments->mode, "How to integrate: implicit, rk4 or reference.")
      ->capture_default_str();
  command->add_option("--step", options.step, "Length of a physics step [s], 0.001 to 0.005.")
      ->capture_default_str();
  command->add_option("--robots-dir", options.robots_dir, "Where the robots' folders are.")
      ->capture_default_str();
  command
      ->add_option(
          "--data-dir", options.data_dir,
          "Where the files are that clients play, record and write, and what they have the robot\n"
          "keep: preferences, postures. They see no other folder.")
      ->check(CLI::ExistingDirectory);
  command->add_option("--naoqi", options.naoqi,
                      "The NAOqi to be like where versions differ: 1.12, 1.14, 2.1, 2.5, 2.8 or\n"
                      "2.9. Default: the one that ran on the robot.");
  command->add_option("--behaviors", arguments->behaviors,
                      "A folder of behaviors or motion files to install on every robot, beside\n"
                      "those shipped here. Repeat it for more.");
  command->add_flag(
      "--scripts", arguments->scripts,
      "Runs the Python code in the boxes of behaviors, each behavior in a python3 of\n"
      "its own with all rights of this user (default: code is told, not run).");
  command->add_option(
      "--module", options.modules,
      "A library of C++ modules (naoqi_api/sdk/cpp), [ROBOT=]FILE, to load and run in this\n"
      "process, for that robot or the first: it may do all that this program may, and is called\n"
      "every 10 ms of simulated time. Repeat it for more of the same robot.");
  command->add_flag("--strict", options.strict,
                    "Refuse calls before authentication, as libqi 4 does (default: answer them,\n"
                    "as NAOqi 2.1 to 2.8 do).");
  command->footer(
      "Limits: payload 16 MiB (64 KiB before authentication), nesting 64, 1024 connections a wire\n"
      "(when all are taken, one that has not opened, or has been silent for a minute, loses its\n"
      "place to one that comes), 4096 subscriptions and 1024 unfinished calls a connection, 1024\n"
      "posted calls a client; above 1 MiB unsent a client is no longer read, above 8 MiB it is\n"
      "closed. Half a message, or an opening, that lasts 30 s is closed.");
  command->callback([arguments] { serve(*arguments); });
}

}  // namespace nao::app

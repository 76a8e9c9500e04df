#include <alcommon/albrokermanager.h>
#include <alcommon/altoolsmain.h>
#include <alerror/alerror.h>

#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <iostream>

#include "naoqi_api/sdk/cpp/src/qi_application.h"

namespace {

struct Options {
  std::string parent_ip = "127.0.0.1";
  int parent_port = 9559;
  std::string ip = "0.0.0.0";
  int port = 0;
  bool help = false;
};

constexpr char kUsage[] =
    "Usage: %s [--pip ROBOT] [--pport PORT] [-b|--bip IP] [-p|--bport PORT]\n";

// "--name value" and "--name=value".
Options parse(int argc, char* argv[]) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    std::string name = argv[i];
    const std::size_t equals = name.find('=');
    std::string value = equals == std::string::npos ? "" : name.substr(equals + 1);
    name = name.substr(0, equals);
    if (name == "-h" || name == "--help") options.help = true;
    if (name.empty() || name[0] != '-') continue;
    const bool takes_next = equals == std::string::npos && i + 1 < argc && argv[i + 1][0] != '-';
    if (takes_next) value = argv[++i];
    if (name == "--pip") options.parent_ip = value;
    if (name == "--pport") options.parent_port = std::atoi(value.c_str());
    if (name == "-b" || name == "--bip") options.ip = value;
    if (name == "-p" || name == "--bport") options.port = std::atoi(value.c_str());
  }
  return options;
}

volatile sig_atomic_t interrupted = 0;

void onSignal(int /*signal*/) { interrupted = 1; }

// A program that has a handler of its own keeps it.
void hearSignal(int number) {
  struct sigaction now {};
  if (sigaction(number, nullptr, &now) == 0 && now.sa_handler != SIG_DFL) return;
  struct sigaction ours {};
  ours.sa_handler = onSignal;
  sigaction(number, &ours, nullptr);
}

void serveUntilTheEnd(const AL::ALBroker& broker) {
  constexpr useconds_t kLook = 100000;  // [us] how late the end may be noticed
  while (interrupted == 0 && broker.isConnected()) ::usleep(kLook);
}

}  // namespace

int ALTools::mainFunction(const std::string& name, int argc, char* argv[],
                          TMainType create_module) {
  const Options options = parse(argc, argv);
  if (options.help) return std::printf(kUsage, argv[0]), 0;
  hearSignal(SIGINT);
  hearSignal(SIGTERM);
  try {
    const boost::shared_ptr<AL::ALBroker> broker = AL::ALBroker::createBroker(
        name, options.ip, options.port, options.parent_ip, options.parent_port);
    const int failed = create_module(broker);
    if (failed == 0) serveUntilTheEnd(*broker);
    nao::client::actAtStop();
    broker->shutdown();
    AL::ALBrokerManager::getInstance()->removeBroker(broker);
    return failed;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << std::endl;
    return 1;
  }
}

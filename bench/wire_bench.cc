// The qi wire while one Nao is simulated at 1x, seen from a client in its own process: delays
// beside those of an echo socket on the same I/O thread with the same sizes, calls a second when
// they are pipelined, events to many, and one picture fetched again and again. wire_bench
// [delays|rates|events|polls]: one JSON object of figures.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bench/event_storm.h"
#include "bench/server_watch.h"
#include "bench/wire_client.h"
#include "bench/wire_server.h"
#include "naoqi_api/wire/bytes.h"
#include "naoqi_api/wire/codec.h"

namespace nao::bench {
namespace {

using rpc::Value;

constexpr int kBatches = 10;
constexpr int kCallsPerBatch = 1000;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Medians over the batches.
struct Delays {
  double p50_us = 0;
  double p99_us = 0;
};

struct Batches {
  std::vector<double> p50;
  std::vector<double> p99;

  void add(std::vector<double> delays_us) {
    std::sort(delays_us.begin(), delays_us.end());
    p50.push_back(delays_us[delays_us.size() / 2]);
    p99.push_back(delays_us[delays_us.size() * 99 / 100]);
  }
  Delays medians() const { return {median(p50), median(p99)}; }
};

/// Asks the echo for messages of these sizes.
class EchoClient {
 public:
  EchoClient(std::uint16_t port, std::size_t asked, std::size_t answered)
      : client_(port), question_(asked, 'x'), answered_(answered) {
    wire::Bytes sizes;
    wire::appendNumber(sizes, static_cast<std::uint32_t>(asked));
    wire::appendNumber(sizes, static_cast<std::uint32_t>(answered));
    client_.send(sizes);
  }

  void ask() {
    client_.send(question_);
    std::size_t got = 0;
    char buffer[65536];
    while (got < answered_) {
      const ssize_t count = ::read(client_.descriptor(), buffer, sizeof buffer);
      if (count <= 0) std::abort();
      got += static_cast<std::size_t>(count);
    }
  }

 private:
  WireClient client_;
  wire::Bytes question_;
  std::size_t answered_;
};

template <class F>
std::vector<double> timed(const F& once) {
  std::vector<double> delays_us;
  for (int k = 0; k < kCallsPerBatch; ++k) {
    const auto start = Clock::now();
    once();
    delays_us.push_back(1e6 * secondsSince(start));
  }
  return delays_us;
}

/// One call and its echo, batch by batch in turn.
std::pair<Delays, Delays> compare(const WireServer& server, const wire::Address& address,
                                  const Value& arguments) {
  WireClient client(server.port);
  const std::size_t answered = wire::kHeaderSize + client.call(address, arguments).size();
  const wire::Bytes question = callFrame(address, arguments, 1);
  EchoClient echo(server.echo_port, question.size(), answered);
  Batches calls;
  Batches echos;
  for (int batch = 0; batch < kBatches; ++batch) {
    calls.add(timed([&] {
      client.send(question);
      client.receive();
    }));
    echos.add(timed([&] { echo.ask(); }));
  }
  return {calls.medians(), echos.medians()};
}

/// Calls a second with two windows of them on their way.
double pipelined(const WireServer& server, const wire::Address& address, const Value& arguments,
                 std::size_t calls) {
  constexpr std::size_t kWindow = 256;
  WireClient client(server.port);
  client.call(address, arguments);
  wire::Bytes window;
  for (std::uint32_t id = 1; id <= kWindow; ++id) {
    const wire::Bytes frame = callFrame(address, arguments, id);
    window.insert(window.end(), frame.begin(), frame.end());
  }
  const auto start = Clock::now();
  std::size_t sent = kWindow;
  std::size_t answered = 0;
  client.send(window);
  while (answered < calls) {
    if (sent < calls && sent - answered <= kWindow) {
      client.send(window);
      sent += kWindow;
    }
    client.receiveSome();
    answered += client.countMessages();
  }
  return static_cast<double>(answered) / secondsSince(start);
}

/// A client that fetches the picture of its window as fast as it can, thousands of times a second,
/// while a new one comes five times a second.
class Poller {
 public:
  Poller(const WireServer& server, int resolution) : server_(server), client_(server.port) {
    const std::uint32_t video = client_.service("ALVideoDevice");
    const auto subscribe = client_.method(video, "subscribeCamera", "(siiii)");
    constexpr int kYuv422 = 9;
    const Value handle =
        wire::Decoder(client_.call({video, 1, subscribe},
                                   Value::tuple({"poller", 0, resolution, kYuv422, 5})))
            .read("s");
    question_ = callFrame({video, 1, client_.method(video, "getImageRemote", "(s)")},
                          Value::tuple({handle}), 1);
  }

  /// Processor time of the daemon for one poll, physics and drawing included, which it would do
  /// without polls, too [us]; and polls a second.
  std::pair<double, double> run() {
    poll();  // waits for the first picture
    constexpr int kPolls = 20000;
    const auto start = Clock::now();
    const double before = processorTime(server_.process);
    for (int k = 0; k < kPolls; ++k) poll();
    return {1e6 * (processorTime(server_.process) - before) / kPolls, kPolls / secondsSince(start)};
  }

 private:
  void poll() {
    client_.send(question_);
    client_.receive();
  }

  const WireServer& server_;
  WireClient client_;
  wire::Bytes question_;
};

Value namesOf26(WireClient& client, std::uint32_t motion) {
  const auto get_names = client.method(motion, "getBodyNames", "(s)");
  return wire::Decoder(client.call({motion, 1, get_names}, Value::tuple({"Body"}))).read("[s]");
}

Value hundredKeys(const Value& joints) {
  std::vector<Value> keys;
  for (const char* what :
       {"Position/Sensor", "Position/Actuator", "ElectricCurrent/Sensor", "Temperature/Sensor"}) {
    for (const Value& joint : *joints.findItems()) {
      if (keys.size() == 100 || *joint.findText() == "RHipYawPitch") continue;
      keys.emplace_back("Device/SubDeviceList/" + *joint.findText() + "/" + what + "/Value");
    }
  }
  return Value::list(std::move(keys));
}

using Figures = std::map<std::string, double>;

/// What is called: a service of the daemon and its methods.
struct Calls {
  wire::Address get_angles;
  Value angles;  // the arguments
  wire::Address get_list;
  Value keys;
  wire::Address ping;
};

Calls callsOf(const WireServer& server) {
  WireClient client(server.port);
  const std::uint32_t motion = client.service("ALMotion");
  const std::uint32_t memory = client.service("ALMemory");
  const Value joints = namesOf26(client, motion);
  Calls calls;
  calls.get_angles = {motion, 1, client.method(motion, "getAngles", "(mb)")};
  calls.angles = Value::tuple("(mb)", {joints, true});
  calls.get_list = {memory, 1, client.method(memory, "getListData", "(m)")};
  calls.keys = Value::tuple("(m)", {hundredKeys(joints)});
  calls.ping = {memory, 1, client.method(memory, "ping", "()")};
  return calls;
}

void measureDelays(const WireServer& server, const Calls& calls, Figures& figures) {
  const auto [call, echo] = compare(server, calls.get_angles, calls.angles);
  figures["call_p50_us"] = call.p50_us;
  figures["call_p99_us"] = call.p99_us;
  figures["echo_p50_us"] = echo.p50_us;
  figures["echo_p99_us"] = echo.p99_us;
  const auto [list, list_echo] = compare(server, calls.get_list, calls.keys);
  figures["list_data_p50_us"] = list.p50_us;
  figures["list_data_echo_p50_us"] = list_echo.p50_us;
}

void measureRates(const WireServer& server, const Calls& calls, Figures& figures) {
  std::vector<double> pings;
  std::vector<double> angles;
  for (int k = 0; k < 5; ++k) {
    pings.push_back(pipelined(server, calls.ping, Value::tuple({}), 200000));
    angles.push_back(pipelined(server, calls.get_angles, calls.angles, 50000));
  }
  figures["calls_per_s"] = median(angles);
  figures["pings_per_s"] = median(pings);
}

void measurePolls(const WireServer& server, Figures& figures) {
  for (const auto& [resolution, name] : {std::pair(0, "160x120"), {1, "320x240"}, {2, "640x480"}}) {
    const auto [cpu_us, per_s] = Poller(server, resolution).run();
    figures["poll_" + std::string(name) + "_server_cpu_us"] = cpu_us;
    figures["polls_" + std::string(name) + "_per_s"] = per_s;
  }
}

void run(const WireServer& server, const std::string& part) {
  Figures figures;
  const Calls calls = callsOf(server);
  if (part.empty() || part == "delays") measureDelays(server, calls, figures);
  if (part.empty() || part == "rates") measureRates(server, calls, figures);
  if (part.empty() || part == "events") EventStorm(server).run(figures);
  if (part.empty() || part == "polls") measurePolls(server, figures);

  std::printf("{");
  const char* separator = "";
  for (const auto& [name, value] : figures) {
    std::printf("%s\"%s\": %.6g", std::exchange(separator, ", "), name.c_str(), value);
  }
  std::printf("}\n");
}

}  // namespace
}  // namespace nao::bench

int main(int argc, char** argv) {
  const auto server = nao::bench::startWireServer();
  nao::bench::run(server, argc > 1 ? argv[1] : "");
  nao::bench::stopWireServer(server);
  return 0;
}

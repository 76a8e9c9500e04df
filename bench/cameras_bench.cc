// What a robot with both its cameras on costs: physics, rendering, sensors and colour conversion of
// two streams of 640x480 at 30 pictures a second. Processor time of one thread per simulated
// second.

#include <benchmark/benchmark.h>

#include "runtime/simulation.h"

namespace nao::runtime {
namespace {

void twoCamerasAndPhysics(benchmark::State& state) {
  const std::string source = NAO_SOURCE_DIR;
  std::vector<sim::RobotSetup> robots;
  for (int i = 0; i < state.range(0); ++i) {
    robots.push_back({"nao" + std::to_string(i),
                      loadRobotModel(source + "/robots", "nao_h25_v50"),
                      {0.6 * i, i % 2 == 0 ? 0 : 0.4, i == 0 ? 0 : 3.14}});
  }
  Simulation simulation(loadWorldModel(source + "/worlds/field_2011.yaml"), robots,
                        std::chrono::milliseconds(2));
  const auto feed = std::make_shared<camera::ImageFeed>();
  const auto queue = std::make_shared<camera::RenderQueue>(feed);
  for (const int camera : {0, 1})
    feed->subscribe({camera, {640, 480}, camera::ColorSpace::kYUV422, 30});
  simulation.showTo(queue, 0);
  camera::Renderer renderer;
  SimTime now{};
  for (auto unused : state) {
    for (int i = 0; i < 100; ++i) {
      now += std::chrono::milliseconds(10);
      simulation.advanceTo(now);
      while (queue->renderNext(renderer)) {
      }
    }
  }
}
BENCHMARK(twoCamerasAndPhysics)->ArgName("robots")->Arg(1)->Arg(7)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nao::runtime

BENCHMARK_MAIN();

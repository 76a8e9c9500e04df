#include "naoqi_api/services/chest_button.h"

#include <array>
#include <utility>

#include "naoqi_api/services/make_module.h"

namespace nao::services {
namespace {

constexpr std::array<const char*, 3> kEvents = {"ALChestButton/SimpleClickOccurred",
                                                "ALChestButton/DoubleClickOccurred",
                                                "ALChestButton/TripleClickOccurred"};
constexpr std::chrono::milliseconds kPause{500};  // that ends a row of clicks; free

/// Counts clicks that follow each other. Lives in a shared_ptr.
class Clicks : public std::enable_shared_from_this<Clicks> {
 public:
  explicit Clicks(const ServiceContext& context) : context_(context) {}

  void look(const SensorFrame& frame) {
    if (std::exchange(is_down_, frame.touch.chest_button) == frame.touch.chest_button) return;
    if (is_down_ && frame.time > released_ + kPause) tell();  // of the row before
    if (is_down_) return;
    released_ = frame.time;
    ++count_;
    context_.later(kPause, [self = shared_from_this(), row = ++row_] {
      if (self->row_ == row && !self->is_down_) self->tell();
    });
  }

 private:
  void tell() {
    const std::size_t count = std::exchange(count_, 0);
    if (count == 0 || count > kEvents.size()) return;
    context_.store().raiseEvent(kEvents[count - 1], 1);
  }

  ServiceContext context_;
  bool is_down_ = false;
  SimTime released_{};
  std::size_t count_ = 0;  // of clicks in this row
  std::uint64_t row_ = 0;  // and of clicks at all
};

}  // namespace

std::shared_ptr<rpc::Service> makeChestButton(const ServiceContext& context) {
  auto service = makeModule("ALChestButton", "The chest button, click by click, as events.");
  for (const char* event : kEvents) context.store().declareEvent(event, "ALChestButton");
  const auto clicks = std::make_shared<Clicks>(context);
  context.link.onTouch([clicks](const auto& frame) { clicks->look(*frame); });
  return service;
}

}  // namespace nao::services

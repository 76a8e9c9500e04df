#include "daemon/local_pictures.h"

#include <boost/asio/post.hpp>
#include <future>
#include <memory>
#include <utility>

#include "naoqi_api/convert.h"

namespace nao::daemon {
namespace {

using rpc::Value;

// Width, height, layers, colour space, seconds, microseconds, pixels, camera; left, top, right and
// bottom angle: as getImageRemote lists them.
constexpr std::size_t kPixels = 6;
constexpr std::size_t kFields = 12;

/// Who has borrowed a picture holds this.
using Loan = rpc::SharedBytes;

bool fill(const Value& answer, UsarnaoqiPicture& picture) {
  const auto* items = answer.findItems();
  if (items == nullptr || items->size() < kFields) return false;
  auto loan = std::make_unique<Loan>((*items)[kPixels].findBytes());
  if (*loan == nullptr) return false;
  int* const numbers[] = {&picture.width, &picture.height,  &picture.layers,
                          &picture.color, &picture.seconds, &picture.microseconds,
                          nullptr,        &picture.camera};
  for (std::size_t i = 0; i < std::size(numbers); ++i)
    if (numbers[i] != nullptr) *numbers[i] = (*items)[i].to<int>();
  for (std::size_t i = 0; i < 4; ++i) picture.angles[i] = (*items)[kPixels + 2 + i].to<float>();
  picture.pixels = (*loan)->data();
  picture.size = static_cast<int>((*loan)->size());
  picture.owner = loan.release();
  return true;
}

}  // namespace

LocalPictures::LocalPictures(boost::asio::io_context& io, Ask ask)
    : io_(io), ask_(std::move(ask)), functions_{} {
  functions_.host = this;
  functions_.lend = [](void* host, const char* window, bool raw, UsarnaoqiPicture* picture) {
    return static_cast<LocalPictures*>(host)->lend(window, raw, *picture);
  };
  functions_.giveBack = [](void* owner) { delete static_cast<Loan*>(owner); };
}

bool LocalPictures::lend(const std::string& window, bool raw, UsarnaoqiPicture& picture) {
  const auto answer = std::make_shared<std::promise<Value>>();
  boost::asio::post(io_, [this, window, raw, answer] {
    ask_(window, raw).whenDone([answer](const rpc::Outcome<Value>& outcome) {
      answer->set_value(outcome.value.value_or(Value()));
    });
  });
  return fill(answer->get_future().get(), picture);
}

}  // namespace nao::daemon

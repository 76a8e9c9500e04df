#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "naoqi_api/memory/memory_store.h"
#include "naoqi_api/pending.h"
#include "naoqi_api/services/spoken_text.h"
#include "naoqi_api/tasks.h"

namespace nao::services {

/// Texts said one after the other. Nothing sounds: each is handed to a listener when its turn
/// comes, raises the events of ALTextToSpeech in the course of it, and takes as long as it would
/// to say. I/O thread.
class SpeechQueue {
 public:
  using Speak = std::function<void(const std::string& text)>;

  /// @param memory where events are raised
  /// @param call_later in simulated time
  /// @param speak is told each text when it begins
  SpeechQueue(memory::MemoryStore& memory, rpc::CallLater call_later, Speak speak);
  SpeechQueue(const SpeechQueue&) = delete;
  SpeechQueue& operator=(const SpeechQueue&) = delete;
  ~SpeechQueue();  // what was not said counts as canceled

  /// Ends when the text has been said or stopped. `speed`: 1 is normal. @throws CallError if the
  /// text is too long or too many wait.
  rpc::Pending<void> add(const std::string& text, double speed);

  /// Ends the text being said and all that wait.
  void stopAll();

  std::size_t size() const { return tasks_.size(); }

  static constexpr std::size_t kMostTasks = 256;
  static constexpr std::size_t kLongestText = 64U << 10U;  // [bytes]

 private:
  struct Task {
    std::int32_t id = 0;
    std::string text;
    SpokenText spoken;
    rpc::Pending<void> done;
    std::size_t next_word = 0;
    std::size_t next_mark = 0;
  };

  void begin();
  void proceed(Duration now);
  void wakeAt(Duration now, Duration next);
  void raiseDue(Duration now);
  void finish();
  void cancel(std::int32_t id);
  bool isSaying(std::int32_t id) const;
  void tellStopped(const Task& task, bool was_spoken);
  void raise(const char* event, const rpc::Value& value);
  void raiseStatus(std::int32_t id, const char* status);

  memory::MemoryStore& memory_;
  rpc::CallLater call_later_;
  Speak speak_;
  std::deque<Task> tasks_;  // the first is being said if speaking_
  bool speaking_ = false;
  std::int32_t last_id_ = 0;
  std::shared_ptr<SpeechQueue*> alive_ = std::make_shared<SpeechQueue*>(this);
};

}  // namespace nao::services

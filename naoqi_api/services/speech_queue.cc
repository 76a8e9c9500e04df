#include "naoqi_api/services/speech_queue.h"

#include <algorithm>
#include <utility>

#include "core/check.h"
#include "naoqi_api/call_error.h"

namespace nao::services {
namespace {

using rpc::Value;

constexpr char kPrefix[] = "ALTextToSpeech/";

}  // namespace

SpeechQueue::SpeechQueue(memory::MemoryStore& memory, rpc::CallLater call_later, Speak speak)
    : memory_(memory), call_later_(std::move(call_later)), speak_(std::move(speak)) {
  NAO_CHECK(call_later_ && speak_);
  for (const char* event :
       {"CurrentBookMark", "CurrentSentence", "CurrentWord", "PositionOfCurrentWord", "Status",
        "TextDone", "TextInterrupted", "TextStarted"}) {
    memory_.declareEvent(std::string(kPrefix) + event, "ALTextToSpeech");
  }
}

SpeechQueue::~SpeechQueue() {
  alive_.reset();
  for (const Task& task : std::exchange(tasks_, {})) task.done.cancelNow();
}

rpc::Pending<void> SpeechQueue::add(const std::string& text, double speed) {
  if (text.size() > kLongestText) {
    throw rpc::CallError("the text is too long: at most " + std::to_string(kLongestText) +
                         " bytes");
  }
  if (tasks_.size() >= kMostTasks) {
    throw rpc::CallError("too many texts are waiting: at most " + std::to_string(kMostTasks));
  }
  const std::int32_t id = ++last_id_;
  const rpc::Pending<void> done;
  done.onCancel([alive = std::weak_ptr<SpeechQueue*>(alive_), id] {
    if (const auto self = alive.lock()) (*self)->cancel(id);
  });
  tasks_.push_back({id, text, calcSpokenText(text, speed), done});
  raiseStatus(id, "enqueued");
  if (!speaking_) begin();
  return done;
}

void SpeechQueue::begin() {
  if (tasks_.empty()) return;
  speaking_ = true;
  const std::int32_t id = tasks_.front().id;
  const std::string text = tasks_.front().text;
  speak_(text);
  raiseStatus(id, "started");
  raise("TextDone", false);
  raise("TextStarted", true);
  raise("CurrentSentence", text);
  if (isSaying(id)) proceed({});
}

// Whoever hears of an event may have stopped the text.
bool SpeechQueue::isSaying(std::int32_t id) const { return speaking_ && tasks_.front().id == id; }

// What is due `now`, counted from the beginning of the text; then on to what comes next.
void SpeechQueue::proceed(Duration now) {
  const std::int32_t id = tasks_.front().id;
  raiseDue(now);
  if (!isSaying(id)) return;
  const Task& task = tasks_.front();
  if (now >= task.spoken.length) return finish();
  Duration next = task.spoken.length;
  const auto& [words, marks, length] = task.spoken;
  if (task.next_word < words.size()) next = std::min(next, words[task.next_word].start);
  if (task.next_mark < marks.size()) next = std::min(next, marks[task.next_mark].start);
  wakeAt(now, next);
}

void SpeechQueue::wakeAt(Duration now, Duration next) {
  const std::int32_t id = tasks_.front().id;
  call_later_(next - now, [alive = std::weak_ptr<SpeechQueue*>(alive_), id, next] {
    const auto self = alive.lock();
    if (self && (*self)->isSaying(id)) (*self)->proceed(next);
  });
}

void SpeechQueue::raiseDue(Duration now) {
  const std::int32_t id = tasks_.front().id;
  while (isSaying(id)) {
    Task& task = tasks_.front();
    const auto& [words, marks, length] = task.spoken;
    if (task.next_mark < marks.size() && marks[task.next_mark].start <= now) {
      raise("CurrentBookMark", marks[task.next_mark++].number);
    } else if (task.next_word < words.size() && words[task.next_word].start <= now) {
      const auto position = task.next_word++;
      const std::string word = words[position].text;
      raise("PositionOfCurrentWord", static_cast<std::int32_t>(position));
      if (isSaying(id)) raise("CurrentWord", word);
    } else {
      return;
    }
  }
}

void SpeechQueue::finish() {
  const Task task = std::move(tasks_.front());
  tasks_.pop_front();
  speaking_ = false;
  raise("CurrentWord", "");
  raise("CurrentSentence", "");
  raise("TextStarted", false);
  raise("TextDone", true);
  raiseStatus(task.id, "done");
  task.done.resolve();
  if (!speaking_) begin();
}

void SpeechQueue::tellStopped(const Task& task, bool was_spoken) {
  if (was_spoken) {
    raise("TextStarted", false);
    raise("TextInterrupted", true);
  }
  raiseStatus(task.id, "stopped");
}

void SpeechQueue::stopAll() {
  const auto stopped = std::exchange(tasks_, {});
  bool was_spoken = std::exchange(speaking_, false);
  for (const Task& task : stopped) {
    tellStopped(task, was_spoken);
    was_spoken = false;
  }
  for (const Task& task : stopped) task.done.resolve();
}

void SpeechQueue::cancel(std::int32_t id) {
  const auto found =
      std::find_if(tasks_.begin(), tasks_.end(), [id](const Task& task) { return task.id == id; });
  if (found == tasks_.end()) return;
  const bool was_spoken = isSaying(id);
  if (was_spoken) speaking_ = false;
  const Task task = std::move(*found);
  tasks_.erase(found);
  tellStopped(task, was_spoken);
  if (!speaking_) begin();
}

void SpeechQueue::raise(const char* event, const Value& value) {
  memory_.raiseEvent(kPrefix + std::string(event), value);
}

void SpeechQueue::raiseStatus(std::int32_t id, const char* status) {
  raise("Status", Value::list({id, status}));
}

}  // namespace nao::services

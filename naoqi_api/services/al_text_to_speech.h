#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "naoqi_api/memory/memory_store.h"
#include "naoqi_api/service.h"
#include "naoqi_api/services/speech_queue.h"
#include "naoqi_api/voice/voice.h"

namespace nao::services {

/// NaoQi's ALTextToSpeech without a voice: texts are handed to a listener instead of a loudspeaker,
/// and take their time. Language, voice, volume and effects are kept and change nothing but the
/// speed. I/O thread.
class AlTextToSpeech {
 public:
  /// @param memory where its events are raised; outlives it
  /// @param call_later in simulated time
  /// @param speak is told each text when it begins to be said
  AlTextToSpeech(memory::MemoryStore& memory, rpc::CallLater call_later, SpeechQueue::Speak speak);

  /// The folder below which sayToFile writes; none at first.
  void keepFilesIn(std::filesystem::path data_dir) { data_dir_ = std::move(data_dir); }

  /// The service; this object must outlive it.
  rpc::Service describe();

  /// Ends when the text has been said.
  rpc::Pending<void> say(const std::string& text);

 private:
  struct FileSpeech;
  rpc::Pending<void> sayIn(const std::string& text, const std::string& language);
  void stopAll() { queue_.stopAll(); }
  rpc::Pending<void> sayToFile(const std::string& text, const std::string& file);
  void speakOn(const std::shared_ptr<FileSpeech>& speech);
  voice::Manner manner() const;
  void resetSpeed() { parameters_["speed"] = 100; }
  bool addToDictionary(const std::string& word, const std::string& pronunciation);
  bool deleteFromDictionary(const std::string& word) { return dictionary_.erase(word) > 0; }

  std::string getLanguage() { return language_; }
  void setLanguage(const std::string& language);
  std::vector<std::string> getAvailableLanguages();
  std::string getLanguageEncoding(const std::string& language);
  std::string locale();

  std::string getVoice() { return voices_.at(language_); }
  void setVoice(const std::string& voice);
  std::vector<std::string> getAvailableVoices();
  void setLanguageDefaultVoice(const std::string& language, const std::string& voice);
  void loadVoicePreference(const std::string& preference);

  float getVolume() { return volume_; }
  void setVolume(float volume);
  float getParameter(const std::string& name);
  void setParameter(const std::string& name, float value);
  void setNotifications() {}

  void describeSpeaking(rpc::Service& service);
  void describeFiles(rpc::Service& service);
  void describeDictionary(rpc::Service& service);
  void describeLanguages(rpc::Service& service);
  void describeSound(rpc::Service& service);

  rpc::CallLater call_later_;
  SpeechQueue::Speak speak_;
  SpeechQueue queue_;
  std::filesystem::path data_dir_;
  std::map<std::string, std::string> dictionary_;  // pronunciations
  std::string language_ = "English";
  std::map<std::string, std::string> voices_;  // by language, in use
  std::map<std::string, float> parameters_;
  float volume_ = 1;
};

}  // namespace nao::services

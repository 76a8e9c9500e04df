#include "naoqi_api/services/audio_services.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "naoqi_api/services/al_audio_player.h"
#include "naoqi_api/services/extractor.h"
#include "naoqi_api/services/kept_names.h"
#include "naoqi_api/services/make_module.h"
#include "naoqi_api/services/microphones.h"
#include "naoqi_api/services/naoqi_method.h"
#include "naoqi_api/services/settings.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::CallError;
using rpc::Value;

struct Device {
  std::int32_t volume = 100;  // 0 to 100
  bool muted = false;
  bool input_open = true;
  bool output_open = true;
};

void declareVolume(rpc::Service& service, const std::shared_ptr<Device>& device) {
  addFunction(
      service, "setOutputVolume",
      [device](std::int32_t volume) { device->volume = std::clamp(volume, 0, 100); },
      "Is kept, within 0 to 100.", Argument{"volume", "0 to 100 [%]."});
  addFunction(
      service, "getOutputVolume", [device] { return device->volume; },
      "What was kept; 100 at first.");
  addFunction(
      service, "muteAudioOut", [device](bool muted) { device->muted = muted; }, "Is kept.",
      Argument{"mute", "True: silent."});
  addFunction(
      service, "isAudioOutMuted", [device] { return device->muted; }, "What was kept.");
  for (const bool open : {true, false}) {
    const std::string verb = open ? "open" : "close";
    addFunction(
        service, verb + "AudioInputs", [device, open] { device->input_open = open; }, "Is kept.");
    addFunction(
        service, verb + "AudioOutputs", [device, open] { device->output_open = open; }, "Is kept.");
  }
  addFunction(
      service, "isInputClosed", [device] { return !device->input_open; }, "What was kept.");
  addFunction(
      service, "isOutputClosed", [device] { return !device->output_open; }, "What was kept.");
}

void declareMicrophones(rpc::Service& service, const ServiceContext& context) {
  declareRecording(service, context);
  for (const char* name :
       {"enableEnergyComputation", "disableEnergyComputation", "flushAudioOutputs"}) {
    addFunction(
        service, name, [] {}, "Has no effect: it is silent.");
  }
  for (const char* name :
       {"getFrontMicEnergy", "getRearMicEnergy", "getLeftMicEnergy", "getRightMicEnergy"}) {
    addFunction(
        service, name, [] { return 0.0F; }, "0: it is silent.");
  }
  addFunction(
      service, "_getMicrophoneConfig", [] { return 0; }, "0: four microphones, as on a Nao.");
}

void declareListeners(rpc::Service& service) {
  const auto modules = std::make_shared<std::set<std::string>>();
  const Argument module{"module", "Its name."};
  const auto subscribe = [modules](const std::string& name) {
    requireRoom(*modules, name);
    modules->insert(name);
  };
  const auto unsubscribe = [modules](const std::string& name) { modules->erase(name); };
  addFunction(service, "subscribe", subscribe, "Is kept: no sound is ever sent.", module);
  addFunction(service, "unsubscribe", unsubscribe, "Is kept.", module);
  addFunction(
      service, "subscribeRemoteModule",
      [subscribe](const std::string& name) {
        subscribe(name);
        return true;
      },
      "Is kept: no sound is ever sent.", module);
  addFunction(
      service, "unSubscribeRemoteModule",
      [unsubscribe](const std::string& name) {
        unsubscribe(name);
        return true;
      },
      "Is kept.", module);
  addFunction(
      service, "setClientPreferences",
      [](const std::string&, std::int32_t, std::int32_t, std::int32_t) {}, "Has no effect.", module,
      Argument{"sampleRate", "[Hz]"}, Argument{"channels", "Which microphones."},
      Argument{"deinterleaved", "1: one channel after the other."});
  addFunction(
      service, "setClientPreferences",
      [](const std::string&, std::int32_t, const Value&, std::int32_t, std::int32_t) {},
      "Has no effect.", module, Argument{"sampleRate", "[Hz]"},
      Argument{"channels", "Which microphones."},
      Argument{"deinterleaved", "1: one channel after the other."},
      Argument{"timeStamp", "Ignored."});
  addFunction(
      service, "sendRemoteBufferToOutput", [](std::int32_t, const Value&) { return true; },
      "Is taken and not heard.", Argument{"frames", "How many."}, Argument{"buffer", "The sound."});
}

ServicePointer makeAudioDevice(const ServiceContext& context) {
  auto service = makeModule("ALAudioDevice", "Loudspeakers and microphones; all is silent.");
  const auto device = std::make_shared<Device>();
  declareVolume(*service, device);
  declareMicrophones(*service, context);
  declareListeners(*service);
  const auto parameters = std::make_shared<std::map<std::string, std::int32_t>>(
      std::map<std::string, std::int32_t>{{"outputSampleRate", 16000}});
  const Argument name{"name", "Such as outputSampleRate."};
  addFunction(
      *service, "setParameter",
      [parameters](const std::string& which, std::int32_t value) {
        requireRoom(*parameters, which);
        (*parameters)[which] = value;
      },
      "Is kept.", name, Argument{"value", "Its new value."});
  addFunction(
      *service, "getParameter",
      [parameters](const std::string& which) {
        const auto found = parameters->find(which);
        if (found == parameters->end()) throw CallError("there is no parameter " + which);
        return found->second;
      },
      "What was kept.", name);
  addFunction(
      *service, "playSine",
      [log = context.log](std::int32_t frequency, std::int32_t, std::int32_t, float duration) {
        log("plays: a sine of " + std::to_string(frequency) + " Hz for " +
            std::to_string(duration) + " s");
      },
      "Is logged.", Argument{"frequence", "[Hz]"}, Argument{"gain", "0 to 100."},
      Argument{"pan", "-1, 0 or 1."}, Argument{"duration", "[s]"});
  service->allAnswering(rpc::Answer::Simplified);
  return service;
}

struct Recognition {
  std::string language = "English";
  std::vector<std::string> words;
  std::map<std::string, float> parameters{{"Sensitivity", 0.5F}, {"Speed", 1.0F}};
  bool visual = true;
};

void declareVocabulary(rpc::Service& service, const std::shared_ptr<Recognition>& state) {
  const Argument words{"vocabulary", "The words to wait for."};
  addFunction(
      service, "setVocabulary",
      [state](const std::vector<std::string>& list, bool) { state->words = list; },
      "Is kept: nobody will say them.", words,
      Argument{"enableWordSpotting", "Whether words in between are ignored."});
  addFunction(
      service, "setWordListAsVocabulary",
      [state](const std::vector<std::string>& list) { state->words = list; },
      "Is kept: nobody will say them.", words);
  const Argument language{"language", "In English: French, German, ..."};
  addFunction(
      service, "setLanguage", [state](const std::string& name) { state->language = name; },
      "Is kept.", language);
  addFunction(
      service, "getLanguage", [state] { return state->language; }, "What was kept.");
  addFunction(
      service, "getAvailableLanguages",
      [] {
        return std::vector<std::string>{"English", "French"};
      },
      "English and French.");
  addFunction(
      service, "setVisualExpression", [state](bool on) { state->visual = on; }, "Is kept.",
      Argument{"enabled", "True: the eyes would show it."});
  addFunction(
      service, "setVisualExpressionMode", [](std::int32_t) {}, "Has no effect.",
      Argument{"mode", "0 to 3."});
  addFunction(
      service, "setParameter",
      [state](const std::string& name, float value) {
        requireRoom(state->parameters, name);
        state->parameters[name] = value;
      },
      "Is kept.", Argument{"name", "Such as Sensitivity."}, Argument{"value", "Its new value."});
  addFunction(
      service, "getParameter",
      [state](const std::string& name) {
        const auto found = state->parameters.find(name);
        if (found == state->parameters.end()) throw CallError("there is no parameter " + name);
        return found->second;
      },
      "What was kept.", Argument{"name", "Such as Sensitivity."});
  for (const char* name : {"_enableFreeSpeechToText", "_disableFreeSpeechToText",
                           "removeAllContext", "pushContexts", "popContexts"}) {
    addFunction(
        service, name, [] {}, "Has no effect: nobody speaks.");
  }
}

ServicePointer makeSpeechRecognition(const ServiceContext& context) {
  auto service = makeModule("ALSpeechRecognition", "Waits for words; nobody speaks.");
  const auto extractor = std::make_shared<Extractor>(
      context.store(), "ALSpeechRecognition",
      Extractor::Outputs{{"WordRecognized", "WordRecognizedAndGrammar", "LastWordRecognized",
                          "SpeechDetected", "ALSpeechRecognition/Status",
                          "ALSpeechRecognition/ActiveListening", "ALSpeechRecognition/IsRunning"},
                         {}});
  extractor->declare(*service);
  extractor->onWorking([&store = context.store()](bool works) {
    store.raiseEvent("ALSpeechRecognition/IsRunning", works);
    store.raiseEvent("ALSpeechRecognition/Status", works ? "ListenOn" : "ListenOff");
    if (works) store.insert("WordRecognized", Value::list({"", 0.0F}));
  });
  service->owning(extractor);
  declareVocabulary(*service, std::make_shared<Recognition>());
  addSettings(*service, documentedService("ALSpeechRecognition"), {{"AudioExpression", true}});
  service->allAnswering(rpc::Answer::Simplified);
  return service;
}

// What is said of a text with ^start(animation) and the like between its words.
std::string withoutAnimations(const std::string& text) {
  std::string said;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '^') {
      const std::size_t open = text.find('(', i);
      const std::size_t close = open == std::string::npos ? open : text.find(')', open);
      if (close != std::string::npos && text.find(' ', i) > open) {
        i = close;
        continue;
      }
    }
    said += text[i];
  }
  return said;
}

ServicePointer makeAnimatedSpeech(const ServiceContext& context, const Say& say) {
  auto service = makeModule("ALAnimatedSpeech", "Speech with gestures; only the speech is made.");
  context.store().declareEvent("ALAnimatedSpeech/EndOfAnimatedSpeech", "ALAnimatedSpeech");
  const Argument text{"text", "What to say; ^start(...) and its like are left out."};
  const auto speak = [say, &store = context.store(),
                      count = std::make_shared<int>(0)](const std::string& words) {
    const auto done = say(withoutAnimations(words));
    const int id = ++*count;
    done.whenDone([&store, id](const auto&) {
      store.raiseEvent("ALAnimatedSpeech/EndOfAnimatedSpeech", id);
    });
    return done;
  };
  addFunction(*service, "say", speak, "Says a text and ends when it has been said.", text);
  addFunction(
      *service, "say", [speak](const std::string& words, const Value&) { return speak(words); },
      "Says a text and ends when it has been said.", text,
      Argument{"configuration", "Gestures; not made."});
  const auto mode = std::make_shared<std::uint32_t>(2);  // contextual
  const auto mode_names = std::make_shared<std::vector<std::string>>(
      std::vector<std::string>{"disabled", "random", "contextual"});
  addFunction(
      *service, "setBodyLanguageMode",
      [mode](std::uint32_t value) {
        if (value > 2) throw CallError("expected a mode of 0 to 2");
        *mode = value;
      },
      "Is kept.", Argument{"mode", "0 disabled, 1 random, 2 contextual."});
  addFunction(
      *service, "getBodyLanguageMode", [mode] { return *mode; }, "What was kept; 2 at first.");
  addFunction(
      *service, "setBodyLanguageModeFromStr",
      [mode, mode_names](const std::string& name) {
        const auto found = std::find(mode_names->begin(), mode_names->end(), name);
        if (found == mode_names->end()) throw CallError("unknown mode: " + name);
        *mode = static_cast<std::uint32_t>(found - mode_names->begin());
      },
      "Is kept.", Argument{"mode", "disabled, random or contextual."});
  addFunction(
      *service, "getBodyLanguageModeToStr", [mode, mode_names] { return mode_names->at(*mode); },
      "What was kept.");
  for (const char* what : {"BodyLanguageEnabled", "BodyTalkEnabled"}) {
    addFunction(
        *service, std::string("set") + what, [mode](bool on) { *mode = on ? 2 : 0; }, "Is kept.",
        Argument{"enable", "True: contextual, false: disabled."});
    addFunction(
        *service, std::string("is") + what, [mode] { return *mode != 0; }, "What was kept.");
  }
  for (const char* name : {"addTagsToWords", "declareTagForAnimations"}) {
    addFunction(
        *service, name, [](const Value&) {}, "Has no effect.", Argument{"tags", "Ignored."});
  }
  addFunction(
      *service, "declareAnimationsPackage", [](const std::string&) {}, "Has no effect.",
      Argument{"package", "Ignored."});
  service->allAnswering(rpc::Answer::Simplified);
  return service;
}

ServicePointer makeDialog(const ServiceContext& context, const Say& say) {
  auto service = makeModule("ALDialog", "Talks with people; there are none.");
  const auto extractor = std::make_shared<Extractor>(
      context.store(), "ALDialog",
      Extractor::Outputs{{"Dialog/LastInput", "Dialog/Answered", "Dialog/IsStarted"}, {}});
  extractor->declare(*service);
  service->owning(extractor);
  const auto language = std::make_shared<std::string>("English");
  addFunction(
      *service, "setLanguage", [language](const std::string& name) { *language = name; },
      "Is kept.", Argument{"language", "In English: French, German, ..."});
  addFunction(
      *service, "getLanguage", [language] { return *language; }, "What was kept.");
  const auto nothing = [] { return std::vector<std::string>(); };
  addFunction(*service, "getActivatedTopics", nothing, "None.");
  addFunction(*service, "getAllLoadedTopics", nothing, "None.");
  addFunction(
      *service, "tell", [say](const std::string& text) { say(text); }, "Says a text.",
      Argument{"text", "What to say."});
  for (const char* name : {"resetAll", "resetLanguage", "runDialog", "stopDialog", "closeSession",
                           "compileAll", "startPush", "stopPush", "clearConcepts"}) {
    addFunction(
        *service, name, [] {}, "Has no effect: nobody speaks.");
  }
  addFunction(
      *service, "openSession", [](std::int32_t) {}, "Has no effect.", Argument{"user", "Ignored."});
  addSettings(*service, documentedService("ALDialog"));
  service->allAnswering(rpc::Answer::Simplified);
  return service;
}

}  // namespace

std::vector<ServicePointer> makeAudioServices(const ServiceContext& context, const Say& say) {
  return {makeAlAudioPlayer(context),       makeAudioDevice(context),
          makeAudioRecorder(context),       makeSpeechRecognition(context),
          makeAnimatedSpeech(context, say), makeDialog(context, say)};
}

}  // namespace nao::services

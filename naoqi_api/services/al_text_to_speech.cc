#include "naoqi_api/services/al_text_to_speech.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "naoqi_api/call_error.h"

namespace nao::services {
namespace {

using rpc::CallError;

// The languages a Nao could be bought with. Nothing sounds, so all of them are installed.
struct Language {
  const char* name;
  const char* locale;
};
constexpr std::array<Language, 20> kLanguages = {{
    {"Arabic", "ar_SA"},   {"Brazilian", "pt_BR"}, {"Chinese", "zh_CN"}, {"Czech", "cs_CZ"},
    {"Danish", "da_DK"},   {"Dutch", "nl_NL"},     {"English", "en_US"}, {"Finnish", "fi_FI"},
    {"French", "fr_FR"},   {"German", "de_DE"},    {"Greek", "el_GR"},   {"Italian", "it_IT"},
    {"Japanese", "ja_JP"}, {"Korean", "ko_KR"},    {"Polish", "pl_PL"},  {"Portuguese", "pt_PT"},
    {"Russian", "ru_RU"},  {"Spanish", "es_ES"},   {"Swedish", "sv_SE"}, {"Turkish", "tr_TR"},
}};

// Names of real voices where they are known: naoenu, and Kenny22Enhanced of older robots.
constexpr char kOldEnglishVoice[] = "Kenny22Enhanced";

std::string defaultVoiceOf(const Language& language) {
  if (std::string(language.name) == "English") return "naoenu";
  return std::string("nao_") + language.locale;
}

const Language& languageNamed(const std::string& name) {
  const auto found = std::find_if(kLanguages.begin(), kLanguages.end(),
                                  [&](const Language& known) { return known.name == name; });
  if (found == kLanguages.end()) throw CallError("language " + name + " is not installed");
  return *found;
}

// The language a voice speaks.
const Language& languageOfVoice(const std::string& voice) {
  if (voice == kOldEnglishVoice) return languageNamed("English");
  for (const Language& language : kLanguages) {
    if (defaultVoiceOf(language) == voice) return language;
  }
  throw CallError("voice " + voice + " is not installed");
}

// The effects, and the range each takes (NAOqi 2.1.4.13 documentation, altexttospeech-api.html;
// pitch shifts below 1 and `speed` in percent came with later versions).
struct Parameter {
  const char* name;
  float initial, least, most;
};
constexpr std::array<Parameter, 10> kParameters = {{
    {"pitchShift", 0, 0, 4},
    {"doubleVoice", 0, 0, 4},
    {"doubleVoiceLevel", 0, 0, 4},
    {"doubleVoiceTimeShift", 0, 0, 0.5F},
    {"speed", 100, 0.5F, 400},
    {"pitch", 1, 0, 200},
    {"volume", 1, 0, 100},
    {"emph", 1, 0, 2},
    {"pauseMiddle", 150, 80, 300},
    {"pauseLong", 370, 300, 2000},
}};

const Parameter& parameterNamed(const std::string& name) {
  const auto found = std::find_if(kParameters.begin(), kParameters.end(),
                                  [&](const Parameter& known) { return known.name == name; });
  if (found == kParameters.end()) throw CallError("there is no parameter " + name);
  return *found;
}

std::string print(float number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", static_cast<double>(number));
  return text.data();
}

void checkRange(const std::string& what, float value, float least, float most) {
  if (value >= least && value <= most) return;  // false for NaN, too
  throw CallError(what + " must be from " + print(least) + " to " + print(most) + ", not " +
                  print(value));
}

// Percent; the Japanese voice counts in parts, 0.5 to 4.
double speedOf(float parameter) {
  constexpr float kMostAsPart = 4;
  return static_cast<double>(parameter <= kMostAsPart ? parameter : parameter / 100);
}

}  // namespace

AlTextToSpeech::AlTextToSpeech(memory::MemoryStore& memory, rpc::CallLater call_later,
                               SpeechQueue::Speak speak)
    : call_later_(call_later),
      speak_(speak),
      queue_(memory, std::move(call_later), std::move(speak)) {
  for (const Language& language : kLanguages) voices_[language.name] = defaultVoiceOf(language);
  for (const Parameter& parameter : kParameters) parameters_[parameter.name] = parameter.initial;
}

rpc::Pending<void> AlTextToSpeech::say(const std::string& text) {
  return queue_.add(text, speedOf(parameters_.at("speed")));
}

rpc::Pending<void> AlTextToSpeech::sayIn(const std::string& text, const std::string& language) {
  languageNamed(language);
  return say(text);
}

void AlTextToSpeech::setLanguage(const std::string& language) {
  language_ = languageNamed(language).name;
}

std::vector<std::string> AlTextToSpeech::getAvailableLanguages() {
  std::vector<std::string> names;
  for (const Language& language : kLanguages) names.emplace_back(language.name);
  return names;
}

std::string AlTextToSpeech::getLanguageEncoding(const std::string& language) {
  languageNamed(language);
  return "UTF-8";
}

voice::Manner AlTextToSpeech::manner() const {
  const float pitch = parameters_.at("pitchShift");
  return {languageNamed(language_).locale, speedOf(parameters_.at("speed")),
          pitch > 0 ? static_cast<double>(pitch) : 1.0};
}

std::string AlTextToSpeech::locale() { return languageNamed(language_).locale; }

// A voice speaks one language, so that changes with it.
void AlTextToSpeech::setVoice(const std::string& voice) {
  language_ = languageOfVoice(voice).name;
  voices_[language_] = voice;
}

std::vector<std::string> AlTextToSpeech::getAvailableVoices() {
  std::vector<std::string> voices = {kOldEnglishVoice};
  for (const Language& language : kLanguages) voices.push_back(defaultVoiceOf(language));
  return voices;
}

void AlTextToSpeech::setLanguageDefaultVoice(const std::string& language,
                                             const std::string& voice) {
  if (languageOfVoice(voice).name != std::string(languageNamed(language).name)) {
    throw CallError("voice " + voice + " does not speak " + language);
  }
  voices_[language] = voice;
}

// Of the preference files of a robot there are only the official ones, one per language.
void AlTextToSpeech::loadVoicePreference(const std::string& preference) {
  const std::string official = "NaoOfficialVoice";
  if (preference.rfind(official, 0) != 0) {
    throw CallError("there is no voice preference " + preference);
  }
  const Language& language = languageNamed(preference.substr(official.size()));
  language_ = language.name;
  voices_[language_] = defaultVoiceOf(language);
}

void AlTextToSpeech::setVolume(float volume) {
  checkRange("the volume", volume, 0, 1);
  volume_ = volume;
}

float AlTextToSpeech::getParameter(const std::string& name) {
  return parameters_.at(parameterNamed(name).name);
}

void AlTextToSpeech::setParameter(const std::string& name, float value) {
  const Parameter& parameter = parameterNamed(name);
  checkRange(name, value, parameter.least, parameter.most);
  parameters_[name] = value;
}

}  // namespace nao::services

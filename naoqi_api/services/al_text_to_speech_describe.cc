// The declaration of ALTextToSpeech: names and meanings as clients see them.

#include "naoqi_api/al_module.h"
#include "naoqi_api/services/al_text_to_speech.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;

Argument text() { return {"stringToSay", "The text, in UTF-8; it may hold voice tags."}; }
Argument language() { return {"language", "Its English name."}; }
Argument voice() { return {"voice", "Its name."}; }
Argument parameter() { return {"parameter", "Its name, e.g. pitchShift."}; }

}  // namespace

rpc::Service AlTextToSpeech::describe() {
  rpc::Service service = rpc::alModule("ALTextToSpeech", "Says texts; they are logged, not heard.");
  describeSpeaking(service);
  describeFiles(service);
  describeDictionary(service);
  describeLanguages(service);
  describeSound(service);
  return service;
}

void AlTextToSpeech::describeSpeaking(rpc::Service& service) {
  using Self = AlTextToSpeech;
  addMethod(service, "say", this, &Self::say, "Says a text; ends when it has been said.", text());
  addMethod(service, "say", this, &Self::sayIn, "Says a text in another language.", text(),
            language());
  addMethod(service, "stopAll", this, &Self::stopAll, "Stops what is said and what waits.");
  addMethod(service, "enableNotifications", this, &Self::setNotifications,
            "Has no effect: events are always raised.");
  addMethod(service, "disableNotifications", this, &Self::setNotifications,
            "Has no effect: events are always raised.");
}

void AlTextToSpeech::describeLanguages(rpc::Service& service) {
  using Self = AlTextToSpeech;
  addMethod(service, "getLanguage", this, &Self::getLanguage, "The language spoken.");
  addMethod(service, "setLanguage", this, &Self::setLanguage, "Changes the language.", language());
  addMethod(service, "getAvailableLanguages", this, &Self::getAvailableLanguages,
            "The languages that are installed.");
  addMethod(service, "getSupportedLanguages", this, &Self::getAvailableLanguages,
            "The languages that could be installed.");
  addMethod(service, "getLanguageEncoding", this, &Self::getLanguageEncoding,
            "How texts of a language are encoded.", language());
  addMethod(service, "locale", this, &Self::locale, "The language as xx_XX.");
  addMethod(service, "getVoice", this, &Self::getVoice, "The voice in use.");
  addMethod(service, "setVoice", this, &Self::setVoice,
            "Changes the voice, and the language to "
            "the one it speaks.",
            voice());
  addMethod(service, "getAvailableVoices", this, &Self::getAvailableVoices,
            "The voices that are installed.");
  addMethod(service, "setLanguageDefaultVoice", this, &Self::setLanguageDefaultVoice,
            "The voice to use for a language.", language(), voice());
  addMethod(service, "loadVoicePreference", this, &Self::loadVoicePreference,
            "Takes a voice and its effects from a file of the robot.",
            Argument{"preferenceName", "NaoOfficialVoiceEnglish, or of another language."});
}

void AlTextToSpeech::describeSound(rpc::Service& service) {
  using Self = AlTextToSpeech;
  addMethod(service, "getVolume", this, &Self::getVolume, "How loud the voice is.");
  addMethod(service, "setVolume", this, &Self::setVolume, "Changes how loud the voice is.",
            Argument{"volume", "0 to 1."});
  addMethod(service, "getParameter", this, &Self::getParameter, "An effect on the voice.",
            parameter());
  addMethod(service, "setParameter", this, &Self::setParameter, "Changes an effect on the voice.",
            parameter(), Argument{"value", "Its new value."});
}

}  // namespace nao::services

// ALTextToSpeech into files, and its dictionary.

#include <algorithm>

#include "naoqi_api/call_error.h"
#include "naoqi_api/services/al_text_to_speech.h"
#include "naoqi_api/services/data_files.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::CallError;

constexpr std::size_t kLongest = 4000;  // [bytes] of a text; free
constexpr std::size_t kPiece = 120;     // [bytes] spoken in one go: a fraction of a cycle; free
constexpr std::size_t kMostWords = 4096;

// Words, not voice tags: \tag=value\ and the like are left out.
std::string withoutTags(const std::string& text) {
  std::string words;
  bool in_tag = false;
  for (const char c : text) {
    if (c == '\\') {
      in_tag = !in_tag;
    } else if (!in_tag) {
      words += c;
    }
  }
  return words;
}

// The next piece of a text: up to a blank.
std::string takePiece(std::string& text) {
  std::size_t end = text.size();
  if (end > kPiece) {
    const std::size_t blank = text.rfind(' ', kPiece);
    end = blank == std::string::npos ? text.find(' ') : blank;
    end = end == std::string::npos ? text.size() : end + 1;
  }
  std::string piece = text.substr(0, end);
  text.erase(0, end);
  return piece;
}

}  // namespace

/// A text on its way into a file, piece by piece so that nobody waits for it.
struct AlTextToSpeech::FileSpeech {
  std::string text;  // still to be spoken
  std::string file;
  voice::Manner manner;
  Sound sound;
  rpc::Pending<void> done;
};

rpc::Pending<void> AlTextToSpeech::sayToFile(const std::string& text, const std::string& file) {
  if (text.size() > kLongest) throw CallError("the text is too long");
  dataPath(data_dir_, file);
  const auto speech = std::make_shared<FileSpeech>();
  *speech = {withoutTags(text), file, manner(), {}, {}};
  speakOn(speech);
  return speech->done;
}

void AlTextToSpeech::speakOn(const std::shared_ptr<FileSpeech>& speech) {
  if (speech->done.isDone()) return;
  const std::string piece = takePiece(speech->text);
  auto sound = voice::speak(piece, speech->manner);
  if (!sound) {  // no voice: as long, and silent
    const double length = toSeconds(calcSpokenText(piece, speech->manner.speed).length);
    sound = Sound::silence(length, speech->sound.rate, 1);
  }
  speech->sound.rate = sound->rate;
  auto& samples = speech->sound.samples;
  samples.insert(samples.end(), sound->samples.begin(), sound->samples.end());
  if (!speech->text.empty()) {
    return call_later_(Duration::zero(), [this, speech] { speakOn(speech); });
  }
  try {
    writeDataFile(data_dir_, speech->file, wavFile(speech->sound));
    speech->done.resolve();
  } catch (const CallError& error) {
    speech->done.fail(error.what());
  }
}

void AlTextToSpeech::describeFiles(rpc::Service& service) {
  using Self = AlTextToSpeech;
  const Argument text{"stringToSay", "The text, in UTF-8; voice tags are left out."};
  addMethod(service, "sayToFile", this, &Self::sayToFile,
            "Writes a text as sound into a WAV file below --data-dir: spoken by espeak-ng, or "
            "silent and as long where it is not there.",
            text, Argument{"fileName", "Its path."});
  addMethod(service, "sayToFileAndPlay", this, &Self::say, "As say; no file is left behind.", text);
  addMethod(service, "resetSpeed", this, &Self::resetSpeed, "Sets the speed to its default.");
}

bool AlTextToSpeech::addToDictionary(const std::string& word, const std::string& pronunciation) {
  if (dictionary_.size() >= kMostWords) throw CallError("the dictionary is full");
  return dictionary_.insert_or_assign(word, pronunciation).second;
}

void AlTextToSpeech::describeDictionary(rpc::Service& service) {
  using Self = AlTextToSpeech;
  using rpc::Answer;
  const Argument word{"word", "As it is written."};
  const Argument pronunciation{"pronunciation", "In the voice's own letters; is kept."};
  addMethod(service, "addToDictionary", this, &Self::addToDictionary,
            "Keeps a pronunciation; no voice here knows these letters.", word, pronunciation)
      .answering(Answer::Simplified);
  addFunction(
      service, "addToDictionary",
      [this](const std::string&, const std::string& written, const std::string&,
             const std::string& phonetic,
             const std::string&) { return addToDictionary(written, phonetic); },
      "Keeps a pronunciation; no voice here knows these letters.", Argument{"type", "Ignored."},
      word, Argument{"priority", "Ignored."}, pronunciation, Argument{"accent", "Ignored."})
      .answering(Answer::Simplified);
  addMethod(service, "deleteFromDictionary", this, &Self::deleteFromDictionary,
            "Forgets a pronunciation; whether there was one.", word);
  addFunction(
      service, "deleteFromDictionary",
      [this](const std::string&, const std::string& written) {
        return deleteFromDictionary(written);
      },
      "Forgets a pronunciation; whether there was one.", Argument{"type", "Ignored."}, word);
  addFunction(
      service, "showDictionary",
      [this] {
        for (const auto& [written, phonetic] : dictionary_) {
          speak_("(dictionary) " + written + " = " + phonetic);
        }
      },
      "Logs the pronunciations.");
}

}  // namespace nao::services

#pragma once

#include <string>

#include <boost/shared_ptr.hpp>

#include <alcommon/almodule.h>
#include <alcommon/alproxy.h>
#include <alvalue/alvalue.h>
#include <usarnaoqi_sdk/export.h>

typedef short AL_SOUND_FORMAT;  // a sample

namespace AL {

/// Whose sound a module asks ALAudioDevice for (setClientPreferences).
enum { ALLCHANNELS = 0, LEFTCHANNEL = 1, RIGHTCHANNEL = 2, FRONTCHANNEL = 3, REARCHANNEL = 4 };

/// A module that hears what the robot's microphones do. The robots here hear nothing: such a module
/// is subscribed and never called by them, as in a room without a sound; other clients may play
/// ALAudioDevice and call its processRemote.
class USARNAOQI_SDK_API ALSoundExtractor : public ALModule {
 public:
  /// @throws ALError as ALModule does.
  ALSoundExtractor(boost::shared_ptr<ALBroker> broker, std::string name);
  virtual ~ALSoundExtractor();

  /// Subscribes to ALAudioDevice under its name, and leaves it again.
  virtual void startDetection();
  virtual void stopDetection();

  /// Called with a piece of sound: signed 16 bit, one channel after the other or in turn, as
  /// setClientPreferences asked. Without an override it goes to processSound().
  virtual void process(const int& channels, const int& samples_per_channel,
                       const AL_SOUND_FORMAT* buffer, const ALValue& time_stamp);
  /// The same as NAOqi 1.x had it.
  virtual void processSound(const int channels, const int samples_per_channel,
                            const AL_SOUND_FORMAT* buffer);

  /// What is called over the wire; the samples are a binary value. @throws ALError if it is none,
  /// or shorter than said.
  virtual void processRemote(const int& channels, const int& samples_per_channel,
                             const ALValue& time_stamp, const ALValue& buffer);
  virtual void processSoundRemote(const int& channels, const int& samples_per_channel,
                                  const ALValue& buffer);

  void setDebugMode(const bool& on = true) { fbDebugMode = on; }
  bool getDebugMode() { return fbDebugMode; }

 protected:
  bool fIsRunning;  // subscribed
  bool fbDebugMode;
  boost::shared_ptr<ALProxy> audioDevice;
  ALValue fNullTimestamp;
};

}  // namespace AL

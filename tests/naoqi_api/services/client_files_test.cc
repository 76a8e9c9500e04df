#include <fstream>

#include "naoqi_api/voice/voice.h"
#include "tests/core/temporary_folder.h"
#include "tests/naoqi_api/services/services_bench.h"

namespace nao::services {
namespace {

using rpc::Value;

/// Services whose clients may keep files.
class ClientFiles : TemporaryFolder, public ServicesBench {
 protected:
  ClientFiles() : ServicesBench(TemporaryFolder::path()) {}

  std::string content(const std::string& name) const {
    std::ifstream file(data_dir_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::string openWindow(int space) {
    return call("ALVideoDevice", "subscribeCamera", {"test", 0, 0, space, 30}).to<std::string>();
  }
  // A picture of one colour in place of the top camera's.
  Value putPicture(unsigned char red, unsigned char green, unsigned char blue) {
    rpc::Bytes bytes;
    for (int i = 0; i < 4 * 2; ++i) bytes.insert(bytes.end(), {red, green, blue});
    return call("ALVideoDevice", "putImage", {0, 4, 2, Value::raw(bytes)});
  }
};

TEST_F(ClientFiles, ARecordingIsAsLongAsTheTimeItTook) {
  const std::string name = "/home/nao/recordings/sound.wav";
  call("ALAudioDevice", "startMicrophonesRecording", {name});
  run(0.5);
  call("ALAudioDevice", "stopMicrophonesRecording");
  EXPECT_NEAR(static_cast<double>(content(name.substr(1)).size()), 44 + 0.5 * 48000 * 4 * 2, 8000);
  call("ALAudioPlayer", "loadFile", {name});
  EXPECT_NEAR(number(call("ALAudioPlayer", "getFileLength", {1})), 0.5, 0.02);
}

TEST_F(ClientFiles, NoRecordingLeadsOutOfTheFolder) {
  const auto refused =
      call("ALAudioDevice", "startMicrophonesRecording", {"../../outside.wav"}).print();
  EXPECT_NE(refused.find("leads out"), std::string::npos) << refused;
}

TEST_F(ClientFiles, ATextIsSpokenIntoAFile) {
  call("ALTextToSpeech", "sayToFile", {"Hello, I am a robot and I can say a few words.", "a.wav"});
  const std::string file = content("a.wav");
  ASSERT_GT(file.size(), 44U + 16000U);
  EXPECT_EQ(file.substr(0, 4), "RIFF");
  if (!voice::speak("hello", {})) GTEST_SKIP() << "there is no voice";
  EXPECT_NE(file.find_first_not_of('\0', 44), std::string::npos);  // it is heard
}

TEST_F(ClientFiles, APictureThatAClientPutsIsWhatAllSee) {
  const std::string window = openWindow(11);
  EXPECT_EQ(putPicture(10, 200, 30), Value(true));
  const Value image = call("ALVideoDevice", "getImageRemote", {window});
  const auto bytes = image.findItems()->at(6).findBytes();
  ASSERT_EQ(bytes->size(), 160U * 120U * 3U);
  EXPECT_EQ((*bytes)[0], 10);
  EXPECT_EQ((*bytes)[bytes->size() - 2], 200);
  EXPECT_EQ(call("ALVideoDevice", "putImage", {0, 5, 2, Value::raw({1, 2, 3})}), Value(false));
  EXPECT_EQ(call("ALVideoDevice", "putImage", {0, 0, 0, Value::raw({})}), Value(true));
}

TEST_F(ClientFiles, PicturesAreRecorded) {
  const std::string window = openWindow(11);
  putPicture(1, 2, 3);
  EXPECT_EQ(call("ALVideoDevice", "recordVideo", {window, "film/a", 2, 1}), Value(true));
  cycle();
  putPicture(4, 5, 6);
  cycle();
  EXPECT_EQ(content("film/a_0000.ppm").substr(0, 2), "P6");
  EXPECT_EQ(content("film/a_0001.ppm").size(), content("film/a_0000.ppm").size());
  EXPECT_EQ(call("ALVideoDevice", "stopVideo", {window}), Value(false));  // ended by itself
}

TEST_F(ClientFiles, ACameraThatIsOffShowsNothingUntilSomebodyLooks) {
  const std::string window = openWindow(11);
  putPicture(1, 2, 3);
  EXPECT_EQ(call("ALVideoDevice", "stopCamera", {0}), Value(true));
  EXPECT_EQ(call("ALVideoDevice", "isCameraStarted", {0}), Value(false));
  EXPECT_TRUE(call("ALVideoDevice", "getImageRemote", {window}).isVoid());
  openWindow(11);
  EXPECT_EQ(call("ALVideoDevice", "isCameraStarted", {0}), Value(true));
}

TEST_F(ClientFiles, AParametersInfoHoldsItsRangeAndValue) {
  call("ALVideoDevice", "setParameter", {0, 1, 40});
  EXPECT_EQ(call("ALVideoDevice", "getParameterInfo", {0, 1}), Value::list({16, 64, 32, 40}));
}

}  // namespace
}  // namespace nao::services

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "camera/image_feed.h"
#include "core/robot_model.h"
#include "core/sim_time.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// NaoQi's ALVideoDevice: clients open windows on the robot's cameras and fetch pictures from
/// them. Pictures come through an ImageFeed, drawn elsewhere; a call that asks before the first
/// one is there ends when it comes. A window closes with the client that opened it. I/O thread.
class AlVideoDevice {
 public:
  /// @param epoch NaoQi's clock at the start of the world, since 1970: stamps are epoch + time
  AlVideoDevice(std::shared_ptr<const RobotModel> robot, std::shared_ptr<camera::ImageFeed> feed,
                Duration epoch);

  /// The service; this object must outlive it.
  rpc::Service describe();

  /// What it needs for pictures that clients put and record: the simulated time, and the folder
  /// below which files are written. Without, such pictures bear time 0 and nothing is recorded.
  void connect(std::function<SimTime()> now, std::filesystem::path data_dir);

  /// NAOqi 1.x: the first window of a name bears it as it is, the second is name_2.
  void nameFirstWindowAsAsked() { numbers_first_ = false; }

  /// What getImageRemote answers, or getDirectRawImageRemote.
  rpc::Pending<rpc::Value> picture(const std::string& handle, bool raw) {
    return raw ? getDirectRawImage(handle) : getImageRemote(handle);
  }

  /// Ends the getImageRemote calls whose first picture has come. To be called whenever pictures
  /// may have been drawn.
  void deliverImages();

  /// Most windows of one name, and in all.
  static constexpr std::size_t kMostOfOneName = 8;
  static constexpr std::size_t kMost = 256;

 private:
  /// How a client looks at one camera.
  struct Window {
    int camera = 0;
    int resolution = 0;  // NaoQi's number
    int frame_rate = 0;  // [1/s] as offered by the camera
    camera::ColorSpace color_space = camera::ColorSpace::kYUV422;
    bool follows_active = false;     // NaoQi 1.x: shows whichever camera is active
    std::uint64_t session = 0;       // of the client; 0: none
    std::uint64_t subscription = 0;  // in the feed
    std::uint64_t raw = 0;           // there: the same as the sensor gives it; 0: nobody asked
    std::vector<rpc::Pending<rpc::Value>> waiting;
    std::vector<rpc::Pending<rpc::Value>> waiting_raw;
  };
  using Waiting = std::vector<rpc::Pending<rpc::Value>>;
  using Picture = std::shared_ptr<const camera::Image>;

  // Windows
  std::string subscribeCamera(const rpc::Caller& caller, const std::string& name, int camera,
                              int resolution, int color_space, int frame_rate);
  std::string subscribe(const rpc::Caller& caller, const std::string& name, int resolution,
                        int color_space, int frame_rate);
  std::string open(const rpc::Caller& caller, const std::string& name,
                   const std::optional<Window>& window);
  bool unsubscribe(const std::string& handle);
  void unsubscribeAllInstances(const std::string& name);
  rpc::Value getSubscribers() const;
  rpc::Pending<rpc::Value> getImageRemote(const std::string& handle);
  rpc::Pending<rpc::Value> getDirectRawImage(const std::string& handle);
  bool releaseImage(const std::string& handle) const;

  int getCamera(const std::string& handle) const;
  int getResolution(const std::string& handle) const;
  int getColorSpace(const std::string& handle) const;
  int getFrameRate(const std::string& handle) const;
  bool setCamera(const std::string& handle, int camera);
  bool setResolution(const std::string& handle, int resolution);
  bool setColorSpace(const std::string& handle, int color_space);
  bool setFrameRate(const std::string& handle, int frame_rate);

  // Cameras
  int getActiveCamera() const { return active_camera_; }
  bool setActiveCamera(int camera);
  rpc::Value getCameraIndexes() const;
  std::string getCameraName(int camera) const;
  int getCameraModel(int camera) const;
  float getHorizontalFov(int camera) const;
  float getVerticalFov(int camera) const;
  int getCameraResolution(int camera) const;
  int getCameraColorSpace(int camera) const;
  int getCameraFrameRate(int camera) const;
  bool isCameraOn(int camera) const { return isCamera(camera) && closed_.count(camera) == 0; }
  bool isCameraOff(int camera) const { return !isCameraOn(camera); }
  bool turnCameraOn(int camera);
  bool turnCameraOff(int camera);
  bool hasDepthCamera() const { return false; }
  rpc::Value resolutionToSizes(int resolution) const;
  int sizesToResolution(int width, int height) const;

  // Parameters
  int getParameter(int camera, int parameter) const;
  bool setParameter(int camera, int parameter, int value);
  bool setParameterToDefault(int camera, int parameter);
  bool setAllParametersToDefault(int camera);
  rpc::Value getParameterRange(int camera, int parameter) const;
  int getCameraParameter(const std::string& handle, int parameter) const;
  bool setCameraParameter(const std::string& handle, int parameter, int value);
  bool setCameraParameterToDefault(const std::string& handle, int parameter);
  bool setAllCameraParametersToDefault(const std::string& handle);
  rpc::Value getCameraParameterRange(const std::string& handle, int parameter) const;
  int getParam(int parameter) const;
  void setParam(int parameter, int value);
  void setParamOf(int parameter, int value, int camera) { setParameter(camera, parameter, value); }
  int getParamOf(int parameter, int camera) const { return getParameter(camera, parameter); }
  void setParamDefault(int parameter);

  // Several cameras in one window
  std::string subscribeCameras(const rpc::Caller& caller, const std::string& name,
                               const rpc::Value& cameras, const rpc::Value& resolutions,
                               const rpc::Value& color_spaces, int frame_rate);
  bool unsubscribeAny(const std::string& name);
  using ImageGetter = rpc::Pending<rpc::Value> (AlVideoDevice::*)(const std::string&);
  rpc::Pending<rpc::Value> getSeveral(const std::string& name, ImageGetter get);
  const std::vector<std::string>& windowsOf(const std::string& name) const;  // @throws CallError

  // Pictures that a client puts in place of the camera's, and files of pictures
  bool putImage(const rpc::Caller& caller, int camera, int width, int height,
                const rpc::Value& bytes);
  bool setInputSize(int width, int height);
  rpc::Value getExpectedImageParameters(int camera) const;
  bool recordVideo(const std::string& handle, const std::string& path, int count, int period);
  bool stopVideo(const std::string& handle) { return recordings_.erase(handle) > 0; }
  void recordDue();
  rpc::Value getParameterInfo(int camera, int parameter) const;

  void describeSimulator(rpc::Service& service);
  void describeFiles(rpc::Service& service);
  void describeMore(rpc::Service& service);
  void describeGeometry(rpc::Service& service);
  void describeSeveral(rpc::Service& service);
  void describeSeveralSettings(rpc::Service& service);
  void describeOldNames(rpc::Service& service);
  void describeWindows(rpc::Service& service);
  void describeWindowSettings(rpc::Service& service);
  void describeCameras(rpc::Service& service);
  void describeParameters(rpc::Service& service);
  void describeWindowParameters(rpc::Service& service);

  bool isCamera(int camera) const;
  const CameraModel& cameraOf(int camera) const;  // @throws CallError
  const camera::SensorType& sensorOf(int camera) const;
  const camera::ParameterRange& parameterOf(int camera, int id) const;  // @throws CallError
  Window* findWindow(const std::string& handle);
  const Window* findWindow(const std::string& handle) const;
  const Window& windowOf(const std::string& handle) const;  // @throws CallError
  std::optional<Window> makeWindow(int camera, int resolution, int color_space,
                                   int frame_rate) const;
  std::vector<std::string> handles() const;
  std::string freeHandle(const std::string& name) const;
  std::string handleOf(const std::string& name, std::size_t number) const;
  void watch(const std::shared_ptr<rpc::Session>& session);
  void closeWindowsOf(std::uint64_t session);
  void startSubscription(Window& window);
  bool turn(const std::string& handle, int camera);
  bool replace(const std::string& handle, const std::optional<Window>& changed);
  rpc::Value toReply(const camera::Image& image) const;
  rpc::Pending<rpc::Value> replyWith(const Picture& picture, Waiting& waiting) const;
  void closeFeeds(const Window& window);
  Picture pictureOf(const Window& window) const;
  Picture rawPictureOf(const Window& window) const;
  Picture putPicture(const Window& window, camera::ColorSpace space) const;  // or null

  struct PutImage {
    camera::ImageSize size;
    camera::Bytes rgb;
    SimTime time{};
    std::uint64_t session = 0;  // of the client that put it
  };
  struct Recording {
    std::string path;
    int left = 0;    // pictures still to write
    int period = 1;  // every how many of the window's pictures
    int seen = 0;
    int written = 0;
    SimTime last{};
  };

  std::shared_ptr<const RobotModel> robot_;
  std::shared_ptr<camera::ImageFeed> feed_;
  Duration epoch_;
  std::map<std::string, Window> windows_;                    // by handle
  std::map<std::string, std::vector<std::string>> several_;  // handles, by that of them all
  std::vector<camera::CameraSettings> settings_;             // by camera
  std::set<std::uint64_t> watched_sessions_;
  int active_camera_ = 0;
  bool numbers_first_ = true;
  std::set<int> closed_;                         // cameras
  std::map<int, PutImage> put_;                  // by camera
  camera::ImageSize input_size_;                 // of pictures to put; none: any
  std::map<std::string, Recording> recordings_;  // by handle
  std::function<SimTime()> now_ = [] { return SimTime{}; };
  std::filesystem::path data_dir_;
  std::shared_ptr<AlVideoDevice*> alive_ = std::make_shared<AlVideoDevice*>(this);
};

}  // namespace nao::services

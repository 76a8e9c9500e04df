// Writes a film: usarnaoqi-encode FILE.mp4 WIDTH HEIGHT FPS, pictures on its standard input, four
// bytes a pixel: red, green, blue, nothing. A program of its own, so that OpenCV and the two
// hundred libraries that it brings are loaded by those alone who want a film.
#include <cstdio>
#include <cstdlib>
#include <opencv2/videoio.hpp>
#include <string>
#include <vector>

namespace {

// H.264 where the library has it, for every browser plays that; else MPEG-4.
bool open(cv::VideoWriter& writer, const std::string& file, double fps, cv::Size size) {
  for (const char* code : {"avc1", "mp4v"}) {
    const int fourcc = cv::VideoWriter::fourcc(code[0], code[1], code[2], code[3]);
    if (writer.open(file, cv::CAP_FFMPEG, fourcc, fps, size)) return true;
  }
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fprintf(stderr, "usage: usarnaoqi-encode FILE.mp4 WIDTH HEIGHT FPS < pictures\n");
    return 2;
  }
  const cv::Size size(std::atoi(argv[2]), std::atoi(argv[3]));
  cv::VideoWriter writer;
  const bool opened = open(writer, argv[1], std::atof(argv[4]), size);
  const auto pixels = static_cast<std::size_t>(size.area());
  std::vector<unsigned char> rgbx(4 * pixels);
  cv::Mat bgr(size, CV_8UC3);
  while (std::fread(rgbx.data(), 1, rgbx.size(), stdin) == rgbx.size()) {
    if (!opened) continue;  // who writes must not meet a closed pipe
    for (std::size_t i = 0; i < pixels; ++i) {
      for (std::size_t k = 0; k < 3; ++k) bgr.data[3 * i + k] = rgbx[4 * i + 2 - k];
    }
    writer.write(bgr);
  }
  return opened ? 0 : 1;
}

#include "motion/timeline/gunzip.h"

#include <zlib.h>

#include <array>

namespace nao::motion {
namespace {

constexpr std::size_t kMost = std::size_t{64} << 20;  // [bytes] no behavior is larger
constexpr int kGzipOnly = 16 + MAX_WBITS;             // zlib's way to ask for the gzip wrapper

// One inflation, ended whatever happens.
class Inflation {
 public:
  explicit Inflation(const std::string& bytes) {
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream_.avail_in = static_cast<uInt>(bytes.size());
    if (inflateInit2(&stream_, kGzipOnly) != Z_OK) throw GzipError("out of memory");
  }
  ~Inflation() { inflateEnd(&stream_); }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;

  std::string run() {
    std::string out;
    std::array<char, 1 << 16> piece;
    for (int status = Z_OK; status != Z_STREAM_END;) {
      stream_.next_out = reinterpret_cast<Bytef*>(piece.data());
      stream_.avail_out = static_cast<uInt>(piece.size());
      status = inflate(&stream_, Z_NO_FLUSH);
      if (status != Z_OK && status != Z_STREAM_END) {
        throw GzipError(stream_.msg ? stream_.msg : "it ends too early");
      }
      out.append(piece.data(), piece.size() - stream_.avail_out);
      if (out.size() > kMost) throw GzipError("it unpacks to more than 64 MiB");
    }
    return out;
  }

 private:
  z_stream stream_{};
};

}  // namespace

std::string gunzip(const std::string& bytes) { return Inflation(bytes).run(); }

}  // namespace nao::motion

#include "motion/timeline/gunzip.h"

#include <array>
#include <cstdint>
#include <vector>

namespace nao::motion {
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20;  // free choice: a behavior with its media

// Numbers of RFC 1951, section 3.2.
constexpr int kLongestCode = 15;
constexpr std::array<int, 29> kLengthBase = {3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                             15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                             67, 83, 99, 115, 131, 163, 195, 227, 258};
constexpr std::array<int, 29> kLengthBits = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                             2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
constexpr std::array<int, 30> kDistanceBase = {
    1,   2,   3,   4,   5,   7,    9,    13,   17,   25,   33,   49,   65,    97,    129,
    193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
constexpr std::array<int, 30> kDistanceBits = {0, 0, 0, 0, 1, 1, 2, 2,  3,  3,  4,  4,  5,  5,  6,
                                               6, 7, 7, 8, 8, 9, 9, 10, 10, 11, 11, 12, 12, 13, 13};
constexpr std::array<std::size_t, 19> kCodeOrder = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                    11, 4,  12, 3, 13, 2, 14, 1, 15};

// Bits from the lowest of each byte on.
class Bits {
 public:
  Bits(const std::string& bytes, std::size_t at) : bytes_(bytes), at_(at) {}

  std::uint8_t byte() {
    if (at_ >= bytes_.size()) throw GzipError("the data end too early");
    return static_cast<std::uint8_t>(bytes_[at_++]);
  }
  int bit() {
    if (left_ == 0) {
      held_ = byte();
      left_ = 8;
    }
    --left_;
    const int value = held_ & 1;
    held_ >>= 1;
    return value;
  }
  int number(int bits) {
    int value = 0;
    for (int i = 0; i < bits; ++i) value |= bit() << i;
    return value;
  }
  std::uint32_t bytes4() {
    std::uint32_t value = 0;
    for (unsigned i = 0; i < 4; ++i) value |= std::uint32_t{byte()} << (8 * i);
    return value;
  }
  void dropRestOfByte() { left_ = 0; }

 private:
  const std::string& bytes_;
  std::size_t at_;
  int held_ = 0;
  int left_ = 0;  // bits of held_
};

// A canonical prefix code: how many codes each length has, and their symbols in order.
class PrefixCode {
 public:
  explicit PrefixCode(const std::vector<int>& lengths) {
    for (const int length : lengths) ++count_[static_cast<std::size_t>(length)];
    count_[0] = 0;
    int left = 1;  // codes of this length that are still free
    for (std::size_t i = 1; i <= kLongestCode; ++i) {
      left = 2 * left - count_[i];
      if (left < 0) throw GzipError("more codes than there can be");
    }
    std::array<std::size_t, kLongestCode + 2> next{};
    for (std::size_t i = 1; i <= kLongestCode; ++i) {
      next[i + 1] = next[i] + static_cast<std::size_t>(count_[i]);
    }
    symbols_.resize(lengths.size());
    for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
      const auto length = static_cast<std::size_t>(lengths[symbol]);
      if (length > 0) symbols_[next[length]++] = static_cast<int>(symbol);
    }
  }

  int read(Bits& bits) const {
    int code = 0, first = 0, passed = 0;
    for (std::size_t length = 1; length <= kLongestCode; ++length) {
      code |= bits.bit();
      if (code - first < count_[length]) {
        return symbols_[static_cast<std::size_t>(passed + code - first)];
      }
      passed += count_[length];
      first = (first + count_[length]) << 1;
      code <<= 1;
    }
    throw GzipError("a code means nothing");
  }

 private:
  std::array<int, kLongestCode + 1> count_{};
  std::vector<int> symbols_;
};

class Inflater {
 public:
  explicit Inflater(Bits& bits) : bits_(bits) {}

  std::string run() {
    for (bool last = false; !last;) {
      last = bits_.bit() == 1;
      switch (bits_.number(2)) {
        case 0:
          copyStored();
          break;
        case 1:
          readFixed();
          break;
        case 2:
          readDynamic();
          break;
        default:
          throw GzipError("a block of an unknown kind");
      }
    }
    bits_.dropRestOfByte();
    return std::move(out_);
  }

 private:
  void put(char c) {
    if (out_.size() >= kMostBytes) throw GzipError("more than 64 MiB");
    out_ += c;
  }

  void copyStored() {
    bits_.dropRestOfByte();
    const int length = bits_.number(16);
    if ((bits_.number(16) ^ 0xffff) != length) throw GzipError("a stored block has no length");
    for (int i = 0; i < length; ++i) put(static_cast<char>(bits_.byte()));
  }

  void readFixed() {
    std::vector<int> lengths(288, 8);
    for (std::size_t i = 144; i < 256; ++i) lengths[i] = 9;
    for (std::size_t i = 256; i < 280; ++i) lengths[i] = 7;
    readBlock(PrefixCode(lengths), PrefixCode(std::vector<int>(30, 5)));
  }

  void readDynamic() {
    const int literals = bits_.number(5) + 257;
    const int distances = bits_.number(5) + 1;
    const int codes = bits_.number(4) + 4;
    std::vector<int> lengths(kCodeOrder.size(), 0);
    for (int i = 0; i < codes; ++i) {
      lengths[kCodeOrder[static_cast<std::size_t>(i)]] = bits_.number(3);
    }
    const auto all =
        readLengths(PrefixCode(lengths), static_cast<std::size_t>(literals + distances));
    readBlock(PrefixCode({all.begin(), all.begin() + literals}),
              PrefixCode({all.begin() + literals, all.end()}));
  }

  std::vector<int> readLengths(const PrefixCode& code, std::size_t count) {
    std::vector<int> lengths;
    while (lengths.size() < count) {
      const int symbol = code.read(bits_);
      if (symbol < 16) {
        lengths.push_back(symbol);
        continue;
      }
      if (symbol == 16 && lengths.empty()) throw GzipError("a length repeats nothing");
      const int value = symbol == 16 ? lengths.back() : 0;
      const int times = symbol == 16   ? 3 + bits_.number(2)
                        : symbol == 17 ? 3 + bits_.number(3)
                                       : 11 + bits_.number(7);
      lengths.insert(lengths.end(), static_cast<std::size_t>(times), value);
    }
    if (lengths.size() != count) throw GzipError("too many code lengths");
    return lengths;
  }

  void readBlock(const PrefixCode& literals, const PrefixCode& distances) {
    for (;;) {
      const int symbol = literals.read(bits_);
      if (symbol == 256) return;
      if (symbol < 256) {
        put(static_cast<char>(symbol));
        continue;
      }
      const auto l = static_cast<std::size_t>(symbol - 257);
      if (l >= kLengthBase.size()) throw GzipError("a length means nothing");
      const int length = kLengthBase[l] + bits_.number(kLengthBits[l]);
      const auto d = static_cast<std::size_t>(distances.read(bits_));
      if (d >= kDistanceBase.size()) throw GzipError("a distance means nothing");
      const auto back = static_cast<std::size_t>(kDistanceBase[d] + bits_.number(kDistanceBits[d]));
      if (back > out_.size()) throw GzipError("a distance before the beginning");
      for (int i = 0; i < length; ++i) put(out_[out_.size() - back]);
    }
  }

  Bits& bits_;
  std::string out_;
};

// RFC 1952, section 8: the polynomial 0xedb88320, bit by bit.
std::uint32_t crcOf(const std::string& bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const char c : bytes) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int i = 0; i < 8; ++i) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
  }
  return ~crc;
}

// Over the header of RFC 1952, section 2.3.
void skipHeader(Bits& bits) {
  if (bits.byte() != 0x1f || bits.byte() != 0x8b || bits.byte() != 8) throw GzipError("no gzip");
  const int flags = bits.byte();
  for (int i = 0; i < 6; ++i) bits.byte();  // time, extra flags, system
  if ((flags & 4) != 0) {
    const int extra = bits.number(16);
    for (int i = 0; i < extra; ++i) bits.byte();
  }
  for (const int text : {8, 16}) {  // name, comment
    while ((flags & text) != 0 && bits.byte() != 0) {
    }
  }
  if ((flags & 2) != 0) bits.number(16);  // header CRC
}

}  // namespace

std::string gunzip(const std::string& bytes) {
  Bits bits(bytes, 0);
  skipHeader(bits);
  std::string out = Inflater(bits).run();
  if (bits.bytes4() != crcOf(out)) throw GzipError("the checksum is wrong");
  if (bits.bytes4() != static_cast<std::uint32_t>(out.size())) {
    throw GzipError("the length is wrong");
  }
  return out;
}

}  // namespace nao::motion

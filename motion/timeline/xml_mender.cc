#include "motion/timeline/xml_mender.h"

#include <algorithm>
#include <cctype>
#include <optional>

namespace nao::motion {
namespace {

// What is copied as it is, from one sign to the other.
struct Verbatim {
  const char* begin;
  const char* end;
};
constexpr Verbatim kVerbatim[] = {{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}, {"<!", ">"}};

bool isBlank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

bool isName(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return std::isalnum(byte) != 0 || byte >= 0x80 ||
         std::string("_:-.").find(c) != std::string::npos;
}

class Mender {
 public:
  explicit Mender(const std::string& text) : text_(text) {}

  MendedXml mend() {
    while (at_ < text_.size()) {
      if (text_[at_] != '<') {
        copyTo(std::min(text_.find('<', at_), text_.size()));
      } else if (!copyVerbatim()) {
        text_.compare(at_, 2, "</") == 0 ? readEnd() : readStart();
      }
    }
    if (!open_.empty()) {
      tell(line_, "the text ends within the <" + open_.back().name + "> of line " +
                      std::to_string(open_.back().line));
    }
    while (!open_.empty()) closeLast();
    return std::move(mended_);
  }

 private:
  struct Open {
    std::string name;
    int line;
  };

  void copyTo(std::size_t end) {
    for (; at_ < end; ++at_) {
      line_ += text_[at_] == '\n' ? 1 : 0;
      mended_.text += text_[at_];
    }
  }
  // Only the ends of lines stay, so that lines keep their numbers.
  void dropTo(std::size_t end) {
    for (; at_ < end; ++at_) {
      if (text_[at_] != '\n') continue;
      ++line_;
      mended_.text += '\n';
    }
  }
  void tell(int line, const std::string& sentence) { mended_.breaks.push_back({line, sentence}); }

  void closeLast() {
    mended_.text += "</" + open_.back().name + ">";
    open_.pop_back();
  }

  void closeForgotten() {
    tell(open_.back().line, "<" + open_.back().name + "> is not closed");
    closeLast();
  }

  bool copyVerbatim() {
    for (const Verbatim& part : kVerbatim) {
      const std::string begin = part.begin, sign = part.end;
      if (text_.compare(at_, begin.size(), begin) != 0) continue;
      const auto end = text_.find(sign, at_ + begin.size());
      if (end != std::string::npos) {
        copyTo(end + sign.size());
      } else {
        tell(line_, begin + " has no " + sign + "; all from here on is left out");
        dropTo(text_.size());
      }
      return true;
    }
    return false;
  }

  std::size_t endOfName(std::size_t at) const {
    while (at < text_.size() && isName(text_[at])) ++at;
    return at;
  }
  std::size_t afterBlanks(std::size_t at) const {
    while (at < text_.size() && isBlank(text_[at])) ++at;
    return at;
  }

  void readEnd() {
    const std::size_t end_of_name = endOfName(at_ + 2);
    const std::string name = text_.substr(at_ + 2, end_of_name - at_ - 2);
    const std::size_t end = afterBlanks(end_of_name);
    const bool whole = end < text_.size() && text_[end] == '>';
    const auto named = [&](const Open& o) { return o.name == name; };
    if (std::none_of(open_.begin(), open_.end(), named)) {
      tell(line_, "</" + name + "> ends what is not open; it is left out");
      return dropTo(whole ? end + 1 : std::min(text_.find('<', at_ + 1), text_.size()));
    }
    while (open_.back().name != name) closeForgotten();
    if (!whole) tell(line_, "</" + name + " has no >");
    dropTo(whole ? end + 1 : end_of_name);
    mended_.text += "</" + name + ">";
    open_.pop_back();
  }

  // Behind `name = "value"`, or nothing if that is not what stands there.
  std::optional<std::size_t> endOfAttribute(std::size_t at) const {
    const std::size_t end_of_name = endOfName(at);
    std::size_t next = afterBlanks(end_of_name);
    if (end_of_name == at || next >= text_.size() || text_[next] != '=') return std::nullopt;
    next = afterBlanks(next + 1);
    if (next >= text_.size() || (text_[next] != '"' && text_[next] != '\'')) return std::nullopt;
    const std::size_t quote = text_.find(text_[next], next + 1);
    if (quote == std::string::npos || text_.find('<', next) < quote) return std::nullopt;
    return quote + 1;
  }

  // Behind a start tag; nothing if it is not well-formed.
  std::optional<std::size_t> endOfStart(std::size_t at) const {
    while (at < text_.size()) {
      const std::size_t next = afterBlanks(at);
      if (text_.compare(next, 1, ">") == 0) return next + 1;
      if (text_.compare(next, 2, "/>") == 0) return next + 2;
      const auto attribute = next > at ? endOfAttribute(next) : std::nullopt;
      if (!attribute) return std::nullopt;
      at = *attribute;
    }
    return std::nullopt;
  }

  void readStart() {
    const std::size_t end_of_name = endOfName(at_ + 1);
    const std::string name = text_.substr(at_ + 1, end_of_name - at_ - 1);
    const auto end = name.empty() ? std::nullopt : endOfStart(end_of_name);
    if (!end) {
      tell(line_, "the tag <" + name + " is not well-formed; it is left out");
      return dropTo(std::min(text_.find('<', at_ + 1), text_.size()));
    }
    if (!open_.empty() && open_.back().name == name) closeForgotten();
    const int line = line_;
    copyTo(*end);
    if (text_[*end - 2] != '/') open_.push_back({name, line});
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::vector<Open> open_;
  MendedXml mended_;
};

}  // namespace

MendedXml mendXml(const std::string& text) { return Mender(text).mend(); }

}  // namespace nao::motion

#include "drivers/base/read_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

#include "drivers/base/unique_fd.h"

namespace kaori {
namespace {

constexpr std::size_t kPiece_bytes = std::size_t{64} << 10U;  // Of a file that does not know its size.

const char* KindOf(mode_t mode) {
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

std::string SizeText(std::size_t bytes) {
  constexpr std::size_t kMiB = std::size_t{1} << 20U, kKiB = std::size_t{1} << 10U;
  if (bytes % kMiB == 0) return std::to_string(bytes / kMiB) + " MiB";
  return bytes % kKiB == 0 ? std::to_string(bytes / kKiB) + " KiB" : std::to_string(bytes) + " bytes";
}

tl::unexpected<Error> TooLarge(const std::string& attempt, std::size_t most_bytes) {
  return FailInput(attempt + ": it is larger than " + SizeText(most_bytes), std::errc::file_too_large);
}

// Reads on until the end or `most_bytes`, whatever size the file said it has.
Result<std::string> ReadUpTo(const RegularFile& file, std::size_t most_bytes, const std::string& attempt) {
  std::string text;
  std::size_t have = 0;
  while (have < most_bytes) {
    // One more than it said finds the end.
    if (have == text.size())
      text.resize(std::min<std::uintmax_t>(most_bytes, std::max(have + kPiece_bytes, file.bytes + 1)));
    const ssize_t got = ::read(file.fd.get(), text.data() + have, text.size() - have);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return FailErrno(attempt);
    if (got == 0) break;
    have += static_cast<std::size_t>(got);
  }
  text.resize(have);
  return text;
}

// Walks over a text as the lexers of TOML and JSON do: quotes hide brackets, and "#" begins a comment.
// The depth is that of open brackets and braces, and of the dots in the key or header that is being
// read. JSON has no comments: a "#" outside of its quotes is an error that its parser finds.
class LevelCounter {
 public:
  explicit LevelCounter(std::string_view text) : text_(text) {}

  // The line on which the text goes deeper than `most`; 0: nowhere.
  int TooDeepAt(int most) {
    while (at_ < text_.size()) {
      Step();
      if (brackets_ + dots_ > most) return line_;
    }
    return 0;
  }

 private:
  void Step() {
    switch (text_[at_]) {
      case '"':
      case '\'':
        return SkipQuoted(text_[at_]);
      case '#':
        at_ = std::min(text_.find('\n', at_), text_.size());
        return;
      case '[':
      case '{':
        ++brackets_;
        dots_ = 0;
        break;
      case ']':
      case '}':
        // A bracket too many is an error that the parser reports; the
        // counter only must not go below zero.
        brackets_ = std::max(brackets_ - 1, 0);
        break;
      case '.':
        // A dotted key is a table in a table. The dot of a number such as 1.5 counts too, until its line ends.
        ++dots_;
        break;
      case '\n':
        ++line_;
        [[fallthrough]];
      case '=':
      case ',':
        dots_ = 0;
        break;
      default:
        break;
    }
    ++at_;
  }

  // Three quotes hold several lines, one quote holds no more than its own: a quote that is left open is
  // an error, and must not hide the brackets of the lines behind it.
  void SkipQuoted(char quote) {
    const std::string three(3, quote);
    const bool several = text_.substr(at_).starts_with(three);
    const std::string_view end = several ? std::string_view(three) : std::string_view(three).substr(0, 1);
    for (at_ += end.size(); at_ < text_.size() && !text_.substr(at_).starts_with(end); ++at_) {
      if (text_[at_] == '\n' && !several) return;
      line_ += text_[at_] == '\n' ? 1 : 0;
      // A backslash escapes in basic strings only; 'literal' ones take it as it is (TOML 1.0, String).
      const bool escapes = text_[at_] == '\\' && quote == '"' && text_.substr(at_ + 1, 1) != "\n";
      at_ += escapes ? 1 : 0;
    }
    at_ = std::min(at_ + end.size(), text_.size());
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1, brackets_ = 0, dots_ = 0;
};

}  // namespace

// O_NOCTTY: a terminal that is named by mistake must not become the one that this process obeys.
Result<RegularFile> OpenRegular(const std::filesystem::path& file, const std::string& attempt, Links links) {
  const int no_links = links == Links::kRefuse ? O_NOFOLLOW : 0;
  UniqueFd fd(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY | no_links));
  if (!fd.valid()) return FailErrno(attempt);
  return RequireRegular(std::move(fd), attempt);
}

Result<RegularFile> RequireRegular(UniqueFd fd, const std::string& attempt) {
  struct stat status {};
  if (::fstat(fd.get(), &status) < 0) return FailErrno(attempt);
  if (S_ISDIR(status.st_mode)) return Fail(std::errc::is_a_directory, attempt);
  if (!S_ISREG(status.st_mode))
    return FailInput(attempt + ": it is " + KindOf(status.st_mode) + ", not a file");
  return RegularFile{std::move(fd), static_cast<std::uintmax_t>(status.st_size)};
}

bool IsNoFile(const Error& error) {
  return error.kind == ErrorKind::kInput || error.cause == std::errc::is_a_directory;
}

Result<void> CheckLevels(std::string_view text, int most_levels, const std::string& name) {
  const int line = LevelCounter(text).TooDeepAt(most_levels);
  if (line == 0) return {};
  return FailInput(name + ":" + std::to_string(line) + ": is nested deeper than " +
                       std::to_string(most_levels) + " levels",
                   std::errc::bad_message);
}

// The size that the file says is looked at first, so that a large one is refused unread; what is read is
// measured again, since files grow and those of /proc say 0.
Result<std::string> ReadFile(const std::filesystem::path& file, const ReadLimits& limits) {
  const std::string attempt = "read " + file.string();
  const auto opened = OpenRegular(file, attempt);
  if (!opened) return tl::unexpected(opened.error());
  if (opened->bytes > limits.most_bytes) return TooLarge(attempt, limits.most_bytes);
  auto text = ReadUpTo(*opened, limits.most_bytes + 1, attempt);
  if (!text) return text;
  if (text->size() > limits.most_bytes) return TooLarge(attempt, limits.most_bytes);
  if (limits.most_levels > 0)
    if (auto flat = CheckLevels(*text, limits.most_levels, file.string()); !flat)
      return tl::unexpected(flat.error());
  return text;
}

Result<std::string> ReadBeginning(const std::filesystem::path& file, std::size_t most_bytes) {
  const std::string attempt = "read " + file.string();
  return OpenRegular(file, attempt).and_then([&](const RegularFile& opened) {
    return ReadUpTo(opened, most_bytes, attempt);
  });
}

Result<void> ReadThrough(const std::filesystem::path& file) {
  const std::string attempt = "read " + file.string();
  const auto opened = OpenRegular(file, attempt);
  if (!opened) return tl::unexpected(opened.error());
  std::string piece(kPiece_bytes, '\0');
  while (true) {
    const ssize_t got = ::read(opened->fd.get(), piece.data(), piece.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return FailErrno(attempt);
    if (got == 0) return {};
  }
}

}  // namespace kaori

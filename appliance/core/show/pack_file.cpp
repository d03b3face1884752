#include <sys/mman.h>

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "appliance/core/show/check.h"
#include "appliance/core/show/pack.h"
#include "appliance/core/show/pack_container.h"
#include "appliance/core/show/pack_content.h"
#include "appliance/core/show/pack_keys.h"
#include "drivers/base/folder.h"
#include "drivers/base/read_file.h"
#include "drivers/base/read_full.h"
#include "drivers/base/whole_file.h"

namespace kaori::show {
namespace {

// Read and summed up in pieces that stay in the cache between the two.
constexpr std::size_t kPiece_bytes = std::size_t{256} << 10U;

// Memory by whole pages, which is not cleared before it is filled and may be of huge pages: a content is read
// once, front to back.
class Pages {
 public:
  // Private memory. madvise may fail, and then costs nothing but speed.
  static Result<Pages> Allocate(std::size_t bytes, const std::string& name) {
    void* at = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (at == MAP_FAILED) return FailErrno("find memory for the show " + name);
    ::madvise(at, bytes, MADV_HUGEPAGE);
    return Pages({static_cast<std::uint8_t*>(at), bytes});
  }
  // The file itself, which nobody can change or shorten: for a verified root only. Elsewhere a file that
  // shrinks would end the process by SIGBUS.
  static Result<Pages> Map(int fd, std::size_t bytes, const std::string& name) {
    void* at = ::mmap(nullptr, bytes, PROT_READ, MAP_PRIVATE, fd, 0);
    if (at == MAP_FAILED) return FailErrno("read the show " + name);
    return Pages({static_cast<std::uint8_t*>(at), bytes});
  }
  Pages(Pages&& other) noexcept : bytes_(std::exchange(other.bytes_, {})) {}
  Pages& operator=(Pages&&) = delete;
  ~Pages() {
    if (!bytes_.empty()) ::munmap(bytes_.data(), bytes_.size());
  }
  std::span<std::uint8_t> bytes() const { return bytes_; }

 private:
  explicit Pages(std::span<std::uint8_t> bytes) : bytes_(bytes) {}
  std::span<std::uint8_t> bytes_;
};

// What stands in a header is said of the file: the attempt of such an error is the end of a sentence.
tl::unexpected<Error> Refuse(const std::string& name, const Error& error) {
  return FailAs(error, name + " " + error.attempt);
}

// A regular file that is not empty.
Result<RegularFile> Open(const std::string& name) {
  auto file = OpenRegular(name, "open the show " + name);
  if (file && file->bytes == 0) return FailInput("the show " + name + " is empty");
  return file;
}

// Reads the header from the beginning of the file; afterwards the descriptor stands at the content.
Result<PackSeal> ReadSeal(const RegularFile& file, const std::string& name) {
  PackHeader header{};
  const auto got = ReadFull(file.fd.get(), header, "the show " + name);
  if (!got) return tl::unexpected(got.error());
  auto seal = ReadHeader(std::span(header).first(*got), file.bytes);
  if (!seal) return Refuse(name, seal.error());
  return seal;
}

// Without a key nobody is refused. With one a pack must be signed by that very key; a signature that does not
// fit was refused before, by ReadHeader.
Result<void> CheckSigner(const std::string& name, const PackSeal& seal, const LoadOptions& options) {
  if (!options.signed_by) return {};
  if (!seal.signer)
    return FailInput(name + " is not signed, and this box plays signed packs only", kUnsignedPack);
  if (std::ranges::find(*options.signed_by, *seal.signer) != options.signed_by->end()) return {};
  return FailInput(name + " is signed by another key than the one this box trusts", kForeignPack);
}

// Each piece is summed up while it is in the cache. The length is the header's, so that a file that grows
// meanwhile is read no further than was agreed.
Result<Pages> ReadContent(const RegularFile& file, const PackSeal& seal, const std::string& name) {
  auto pages = Pages::Allocate(std::max<std::size_t>(seal.content_bytes, 1), name);
  if (!pages) return pages;
  Checksummer sum;
  for (std::size_t at = 0; at < seal.content_bytes;) {
    const auto piece =
        pages->bytes().subspan(at, std::min<std::size_t>(kPiece_bytes, seal.content_bytes - at));
    const auto got = ReadFull(file.fd.get(), piece, "the show " + name);
    if (!got) return tl::unexpected(got.error());
    if (*got < piece.size())
      return FailInput(name + " is no whole show pack: it became shorter while it was read");
    sum.Add(piece);
    at += piece.size();
  }
  if (sum.Finish() != seal.checksum) return FailInput(name + " is damaged: its checksum does not fit");
  return pages;
}

// What stands behind the header.
struct Content {
  Pages pages;
  std::size_t begin = 0, length = 0;
  std::span<const std::uint8_t> bytes() const { return pages.bytes().subspan(begin, length); }
};

// The content lives on for as long as a texture of the show points into it. Only the first fault is said in
// whole: a pack is made by our own tools, which say all of them.
Result<Show> DecodeChecked(Content opened, const std::string& name) {
  const auto content = std::make_shared<const Content>(std::move(opened));
  auto show = DecodeContent(content->bytes(), content);
  if (!show) return Refuse(name, show.error());
  const auto faults = CheckShow(*show);
  if (!faults.empty())
    return FailInput(
        name + ": " + faults.front() +
        (faults.size() > 1 ? " (and " + std::to_string(faults.size() - 1) + " more faults)" : ""));
  Track(*show);
  return show;
}

// The signature is checked before the content is read: it covers the checksum, and what is not trusted
// is not worth reading.
Result<Content> OpenContent(const std::string& name, const LoadOptions& options) {
  const auto open = Open(name);
  if (!open) return tl::unexpected(open.error());
  const auto seal = ReadSeal(*open, name);
  if (!seal) return tl::unexpected(seal.error());
  if (auto ok = CheckSigner(name, *seal, options); !ok) return tl::unexpected(ok.error());
  auto pages = options.on_verified_root ? Pages::Map(open->fd.get(), open->bytes, name)
                                        : ReadContent(*open, *seal, name);
  if (!pages) return tl::unexpected(pages.error());
  return Content{std::move(*pages), options.on_verified_root ? kPackHeader_bytes : 0, seal->content_bytes};
}

// Header and content are written one behind the other; EncodePack would copy both into one buffer first.
Result<void> SaveContent(std::span<const std::uint8_t> content, const std::filesystem::path& file,
                         const SecretKey* signer) {
  const PackHeader header = MakeHeader(content, signer);
  return WriteWholeFile(file, {header, content});
}

// CheckShow does not see sounds that are read alone, so that what the player divides by is looked at here.
bool IsSound(const Sound& sound) {
  return (sound.channels == 1 || sound.channels == 2) &&
         sound.samples.size() % static_cast<std::size_t>(sound.channels) == 0;
}

}  // namespace

Result<LoadOptions> LoadOptionsOf(const std::filesystem::path& trust, bool verified) {
  if (trust.empty()) return LoadOptions{.on_verified_root = verified};
  if (!IsThere(trust)) return tl::unexpected(ReadPublicKey(trust).error());
  auto keys = ReadPublicKeys({trust});
  if (!keys) return tl::unexpected(keys.error());
  if (keys->empty())
    return FailInput(trust.string() + ": holds no public key; those are files that end in .pub");
  return LoadOptions{std::move(*keys), verified};
}

Result<Show> LoadPack(const std::filesystem::path& file, const LoadOptions& options) {
  auto content = OpenContent(file.string(), options);
  if (!content) return tl::unexpected(content.error());
  return DecodeChecked(std::move(*content), file.string());
}

// Samples are copied, so that the memory of the pack is given back when its sounds are there.
Result<std::vector<Sound>> LoadSounds(const std::filesystem::path& file, const LoadOptions& options) {
  const std::string name = file.string();
  const auto content = OpenContent(name, options);
  if (!content) return tl::unexpected(content.error());
  auto sounds = DecodeSounds(content->bytes());
  if (!sounds) return Refuse(name, sounds.error());
  for (const Sound& sound : *sounds)
    if (!IsSound(sound))
      return FailInput(name + ": the sound of a motion is neither one nor two channels of whole frames");
  return sounds;
}

// The pictures first: they are copied out, and the show keeps the content for its textures.
Result<ShowWithKeys> LoadPackWithKeys(const std::filesystem::path& file, const LoadOptions& options) {
  const std::string name = file.string();
  auto content = OpenContent(name, options);
  if (!content) return tl::unexpected(content.error());
  auto keys = DecodeKeys(content->bytes());
  if (!keys) return Refuse(name, keys.error());
  auto show = DecodeChecked(std::move(*content), name);
  if (!show) return tl::unexpected(show.error());
  return ShowWithKeys{std::move(*show), std::move(*keys)};
}

Result<std::optional<PublicKey>> ReadSigner(const std::filesystem::path& file) {
  const auto open = Open(file.string());
  if (!open) return tl::unexpected(open.error());
  const auto seal = ReadSeal(*open, file.string());
  if (!seal) return tl::unexpected(seal.error());
  return seal->signer;
}

std::vector<std::uint8_t> EncodePack(const Show& show, const SecretKey* signer) {
  const auto content = EncodeContent(show);
  const PackHeader header = MakeHeader(content, signer);
  std::vector<std::uint8_t> bytes(header.size() + content.size());
  std::ranges::copy(header, bytes.begin());
  std::ranges::copy(content, bytes.begin() + kPackHeader_bytes);
  return bytes;
}

Result<void> SavePack(const Show& show, const std::filesystem::path& file, const SecretKey* signer) {
  return SaveContent(EncodeContent(show), file, signer);
}

Result<void> SavePackWithKeys(const ShowWithKeys& whole, const std::filesystem::path& file,
                              const SecretKey* signer) {
  return SaveContent(EncodeContent(whole.show, whole.keys), file, signer);
}

// One copy in memory is checked, signed and written, so that nobody can change it in between.
Result<void> SignPack(const std::filesystem::path& file, const std::filesystem::path& into,
                      const SecretKey& signer) {
  const std::string name = file.string();
  const auto content = OpenContent(name, {});
  if (!content) return tl::unexpected(content.error());
  const auto show = DecodeContent(content->bytes(), nullptr);
  if (!show) return Refuse(name, show.error());
  if (const auto faults = CheckShow(*show); !faults.empty()) return FailInput(name + ": " + faults.front());
  return WriteWholeFile(into, {MakeHeader(content->bytes(), &signer), content->bytes()});
}

}  // namespace kaori::show

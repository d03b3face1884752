#include "appliance/core/show/pack_key.h"

#include <sodium.h>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

#include "drivers/base/folder.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::show {
namespace {

static_assert(SecretKey::kBytes == crypto_sign_SECRETKEYBYTES);
static_assert(sizeof(PublicKey) == crypto_sign_PUBLICKEYBYTES);

// The first word of a key's line says what it is, so that nobody hands out the wrong file.
constexpr std::string_view kSecretMark = "kaori-secret-key ";
constexpr std::string_view kPublicMark = "kaori-public-key ";
constexpr std::size_t kMostKeyFile_bytes = 4096;  // A line, and room for remarks behind it.

// "MARK HEX" and a line end. sodium_bin2hex ends its text with a zero, which becomes the line end.
std::string Line(std::string_view mark, std::span<const std::uint8_t> bytes) {
  std::string hex(2 * bytes.size() + 1, '\0');
  sodium_bin2hex(hex.data(), hex.size(), bytes.data(), bytes.size());
  hex.back() = '\n';
  return std::string(mark) + hex;
}

// Fills `bytes` from a line as Line writes it. The text is wiped afterwards, since it may be a secret key's.
// Only the first line is read; remarks may follow.
Result<void> ReadLine(const std::filesystem::path& file, std::string_view mark,
                      std::span<std::uint8_t> bytes) {
  auto text = ReadFile(file, {.most_bytes = kMostKeyFile_bytes});
  if (!text) return tl::unexpected(text.error());
  const std::string_view line = std::string_view(*text).substr(0, text->find('\n'));
  std::size_t read = 0;
  const bool whole = line.starts_with(mark) && line.size() == mark.size() + 2 * bytes.size() &&
                     sodium_hex2bin(bytes.data(), bytes.size(), line.data() + mark.size(),
                                    line.size() - mark.size(), nullptr, &read, nullptr) == 0 &&
                     read == bytes.size();
  sodium_memzero(text->data(), text->size());
  if (whole) return {};
  return FailInput(file.string() + ": holds no \"" + std::string(mark.substr(0, mark.size() - 1)) + "\" of " +
                   std::to_string(bytes.size()) + " bytes");
}

// A secret key that is written over is lost for good, and every box that trusts it with it.
Result<void> RefuseExisting(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::exists(file, error))
    return Fail(std::errc::file_exists, "write the key " + file.string());
  return {};
}

}  // namespace

// By libsodium, since a compiler may leave out a plain clearing of memory that nobody reads again.
SecretKey::~SecretKey() {
  sodium_memzero(bytes_.data(), bytes_.size());
}

// libsodium keeps the public key as the second half of the secret one.
PublicKey SecretKey::public_key() const {
  PublicKey key;
  std::copy_n(bytes_.end() - static_cast<std::ptrdiff_t>(key.bytes.size()), key.bytes.size(),
              key.bytes.begin());
  return key;
}

// The public half is dropped: the secret key ends with the same bytes.
Result<SecretKey> MakeKey() {
  if (sodium_init() < 0) return Fail(std::errc::function_not_supported, "gather chance for a key");
  PublicKey half;
  SecretKey key;
  crypto_sign_keypair(half.bytes.data(), key.bytes().data());
  return key;
}

// The secret key goes first: where the second file fails, its public key can be made again from it.
Result<void> SaveKey(const SecretKey& key, const std::filesystem::path& file) {
  const std::filesystem::path open_file = file.string() + ".pub";
  for (const auto& path : {file, open_file})
    if (auto ok = RefuseExisting(path); !ok) return ok;
  constexpr unsigned kOwnerOnly = 0600;
  std::string secret = Line(kSecretMark, key.bytes());
  auto ok = WriteWholeFile(file, {AsBytes(secret)}, kOwnerOnly);
  sodium_memzero(secret.data(), secret.size());
  if (!ok) return ok;
  const std::string open = PublicKeyLine(key.public_key());
  return WriteWholeFile(open_file, {AsBytes(open)});
}

std::string PublicKeyLine(const PublicKey& key) {
  return Line(kPublicMark, key.bytes);
}

Result<SecretKey> ReadSecretKey(const std::filesystem::path& file) {
  SecretKey key;
  if (auto ok = ReadLine(file, kSecretMark, key.bytes()); !ok) return tl::unexpected(ok.error());
  return key;
}

Result<PublicKey> ReadPublicKey(const std::filesystem::path& file) {
  PublicKey key;
  if (auto ok = ReadLine(file, kPublicMark, key.bytes); !ok) return tl::unexpected(ok.error());
  return key;
}

namespace {

// A box may hold a key that somebody spoilt: the others still count.
Result<void> AddFolder(const std::filesystem::path& folder, PublicKeys& keys,
                       std::vector<std::string>* faults) {
  const auto files = ListFolder(folder);
  if (!files) return tl::unexpected(files.error());
  for (const auto& file : *files) {
    if (file.extension() != ".pub") continue;
    if (auto key = ReadPublicKey(file))
      keys.push_back(*key);
    else if (faults != nullptr)
      faults->push_back(key.error().message());
  }
  return {};
}

}  // namespace

Result<PublicKeys> ReadPublicKeys(std::span<const std::filesystem::path> places,
                                  std::vector<std::string>* faults) {
  PublicKeys keys;
  for (const auto& place : places) {
    std::error_code none;
    if (std::filesystem::is_directory(place, none)) {
      if (auto ok = AddFolder(place, keys, faults); !ok) return tl::unexpected(ok.error());
    } else if (std::filesystem::exists(place, none)) {
      const auto key = ReadPublicKey(place);
      if (!key) return tl::unexpected(key.error());
      keys.push_back(*key);
    }
  }
  return keys;
}

Result<PublicKeys> ReadPublicKeys(std::initializer_list<std::filesystem::path> places) {
  return ReadPublicKeys(std::span(places.begin(), places.size()));
}

std::string Fingerprint(const PublicKey& key) {
  std::array<std::uint8_t, 32> sum{};
  crypto_generichash(sum.data(), sum.size(), key.bytes.data(), key.bytes.size(), nullptr, 0);
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < 8; ++i) {
    if (i > 0 && i % 2 == 0) text += ' ';
    text += kDigits[sum[i] >> 4U];
    text += kDigits[sum[i] & 15U];
  }
  return text;
}

}  // namespace kaori::show

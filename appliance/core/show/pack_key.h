// Keys for show packs: a company signs with its secret key, a box that has the public one plays nothing else.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "drivers/base/result.h"

namespace kaori::show {

// Ed25519 (RFC 8032). A box without a public key plays every pack that is whole.
struct PublicKey {
  std::array<std::uint8_t, 32> bytes{};
  friend bool operator==(const PublicKey&, const PublicKey&) = default;
};

using PublicKeys = std::vector<PublicKey>;

// The key with which a company signs. Its memory is wiped when it goes, and that of each copy; it is never
// logged.
class SecretKey {
 public:
  static constexpr std::size_t kBytes = 64;  // The seed, then the public key.

  SecretKey() = default;
  SecretKey(const SecretKey&) = default;
  SecretKey& operator=(const SecretKey&) = default;
  ~SecretKey();

  std::array<std::uint8_t, kBytes>& bytes() { return bytes_; }
  const std::array<std::uint8_t, kBytes>& bytes() const { return bytes_; }
  // The key that a box has to be given.
  PublicKey public_key() const;

 private:
  std::array<std::uint8_t, kBytes> bytes_{};
};

// A new key from the kernel's chance. Errors: function_not_supported (the machine gives no chance).
Result<SecretKey> MakeKey();

// Writes the secret key to `file`, readable by its owner alone, and the public one to `file`.pub; both are
// one line of text. Replaces nothing. Errors: file_exists; as open(2) and write(2).
Result<void> SaveKey(const SecretKey& key, const std::filesystem::path& file);

// Each reads a file as SaveKey writes it; a key of the other kind is refused by its mark. Blocks for the
// disk. Errors: as ReadFile; invalid_argument (it holds no such key).
Result<SecretKey> ReadSecretKey(const std::filesystem::path& file);
Result<PublicKey> ReadPublicKey(const std::filesystem::path& file);

// The public keys of several places: a file is one key, a folder is all of its files named *.pub, in the
// order of their names; a place that does not exist has none. A file of a folder that holds no key is left
// out, with a line in `faults` where that is given. Blocks for the disk. Errors: those of ReadPublicKey for a
// file; what a folder cannot be read for.
Result<PublicKeys> ReadPublicKeys(std::span<const std::filesystem::path> places,
                                  std::vector<std::string>* faults = nullptr);
Result<PublicKeys> ReadPublicKeys(std::initializer_list<std::filesystem::path> places);

// The line of a public key's file, as SaveKey writes it. Pure.
std::string PublicKeyLine(const PublicKey& key);

// What people compare: the first eight bytes of BLAKE2b-256 of the key, as "3f2a 19c0 77de 01b4".
std::string Fingerprint(const PublicKey& key);

}  // namespace kaori::show

// Keys for show packs: a company signs with its secret key, a box that has the public one plays nothing else.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>

#include "drivers/base/result.h"

namespace kaori::show {

// Ed25519 (RFC 8032). A box without a public key plays every pack that is whole.
struct PublicKey {
  std::array<std::uint8_t, 32> bytes{};
  friend bool operator==(const PublicKey&, const PublicKey&) = default;
};

// The key with which a company signs. Its memory is wiped when it goes, and that of each copy; it is never logged.
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

}  // namespace kaori::show

// The box's own certificate for HTTPS, which it makes at the first start and keeps. No authority signs it. A
// visitor trusts it by comparing the fingerprint that the box's screen shows with the one that the browser
// shows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "drivers/web/http_server.h"

namespace kaori::desk {

// What the desk serves with: the PEM of key and certificate, and the mark by which people know it.
struct OwnCertificate {
  web::Certificate pem;
  // The first four bytes of its SHA-256, big-endian, which people compare on two screens.
  std::uint32_t fingerprint = 0;
};

// What a new certificate is made for; a stored one is not compared with it.
struct CertificateOptions {
  // Host names that the certificate is good for, besides the addresses (OwnNames).
  std::vector<std::string> names;
  std::uint32_t address = 0;  // IPv4, as OwnAddress() gives it.
  std::int64_t now_s = 0;     // The wall clock, in seconds since 1970.
};

// Loads FOLDER/desk.pem, which only its owner may read. It is made where it is missing, damaged, or valid for
// less than a month. A box whose clock is wrong by years makes a certificate that begins in 2026. Blocks for
// the disk. Errors: those of the folder and the file, and
//   not_supported  the library could not make a certificate
Result<OwnCertificate> LoadOrMakeCertificate(const std::filesystem::path& folder,
                                             const CertificateOptions& options);

}  // namespace kaori::desk

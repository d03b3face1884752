// The box's own certificate for HTTPS, made by itself at the first start and kept.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "drivers/web/http_server.h"

namespace kaori::desk {

struct OwnCertificate {
  web::Certificate pem;
  std::uint32_t mark = 0;  // The first four bytes of its SHA-256, big-endian: to be compared on two screens.
};

struct CertificateFor {
  std::vector<std::string> names;
  std::uint32_t address = 0;  // IPv4, as gate.h has it.
  std::int64_t now_s = 0;     // Wall clock, since 1970.
};

// FOLDER/desk.pem, which only its owner may read; made anew where it is not there, is damaged, or ends within
// a month. A box whose clock is wrong by years makes one that begins in 2026. Blocks for the disk. Errors:
// those of the folder and the file; not_supported (the library could not make one).
Result<OwnCertificate> KeptCertificate(const std::filesystem::path& folder, const CertificateFor& whom);

}  // namespace kaori::desk

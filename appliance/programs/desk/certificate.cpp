#include "appliance/programs/desk/certificate.h"

#include <gnutls/x509.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "appliance/programs/desk/random_bytes.h"
#include "drivers/base/log.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::desk {
namespace {

constexpr std::int64_t kDay_s = 86'400;
// 2026-01-01: no box is older. A box without a battery for its clock starts in 1970, and a certificate of
// that time would be refused by every browser.
constexpr std::int64_t kFirst_s = 1'767'225'600;
// What browsers let a certificate last at most. One that ends within a month is renewed at the next start, so
// that it does not end in the middle of a run of shows.
constexpr std::int64_t kLasts_s = 825 * kDay_s;
constexpr std::int64_t kRenew_s = 30 * kDay_s;
// Key and certificate take about 1 KB together.
constexpr std::size_t kMaxPem_bytes = 65536;
// The file holds the key and then the certificate: here the second one begins (RFC 7468).
constexpr std::string_view kBegin = "-----BEGIN CERTIFICATE-----";

struct CloseKey {
  void operator()(gnutls_x509_privkey_t key) const { gnutls_x509_privkey_deinit(key); }
};
struct CloseCertificate {
  void operator()(gnutls_x509_crt_t crt) const { gnutls_x509_crt_deinit(crt); }
};
using Key = std::unique_ptr<gnutls_x509_privkey_int, CloseKey>;
using Crt = std::unique_ptr<gnutls_x509_crt_int, CloseCertificate>;

// Null where gnutls has no memory, which Read and Make answer as a failure.
Key NewKey() {
  gnutls_x509_privkey_t key = nullptr;
  return gnutls_x509_privkey_init(&key) < 0 ? nullptr : Key(key);
}

Crt NewCertificate() {
  gnutls_x509_crt_t crt = nullptr;
  return gnutls_x509_crt_init(&crt) < 0 ? nullptr : Crt(crt);
}

// Copies what gnutls has allocated, and frees it.
std::string Release(const gnutls_datum_t& datum) {
  std::string text(reinterpret_cast<const char*>(datum.data), datum.size);
  gnutls_free(datum.data);
  return text;
}

// The first four bytes of the SHA-256 of the certificate's DER form, as browsers show it; 0 where it cannot
// be made.
std::uint32_t MarkOf(gnutls_x509_crt_t crt) {
  std::array<std::uint8_t, 32> sum{};
  std::size_t size = sum.size();
  if (gnutls_x509_crt_get_fingerprint(crt, GNUTLS_DIG_SHA256, sum.data(), &size) < 0) return 0;
  return std::uint32_t{sum[0]} << 24 | std::uint32_t{sum[1]} << 16 | std::uint32_t{sum[2]} << 8 | sum[3];
}

// The stored key and certificate; nothing where it is none, or not valid for long any more. That the two
// belong together is not checked: the server refuses them if not.
std::optional<OwnCertificate> Read(const std::string& text, std::int64_t now_s) {
  const auto at = text.find(kBegin);
  const Crt crt = NewCertificate();
  const Key key = NewKey();
  if (at == std::string::npos || !crt || !key) return std::nullopt;
  OwnCertificate own{{text.substr(at), text.substr(0, at)}, 0};
  const auto datum = [](std::string& pem) {
    return gnutls_datum_t{reinterpret_cast<unsigned char*>(pem.data()), static_cast<unsigned>(pem.size())};
  };
  const gnutls_datum_t chain = datum(own.pem.chain), secret = datum(own.pem.key);
  if (gnutls_x509_crt_import(crt.get(), &chain, GNUTLS_X509_FMT_PEM) < 0 ||
      gnutls_x509_privkey_import(key.get(), &secret, GNUTLS_X509_FMT_PEM) < 0)
    return std::nullopt;
  if (gnutls_x509_crt_get_expiration_time(crt.get()) < now_s + kRenew_s) return std::nullopt;
  own.fingerprint = MarkOf(crt.get());
  return own;
}

// Browsers look at the alternative names only (RFC 6125): the host's names, the loopback, and the address
// that the box has now. A box whose address has changed shows a certificate that does not name it.
bool Name(gnutls_x509_crt_t crt, const CertificateOptions& options) {
  const char* wrong = nullptr;
  bool ok = gnutls_x509_crt_set_dn(crt, "CN=Kaori box", &wrong) >= 0;
  for (const std::string& name : options.names)
    ok = ok &&
         gnutls_x509_crt_set_subject_alt_name(crt, GNUTLS_SAN_DNSNAME, name.data(),
                                              static_cast<unsigned>(name.size()), GNUTLS_FSAN_APPEND) >= 0;
  for (const std::uint32_t address : {0x7F000001U, options.address}) {
    const std::array<std::uint8_t, 4> bytes{
        static_cast<std::uint8_t>(address >> 24), static_cast<std::uint8_t>(address >> 16),
        static_cast<std::uint8_t>(address >> 8), static_cast<std::uint8_t>(address)};
    ok = ok && gnutls_x509_crt_set_subject_alt_name(crt, GNUTLS_SAN_IPADDRESS, bytes.data(), bytes.size(),
                                                    GNUTLS_FSAN_APPEND) >= 0;
  }
  return ok;
}

// Signed by itself, version 3 of X.509. It begins a day early, for visitors whose clock is behind. The serial
// number is random, as CAs do it, so that no browser sees two certificates of one issuer under one number.
bool Fill(gnutls_x509_crt_t crt, gnutls_x509_privkey_t key, const CertificateOptions& options) {
  std::array<std::uint8_t, 16> serial;
  FillWithKernelRandom(serial);
  serial[0] &= 0x7F;  // Positive.
  const std::int64_t from_s = std::max(options.now_s, kFirst_s) - kDay_s;
  return gnutls_x509_crt_set_version(crt, 3) >= 0 &&
         gnutls_x509_crt_set_serial(crt, serial.data(), serial.size()) >= 0 &&
         gnutls_x509_crt_set_activation_time(crt, from_s) >= 0 &&
         gnutls_x509_crt_set_expiration_time(crt, from_s + kLasts_s) >= 0 && Name(crt, options) &&
         gnutls_x509_crt_set_key_usage(crt, GNUTLS_KEY_DIGITAL_SIGNATURE) >= 0 &&
         gnutls_x509_crt_set_key_purpose_oid(crt, GNUTLS_KP_TLS_WWW_SERVER, 0) >= 0 &&
         gnutls_x509_crt_set_key(crt, key) >= 0 &&
         gnutls_x509_crt_sign2(crt, crt, key, GNUTLS_DIG_SHA256, 0) >= 0;
}

// Makes a key and a certificate, and returns the PEM of both, the key first. A key on the curve P-256, which
// every browser takes and which is made in milliseconds.
Result<std::string> Make(const CertificateOptions& options) {
  const Key key = NewKey();
  const Crt crt = NewCertificate();
  gnutls_datum_t secret{}, chain{};
  const unsigned bits = GNUTLS_CURVE_TO_BITS(GNUTLS_ECC_CURVE_SECP256R1);
  if (!key || !crt || gnutls_x509_privkey_generate2(key.get(), GNUTLS_PK_ECDSA, bits, 0, nullptr, 0) < 0 ||
      !Fill(crt.get(), key.get(), options) ||
      gnutls_x509_privkey_export2(key.get(), GNUTLS_X509_FMT_PEM, &secret) < 0)
    return Fail(std::errc::not_supported, "make a certificate");
  std::string text = Release(secret);
  if (gnutls_x509_crt_export2(crt.get(), GNUTLS_X509_FMT_PEM, &chain) < 0)
    return Fail(std::errc::not_supported, "make a certificate");
  return text + Release(chain);
}

// Errors: those of making the folder and of WriteWholeFile.
Result<void> Keep(const std::filesystem::path& file, const std::string& pem) {
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  if (error)
    return Fail(static_cast<std::errc>(error.value()), "make the folder " + file.parent_path().string());
  auto written = WriteWholeFile(file, {AsBytes(pem)}, 0600);
  if (written) Log("a new certificate was made: {}", file.string());
  return written;
}

// A name that is wrong is the caller's to mend; a box whose data partition is away or full has nowhere else to keep it.
bool IsOfTheDisk(std::errc cause) {
  return cause == std::errc::read_only_file_system || cause == std::errc::permission_denied ||
         cause == std::errc::operation_not_permitted || cause == std::errc::no_space_on_device ||
         cause == std::errc::io_error;
}

}  // namespace

// A file that cannot be read is logged and replaced: without its certificate the desk could not be used at
// all.
Result<OwnCertificate> LoadOrMakeCertificate(const std::filesystem::path& folder,
                                             const CertificateOptions& options) {
  const std::filesystem::path file = folder / "desk.pem";
  const std::int64_t now_s = std::max(options.now_s, kFirst_s);
  const auto stored = ReadFile(file, {.most_bytes = kMaxPem_bytes});
  if (!stored && stored.error().cause != std::errc::no_such_file_or_directory)
    LogWarning("{}; a new certificate is made", stored.error().message());
  if (const auto own = Read(stored.value_or(""), now_s)) return *own;
  const auto made = Make(options);
  if (!made) return tl::unexpected(made.error());
  const auto kept = Keep(file, *made);
  if (!kept && !IsOfTheDisk(kept.error().cause)) return tl::unexpected(kept.error());
  if (!kept) LogWarning("{}; the next start makes another certificate", kept.error().message());
  const auto own = Read(*made, now_s);
  if (!own) return Fail(std::errc::not_supported, "read the new certificate");
  return *own;
}

}  // namespace kaori::desk

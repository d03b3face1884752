// A visitor of the desk who speaks TLS over its real socket, and trusts every certificate.
#pragma once

#include <fcntl.h>
#include <gnutls/gnutls.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "tests/appliance/programs/desk_visitor.h"

namespace kaori::tests {

class SecureVisitor {
 public:
  // As Visitor. `offered`: versions, ciphers and key exchanges, in GnuTLS's words.
  SecureVisitor(std::uint16_t port, std::function<void()> pump, const char* offered = "NORMAL",
                std::uint32_t host = 1)
      : visitor_(port, pump, host), pump_(std::move(pump)) {
    gnutls_certificate_allocate_credentials(&credentials_);
    gnutls_init(&session_, GNUTLS_CLIENT | GNUTLS_NONBLOCK);
    EXPECT_EQ(gnutls_priority_set_direct(session_, offered, nullptr), GNUTLS_E_SUCCESS) << offered;
    gnutls_credentials_set(session_, GNUTLS_CRD_CERTIFICATE, credentials_);
    ::fcntl(visitor_.fd(), F_SETFL, O_NONBLOCK);
    gnutls_transport_set_int(session_, visitor_.fd());
  }
  ~SecureVisitor() {
    gnutls_deinit(session_);
    gnutls_certificate_free_credentials(credentials_);
  }
  SecureVisitor(const SecureVisitor&) = delete;
  SecureVisitor& operator=(const SecureVisitor&) = delete;

  // Whether both sides agree on TLS, within two seconds.
  bool Agrees() {
    int state = GNUTLS_E_AGAIN;
    for (int turn = 0; turn < 2000 && state < 0 && gnutls_error_is_fatal(state) == 0; ++turn) {
      state = gnutls_handshake(session_);
      Wait();
    }
    return state == GNUTLS_E_SUCCESS;
  }

  // Agrees first, where that was not done. False where the other side does not, or has hung up.
  bool Send(std::string_view bytes) {
    if (!agreed_) agreed_ = Agrees();
    if (!agreed_) return false;
    return gnutls_record_send(session_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
  }

  // Whether something is said within a second; false where the other side has hung up.
  bool Hears() {
    std::array<char, 1024> bytes;
    for (int turn = 0; turn < 1000; ++turn) {
      const ssize_t got = gnutls_record_recv(session_, bytes.data(), bytes.size());
      if (got > 0) return true;
      if (got == 0 || gnutls_error_is_fatal(static_cast<int>(got)) != 0) return false;
      Wait();
    }
    return false;
  }

  // A whole reply to a request; what came of it where the other side hangs up or is silent for a second.
  std::string Ask(std::string_view request) {
    std::string all;
    if (!Send(request)) return all;
    for (int silent = 0; silent < 1000 && !IsWhole(all); ++silent) {
      std::array<char, 65536> bytes;
      const ssize_t got = gnutls_record_recv(session_, bytes.data(), bytes.size());
      if (got == 0 || (got < 0 && gnutls_error_is_fatal(static_cast<int>(got)) != 0)) return all;
      if (got > 0) {
        all.append(bytes.data(), static_cast<std::size_t>(got));
        silent = 0;
      }
      Wait();
    }
    return all;
  }

 private:
  // A turn of the other side, and a millisecond for what it sends.
  void Wait() {
    pump_();
    pollfd wait{visitor_.fd(), POLLIN, 0};
    ::poll(&wait, 1, 1);
  }

  Visitor visitor_;
  std::function<void()> pump_;
  gnutls_certificate_credentials_t credentials_ = nullptr;
  gnutls_session_t session_ = nullptr;
  bool agreed_ = false;
};

}  // namespace kaori::tests

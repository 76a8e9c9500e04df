#pragma once

#include <string>

namespace nao::daemon {

/// Where a certificate and its private key are, both PEM.
struct CertificateFiles {
  std::string certificate;
  std::string key;
};

/// Those in `folder`. If there are none, makes the folder and a self-signed pair (P-256, ten
/// years) in it, the key for this user's eyes alone. @throws InputError when that fails.
CertificateFiles findOrMakeCertificate(const std::string& folder);

/// Where they are kept if nobody says otherwise: below $XDG_STATE_HOME, or ~/.local/state.
std::string defaultCertificateFolder();

}  // namespace nao::daemon

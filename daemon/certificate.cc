#include "daemon/certificate.h"

#include <fcntl.h>
#include <openssl/ec.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/rand.h>
#include <openssl/x509.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "core/check.h"

namespace nao::daemon {
namespace {

namespace fs = std::filesystem;

constexpr long kValid = 10L * 365 * 24 * 3600;  // [s]

using Key = std::unique_ptr<EVP_PKEY, decltype(&EVP_PKEY_free)>;
using Certificate = std::unique_ptr<X509, decltype(&X509_free)>;
using File = std::unique_ptr<std::FILE, decltype(&std::fclose)>;

void need(bool done, const std::string& what) {
  if (!done) throw InputError("TLS: " + what + " failed, expected a working OpenSSL");
}

// Signed by itself; the name means nothing to clients, which do not check it.
Certificate sign(EVP_PKEY* key) {
  Certificate made(X509_new(), &X509_free);
  need(made != nullptr, "making a certificate");
  unsigned char serial[8];
  need(RAND_bytes(serial, sizeof serial) == 1, "drawing a serial number");
  serial[0] = (serial[0] & 0x7f) | 0x40;  // DER knows neither a sign nor a leading zero here
  ASN1_INTEGER* number = X509_get_serialNumber(made.get());
  need(ASN1_STRING_set(number, serial, sizeof serial) == 1, "setting the serial number");
  X509_set_version(made.get(), 2);
  X509_gmtime_adj(X509_getm_notBefore(made.get()), 0);
  X509_gmtime_adj(X509_getm_notAfter(made.get()), kValid);
  X509_NAME* name = X509_get_subject_name(made.get());
  const auto* text = reinterpret_cast<const unsigned char*>("usarnaoqi");
  X509_NAME_add_entry_by_txt(name, "CN", MBSTRING_ASC, text, -1, -1, 0);
  X509_set_issuer_name(made.get(), name);
  X509_set_pubkey(made.get(), key);
  need(X509_sign(made.get(), key, EVP_sha256()) > 0, "signing the certificate");
  return made;
}

/// While it lives, no other process makes a certificate in this folder. Where a folder can not be
/// locked, as on some network drives, nothing is.
class FolderLock {
 public:
  explicit FolderLock(const std::string& folder)
      : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ >= 0) ::flock(descriptor_, LOCK_EX);
  }
  ~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

/// A file that is there once write() has filled it, or as it was before.
template <class Write>
void create(const std::string& path, mode_t mode, const Write& write) {
  const std::string part = path + ".new";
  const int descriptor = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, mode);
  File file(descriptor < 0 ? nullptr : ::fdopen(descriptor, "w"), &std::fclose);
  if (!file) throw InputError("--tls-dir: can not write " + path + ", expected a folder of yours");
  need(write(file.get()) == 1 && std::fflush(file.get()) == 0, "writing " + path);
  need(std::rename(part.c_str(), path.c_str()) == 0, "writing " + path);
}

void make(const CertificateFiles& files) {
  const Key key(EVP_EC_gen("P-256"), &EVP_PKEY_free);
  need(key != nullptr, "making a key");
  const Certificate certificate = sign(key.get());
  create(files.key, 0600, [&](std::FILE* file) {
    return PEM_write_PrivateKey(file, key.get(), nullptr, nullptr, 0, nullptr, nullptr);
  });
  create(files.certificate, 0644,
         [&](std::FILE* file) { return PEM_write_X509(file, certificate.get()); });
}

}  // namespace

CertificateFiles findOrMakeCertificate(const std::string& folder) {
  std::error_code ignored;
  fs::create_directories(folder, ignored);
  const CertificateFiles files{(fs::path(folder) / "certificate.pem").string(),
                               (fs::path(folder) / "key.pem").string()};
  const FolderLock lock(folder);
  if (!fs::exists(files.certificate) || !fs::exists(files.key)) make(files);
  return files;
}

std::string defaultCertificateFolder() {
  const char* state = std::getenv("XDG_STATE_HOME");
  const char* home = std::getenv("HOME");
  const fs::path base =
      state && *state ? fs::path(state) : fs::path(home ? home : ".") / ".local/state";
  return (base / "usarnaoqi").string();
}

}  // namespace nao::daemon

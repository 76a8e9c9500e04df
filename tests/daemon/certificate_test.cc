#include "daemon/certificate.h"

#include <gtest/gtest.h>
#include <openssl/pem.h>
#include <openssl/x509.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "tests/core/temporary_folder.h"

namespace nao::daemon {
namespace {

bool isReadable(const std::string& certificate) {
  const std::unique_ptr<std::FILE, decltype(&std::fclose)> file(
      std::fopen(certificate.c_str(), "r"), &std::fclose);
  if (!file) return false;
  const std::unique_ptr<X509, decltype(&X509_free)> read(
      PEM_read_X509(file.get(), nullptr, nullptr, nullptr), &X509_free);
  return read != nullptr;
}

// A serial number with a leading zero byte can not be read again: one of 256 drawn at random.
TEST(Certificate, CanBeReadWhateverSerialNumberWasDrawn) {
  const TemporaryFolder folder;
  for (int i = 0; i < 1500; ++i) {
    const CertificateFiles made = findOrMakeCertificate(folder.path() + "/tls");
    ASSERT_TRUE(isReadable(made.certificate)) << "certificate " << i;
    std::filesystem::remove(made.certificate);
  }
}

}  // namespace
}  // namespace nao::daemon

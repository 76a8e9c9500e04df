#include "daemon/certificate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openssl/pem.h>
#include <openssl/x509.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <thread>
#include <vector>

#include "tests/core/temporary_folder.h"

namespace nao::daemon {
namespace {

using File = std::unique_ptr<std::FILE, decltype(&std::fclose)>;

bool isPair(const CertificateFiles& files) {
  const File certificate_file(std::fopen(files.certificate.c_str(), "r"), &std::fclose);
  const File key_file(std::fopen(files.key.c_str(), "r"), &std::fclose);
  if (!certificate_file || !key_file) return false;
  const std::unique_ptr<X509, decltype(&X509_free)> certificate(
      PEM_read_X509(certificate_file.get(), nullptr, nullptr, nullptr), &X509_free);
  const std::unique_ptr<EVP_PKEY, decltype(&EVP_PKEY_free)> key(
      PEM_read_PrivateKey(key_file.get(), nullptr, nullptr, nullptr), &EVP_PKEY_free);
  return certificate && key && X509_check_private_key(certificate.get(), key.get()) == 1;
}

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

TEST(Certificate, ManyFirstStartsOnOneFolderMeetOnePair) {
  constexpr int kStarts = 8;
  for (int round = 0; round < 20; ++round) {
    const TemporaryFolder folder;
    std::array<bool, kStarts> is_pair{};
    std::vector<std::thread> starts;
    for (bool& mine : is_pair) {
      starts.emplace_back(
          [&mine, &folder] { mine = isPair(findOrMakeCertificate(folder.path() + "/tls")); });
    }
    for (std::thread& start : starts) start.join();
    EXPECT_THAT(is_pair, testing::Each(true)) << round;
  }
}

TEST(Certificate, TheKeyIsForItsUserAlone) {
  const TemporaryFolder folder;
  const CertificateFiles made = findOrMakeCertificate(folder.path() + "/tls");
  EXPECT_EQ(std::filesystem::status(made.key).permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
}

}  // namespace
}  // namespace nao::daemon

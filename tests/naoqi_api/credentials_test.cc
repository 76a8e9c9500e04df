#include "naoqi_api/credentials.h"

#include <gtest/gtest.h>

#include "core/check.h"
#include "tests/core/temporary_folder.h"
#include "tests/naoqi_api/test_client.h"

namespace nao::wire {
namespace {

/// A file that goes with the test.
class TextFile {
 public:
  explicit TextFile(const std::string& text) : path_(folder_.write("auth", text)) {}
  const std::string& path() const { return path_; }

 private:
  TemporaryFolder folder_;
  std::string path_;
};

TEST(Credentials, AcceptsThePairsOfItsFileAndNoOthers) {
  const TextFile file("# who may come\nnao secret\n\nother s3cret\n");
  const auto credentials = rpc::Credentials::load(file.path());
  EXPECT_TRUE(credentials.accept("nao", "secret"));
  EXPECT_TRUE(credentials.accept("other", "s3cret"));
  for (const auto& [user, token] :
       std::vector<std::pair<std::string, std::string>>{{"nao", "s3cret"},
                                                        {"nao", "secre"},
                                                        {"nao", "secret "},
                                                        {"", ""},
                                                        {"#", "who"},
                                                        {"nao", std::string("secret\0", 7)},
                                                        {"nao", std::string(300, 'x')}}) {
    EXPECT_FALSE(credentials.accept(user, token)) << user << " " << token;
  }
}

TEST(Credentials, SaysWhereTheFileIsWrong) {
  const TextFile file("nao secret\nalone\n");
  try {
    rpc::Credentials::load(file.path());
    FAIL() << "a user without a token";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind(file.path() + ":2: ", 0), 0U) << error.what();
  }
  EXPECT_THROW(rpc::Credentials::load("/nowhere"), InputError);
  const TextFile empty("# nobody\n");
  EXPECT_THROW(rpc::Credentials::load(empty.path()), InputError);
}

/// A hub that lets in user nao with token secret.
class GuardedHub : public testing::Test {
 protected:
  GuardedHub() {
    const TextFile file("nao secret\n");
    rpc::HubOptions options = DemoHub::options(rpc::Personality::naoqi(), {});
    options.credentials =
        std::make_shared<const rpc::Credentials>(rpc::Credentials::load(file.path()));
    hub_ = std::make_unique<rpc::ServiceHub>(options);
    hub_->add(demo_.describe());
    client_ = std::make_unique<TestClient>(*hub_);
  }

  void authenticate(const std::string& user, const std::string& token) {
    Message message;
    message.id = client_->next_id++;
    message.address = {0, 0, 8};
    const Value::Map map{"s", "m", {{"auth_user", user}, {"auth_token", token}}};
    encode(message.payload, map, Signature::of("{sm}"));
    client_->send(message);
  }

  rpc::Demo demo_;
  std::unique_ptr<rpc::ServiceHub> hub_;
  std::unique_ptr<TestClient> client_;
};

TEST_F(GuardedHub, LetsInWhoNamesAUserAndToken) {
  authenticate("nao", "secret");
  EXPECT_EQ(client_->next()->type, MessageType::Reply);
  client_->call({2, 1, 101}, Value::tuple({1, 2}));
  EXPECT_EQ(client_->nextValue("i"), Value(3));
}

TEST_F(GuardedHub, ClosesAfterThreeFailures) {
  for (int k = 0; k < 3; ++k) {
    EXPECT_FALSE(client_->connection->wantsClose());
    authenticate("nao", "wrong");
    EXPECT_EQ(client_->next()->type, MessageType::Error);
    EXPECT_FALSE(client_->connection->isOpen());
  }
  EXPECT_TRUE(client_->connection->wantsClose());
}

TEST_F(GuardedHub, RefusesOlderOpenings) {
  client_->call({1, 1, 2}, Value::tuple({0U}));
  EXPECT_EQ(client_->next()->type, MessageType::Error);
  Message capabilities;
  capabilities.type = MessageType::Capability;
  encode(capabilities.payload, Value::Map{"s", "m", {}}, Signature::of("{sm}"));
  client_->send(capabilities);
  EXPECT_FALSE(client_->next());
  client_->call({2, 1, 101}, Value::tuple({1, 2}));
  EXPECT_EQ(client_->next()->type, MessageType::Error);
  EXPECT_FALSE(client_->connection->isOpen());
}

}  // namespace
}  // namespace nao::wire

#include "runtime/database.h"

#include <sqlite3.h>

#include <filesystem>

#include "core/check.h"

namespace nao::runtime {

Database::Database(const std::string& file, Access access) : file_(file) {
  int flags = SQLITE_OPEN_READWRITE;  // a file whose writer was killed is mended when it is read
  if (access == Access::Create) flags |= SQLITE_OPEN_CREATE;
  if (access == Access::Read && !std::filesystem::exists(file)) fail("there is no such file");
  sqlite3* connection = nullptr;
  int result = sqlite3_open_v2(file.c_str(), &connection, flags, nullptr);
  if (result != SQLITE_OK && access == Access::Read) {
    sqlite3_close(connection);
    result = sqlite3_open_v2(file.c_str(), &connection, SQLITE_OPEN_READONLY, nullptr);
  }
  connection_.reset(connection, sqlite3_close_v2);
  if (result != SQLITE_OK) fail(sqlite3_errmsg(connection));
}

void Database::fail(const std::string& sentence) const {
  throw InputError(file_ + ": " + sentence);
}

void Database::run(const std::string& sql) {
  if (sqlite3_exec(connection_.get(), sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK) return;
  fail(sqlite3_errmsg(connection_.get()));
}

Database::Statement Database::prepare(const std::string& sql) {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(connection_.get(), sql.c_str(), -1, &statement, nullptr) != SQLITE_OK) {
    fail(sqlite3_errmsg(connection_.get()));
  }
  return {*this, statement};
}

Database::Statement::Statement(Database& database, sqlite3_stmt* statement)
    : database_(&database), statement_(statement, sqlite3_finalize) {}

void Database::Statement::check(int result) const {
  if (result != SQLITE_OK) database_->fail(sqlite3_errmsg(database_->connection_.get()));
}

Database::Statement& Database::Statement::bind(int place, std::int64_t value) {
  check(sqlite3_bind_int64(statement_.get(), place, value));
  return *this;
}

Database::Statement& Database::Statement::bind(int place, double value) {
  check(sqlite3_bind_double(statement_.get(), place, value));
  return *this;
}

Database::Statement& Database::Statement::bind(int place, const std::string& text) {
  check(sqlite3_bind_text(statement_.get(), place, text.data(), static_cast<int>(text.size()),
                          SQLITE_TRANSIENT));
  return *this;
}

Database::Statement& Database::Statement::bind(int place, const Bytes& bytes) {
  check(sqlite3_bind_blob64(statement_.get(), place, bytes.data(), bytes.size(), SQLITE_TRANSIENT));
  return *this;
}

bool Database::Statement::next() {
  const int result = sqlite3_step(statement_.get());
  if (result == SQLITE_ROW) return true;
  check(sqlite3_reset(statement_.get()));
  if (result != SQLITE_DONE) check(result);
  return false;
}

std::int64_t Database::Statement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double Database::Statement::number(int column) const {
  return sqlite3_column_double(statement_.get(), column);
}

std::string Database::Statement::text(int column) const {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  return text ? text : "";
}

Bytes Database::Statement::bytes(int column) const {
  const auto* first =
      static_cast<const unsigned char*>(sqlite3_column_blob(statement_.get(), column));
  return {first, first + sqlite3_column_bytes(statement_.get(), column)};
}

}  // namespace nao::runtime

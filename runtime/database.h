#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace nao::runtime {

using Bytes = std::vector<unsigned char>;

/// One SQLite file. All that goes wrong is an InputError with the file's name.
class Database {
 public:
  enum class Access { Read, Create };
  /// Create: in place of a file that is there.
  Database(const std::string& file, Access access);

  void run(const std::string& sql);

  /// Values go in by their places from 1 on and come out by columns from 0 on.
  class Statement {
   public:
    Statement& bind(int place, std::int64_t value);
    Statement& bind(int place, double value);
    Statement& bind(int place, const std::string& text);
    Statement& bind(int place, const Bytes& bytes);
    /// True while there is a row; else it is ready for its next run.
    bool next();
    std::int64_t integer(int column) const;
    double number(int column) const;
    std::string text(int column) const;
    Bytes bytes(int column) const;

   private:
    friend class Database;
    Statement(Database& database, sqlite3_stmt* statement);
    void check(int result) const;

    Database* database_;
    std::shared_ptr<sqlite3_stmt> statement_;
  };
  Statement prepare(const std::string& sql);

  const std::string& file() const { return file_; }
  [[noreturn]] void fail(const std::string& sentence) const;

 private:
  std::string file_;
  std::shared_ptr<sqlite3> connection_;
};

}  // namespace nao::runtime

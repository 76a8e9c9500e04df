#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "validation/diagnosis/jobs/team.h"

namespace nao::validation::test {

/// Threads that stand for processes.
class ThreadTeam final : public Team {
 public:
  /// Runs `work` once per member, all at the same time.
  static void run(std::size_t size, const std::function<void(const Team&)>& work) {
    Table table;
    table.said.resize(size);
    std::vector<std::thread> threads;
    for (std::size_t rank = 0; rank < size; ++rank) {
      threads.emplace_back([&, rank] { work(ThreadTeam(table, rank)); });
    }
    for (std::thread& thread : threads) thread.join();
  }

  std::size_t rank() const override { return rank_; }
  std::size_t size() const override { return table_.said.size(); }
  std::vector<std::string> exchange(const std::string& mine) const override {
    std::unique_lock lock(table_.mutex);
    table_.said[rank_] = mine;
    const int round = table_.round;
    if (++table_.here == size()) {
      table_.heard = table_.said;
      table_.here = 0;
      ++table_.round;
      table_.all_said.notify_all();
    } else {
      table_.all_said.wait(lock, [&] { return table_.round != round; });
    }
    return table_.heard;
  }

 private:
  struct Table {
    std::mutex mutex;
    std::condition_variable all_said;
    std::vector<std::string> said, heard;
    std::size_t here = 0;
    int round = 0;
  };

  ThreadTeam(Table& table, std::size_t rank) : table_(table), rank_(rank) {}

  Table& table_;
  std::size_t rank_;
};

}  // namespace nao::validation::test

#pragma once

#include <functional>
#include <string>
#include <vector>

namespace nao::validation {

/// The processes that work on one diagnosis: all take the same steps, each with pieces of its own.
/// One process by itself is a team too. One thread.
class Team {
 public:
  virtual ~Team() = default;
  virtual std::size_t rank() const { return 0; }
  virtual std::size_t size() const { return 1; }
  /// What every process has to say, by rank; waits until all have said it.
  virtual std::vector<std::string> exchange(const std::string& mine) const { return {mine}; }
  /// Ends all processes, as this one can not go on.
  virtual void abandon(int /*exit_code*/) const {}

  bool owns(std::size_t piece) const { return piece % size() == rank(); }
};

/// Runs `work(i)` for all i < count on several threads; every i belongs to one thread from the
/// start, so that results do not depend on their number.
void inParallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

/// `work(i)` for all i < count, each by a thread of the process that owns i; every process gets all
/// of them, by i. `question` is the same in all processes, or else they have come apart: @throws
/// InputError.
std::vector<std::string> askAll(const Team& team, const std::string& question, std::size_t count,
                                int jobs, const std::function<std::string(std::size_t)>& work);

/// What the first process has to say.
std::string askFirst(const Team& team, const std::string& question,
                     const std::function<std::string()>& work);

}  // namespace nao::validation

#include "validation/diagnosis/jobs/team.h"

#include <algorithm>
#include <future>
#include <nlohmann/json.hpp>

#include "core/check.h"

namespace nao::validation {
namespace {

using Json = nlohmann::json;

std::string packed(const std::string& question, const std::vector<std::string>& answers) {
  Json all = Json::array({question});
  for (const std::string& answer : answers) {
    all.push_back(Json::binary({answer.begin(), answer.end()}));
  }
  std::string bytes;
  Json::to_cbor(all, bytes);
  return bytes;
}

// The pieces of one process, in their order.
std::vector<std::string> unpacked(const std::string& bytes, const std::string& question) {
  const Json all = Json::from_cbor(bytes, true, false);
  if (!all.is_array() || all.empty() || all[0] != question) {
    throw InputError("the processes of this diagnosis have come apart at '" + question +
                     "': expected the same program, set and model on all machines");
  }
  std::vector<std::string> answers;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const auto& binary = all[i].get_binary();
    answers.emplace_back(binary.begin(), binary.end());
  }
  return answers;
}

}  // namespace

void inParallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work) {
  const auto threads = static_cast<std::size_t>(std::max(1, jobs));
  std::vector<std::future<void>> running;
  for (std::size_t first = 1; first < threads && first < count; ++first) {
    running.push_back(std::async(std::launch::async, [=, &work] {
      for (std::size_t i = first; i < count; i += threads) work(i);
    }));
  }
  for (std::size_t i = 0; i < count; i += threads) work(i);
  for (auto& one : running) one.get();
}

std::vector<std::string> askAll(const Team& team, const std::string& question, std::size_t count,
                                int jobs, const std::function<std::string(std::size_t)>& work) {
  std::vector<std::size_t> mine;
  for (std::size_t i = 0; i < count; ++i) {
    if (team.owns(i)) mine.push_back(i);
  }
  std::vector<std::string> answers(mine.size()), all(count);
  inParallel(mine.size(), jobs, [&](std::size_t i) { answers[i] = work(mine[i]); });
  if (team.size() == 1) return answers;
  const std::vector<std::string> said = team.exchange(packed(question, answers));
  for (std::size_t rank = 0; rank < said.size(); ++rank) {
    std::size_t piece = rank;
    for (std::string& answer : unpacked(said[rank], question)) {
      all.at(piece) = std::move(answer);
      piece += team.size();
    }
  }
  return all;
}

std::string askFirst(const Team& team, const std::string& question,
                     const std::function<std::string()>& work) {
  return askAll(team, question, 1, 1, [&](std::size_t) { return work(); }).front();
}

}  // namespace nao::validation

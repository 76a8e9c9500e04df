// The processes that mpirun started, as a Team: libusarnaoqi_mpi.so, loaded by usarnaoqi only where
// it is one of several.
#include <boost/mpi/collectives/all_gather.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include "validation/diagnosis/jobs/team.h"

namespace {

class MpiTeam final : public nao::validation::Team {
 public:
  std::size_t rank() const override { return static_cast<std::size_t>(world_.rank()); }
  std::size_t size() const override { return static_cast<std::size_t>(world_.size()); }
  std::vector<std::string> exchange(const std::string& mine) const override {
    std::vector<std::string> all;
    boost::mpi::all_gather(world_, mine, all);
    return all;
  }
  void abandon(int exit_code) const override { boost::mpi::environment::abort(exit_code); }

 private:
  // One thread of a process speaks to others.
  boost::mpi::environment environment_{boost::mpi::threading::funneled, false};
  boost::mpi::communicator world_;
};

}  // namespace

extern "C" nao::validation::Team* usarnaoqi_join_team() { return new MpiTeam; }

#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "validation/diagnosis/causes/chosen.h"
#include "validation/diagnosis/ensemble/ensemble.h"
#include "validation/diagnosis/ensemble/joint_data.h"
#include "validation/diagnosis/maths/whitening.h"

namespace nao::validation {

/// How much a diagnosis simulates, in multiples of four: runs mirror each other in pairs, so that
/// a mean of 16 is as certain as one of 60 that know nothing of each other, and before encoders
/// round it of 300. What causes change is seen before.
struct Effort {
  int look_runs = 4;           // per motion, of a candidate's looks and first fit
  int final_runs = 8;          // of the fits of finalists
  int base_runs = 16;          // exact ones, of the model that the measurement is compared with
  int null_sets = 200;         // drawn from those
  int survivors = 8;           // candidates that are fitted at all
  int finalists = 4;           // that are fitted with final_runs
  int most_causes = 4;         // named for one joint
  double false_alarms = 0.01;  // that thresholds let pass, of null sets of the whole set
  int slope_runs = 4;          // exact ones, to either side of a number that was found
  int difference_runs = 8;     // of what equal robots differ by: its chance stays in the numbers
  int brief_runs = 8;          // exact ones, where a number is only moved to
  int spread_runs = 48;        // that show how noise goes together
};

/// What switching a cause on does to the prediction, once, at its start values.
struct Look {
  std::size_t cause = 0;
  std::vector<double> x;
  Halves raw;                   // change of the predicted mean of the fit motions
  Halves white;                 // the same, whitened
  double lower = 0, upper = 0;  // how far it may be scaled
};

/// One of what equal robots differ by, as a residual shows it.
struct SmallDifference {
  std::size_t cause = 0;
  double x = 0, sd = 0;  // the likeliest number, and what it may still be off by
  double known = 0;      // part of its spread that the data take away: 0 nothing, 1 all
};

/// A model, compared with the measurement: residual, its whitening, what the residual would be if
/// the model were right, and, once looked around, what every other cause would do.
class Stage {
 public:
  /// `jacobian`: the change of the prediction per number of the model, column by column. `given`:
  /// causes that the ensemble has anyway.
  Stage(Ensemble& ensemble, const JointData& data, const std::vector<Cause>& causes,
        CauseList model, const Eigen::MatrixXd& jacobian, const Effort& effort,
        const std::vector<std::size_t>& given = {});

  /// The model of `full` without one of its causes, by what `full` saw: coarse runs tell what is
  /// missing, looks are at the cause that is missing alone. `jacobian`: of the numbers that stay.
  Stage(const Stage& full, std::size_t without, const Eigen::MatrixXd& jacobian);

  /// Residuals of data sets measured again at this model, undeclared differences included but for
  /// those in the model's own numbers; drawn from the runs that the model's own mean is made of.
  void simulateNulls(const std::string& joint);

  /// Looks at every cause that the model has not. What an earlier stage of the joint has seen of
  /// one is taken as it was seen there: beside another model it did nearly the same.
  void lookAround(const Stage* earlier = nullptr);

  const CauseList& model() const { return model_; }
  /// Whether the model has the cause, or everything here has.
  bool isTaken(std::size_t cause) const;
  const std::vector<Look>& looks() const { return looks_; }
  /// Causes that the budget left no runs to look at.
  const std::vector<std::size_t>& unseen() const { return unseen_; }
  /// Measured minus predicted mean, as measured.
  const Eigen::VectorXd& raw() const { return raw_; }
  /// The mean of the model's runs, and the SD of a single one.
  const Eigen::VectorXd& predicted() const { return pool_.mean; }
  Eigen::VectorXd scatter() const;
  /// The prediction of the model by Effort::look_runs runs of the fit motions, to subtract from
  /// others of as many.
  const Halves& quickBase() const { return quick_base_; }
  /// The same by rough runs.
  const Halves& lookBase() const { return look_base_; }
  Eigen::Index fitSize() const { return data_.fitSize(); }
  const Eigen::MatrixXd& jacobian() const { return jacobian_; }
  const std::vector<Eigen::VectorXd>& nulls() const { return nulls_; }  // raw

  /// A residual of all motions: its fit motions whitened, and what the model's own numbers could
  /// still explain taken off.
  Eigen::VectorXd white(const Eigen::VectorXd& raw) const;
  Halves white(const Halves& raw) const;
  /// The same for all motions, for the remainder.
  Eigen::VectorXd whiteAll(const Eigen::VectorXd& raw) const;
  /// Whitened only: fit motions, or all.
  Eigen::VectorXd whitenFit(const Eigen::VectorXd& raw) const;
  Halves whitenFit(const Halves& raw) const;
  Eigen::VectorXd whitenAll(const Eigen::VectorXd& raw) const { return all_(raw); }

  /// What equal robots differ by, where a residual of all motions is left by the model's numbers at
  /// their best: those of the joint itself that are not among them.
  std::vector<SmallDifference> smallDifferences(const Eigen::VectorXd& raw) const;

  /// What a look explains of a white() residual at its best scale [nats].
  static double gain(const Look& look, const Eigen::VectorXd& white, double* scale = nullptr);
  /// The largest gain of any look.
  double largestGain(const Eigen::VectorXd& white) const;

 private:
  bool takeLooks(const Stage& earlier, std::size_t cause);
  void lookAt(std::size_t cause);
  void lookAt(std::size_t cause, const std::vector<double>& x);
  void scan(std::size_t cause);
  void setJacobian(const Eigen::MatrixXd& jacobian);
  Eigen::MatrixXd directions(const Effort& effort, double start_sd);
  void addModel(std::vector<Eigen::VectorXd>& columns) const;
  void simulateDifferences(const Effort& effort);
  Halves difference(const Cause& cause, const std::vector<Joint>& joints, const Halves& base,
                    const Effort& effort);

  const JointData& data_;
  const std::vector<Cause>& causes_;
  Ensemble& ensemble_;
  CauseList model_;
  std::vector<std::size_t> given_;
  Eigen::MatrixXd jacobian_;
  Effort effort_;
  RunPool pool_;
  Eigen::VectorXd raw_;
  Halves quick_base_, look_base_;  // by coarse and by rough runs
  std::vector<Look> looks_;
  std::vector<std::size_t> unseen_;
  // One SD of each difference between equal robots but for the model's own numbers: of this joint,
  // then what the links that it carries weigh. The whitening knows them by the one half of the
  // runs, null sets by the other, so that these show what chance leaves in.
  std::vector<Halves> differences_;
  std::vector<std::size_t> undeclared_causes_;  // of the joint's own
  Whitening fit_, all_;
  Eigen::MatrixXd own_fit_, own_all_;  // orthonormal: what the model's numbers explain
  std::vector<Eigen::VectorXd> nulls_;
};

}  // namespace nao::validation

#pragma once

#include <vector>

#include "core/world_model.h"
#include "sim/ball_body.h"
#include "sim/collision_body.h"
#include "sim/contact_solver.h"
#include "sim/robot_body.h"

namespace nao::sim {

/// Contact between all that moves: robots with each other and with themselves, balls with robots,
/// balls, obstacles and the ground; found from the state at the start of the step, in a fixed
/// order. Robots touch with the collision solids of their model. (A robot on the ground or on an
/// obstacle is GroundContact's.)
class Touching {
 public:
  explicit Touching(const WorldModel& world) : world_(world) {}

  /// The next robot of the world; its model must outlive this.
  void add(const RobotModel& model) { solids_.emplace_back(model); }

  /// Moves the balls on by `h` [s] and says what pushes each robot meanwhile: `on_robots`, by
  /// index, is cleared first.
  void step(const std::vector<RobotBody*>& robots, std::vector<BallState>& balls, double h,
            std::vector<std::vector<ExternalForce>>& on_robots);
  /// Adds what pushed robots in the last step.
  void report(ContactReport& report) const;

 private:
  using Side = ContactSolver::Side;
  struct Solid {  // one side of a possible contact
    Side side;
    const Shape& shape;
    Pose X_WS;
    const Material& material;
  };
  void findBetweenRobots(const std::vector<RobotBody*>& robots);
  void findOfRobot(std::size_t r, const RobotBody& robot);
  void findOfBall(std::size_t b, const std::vector<RobotBody*>& robots,
                  const std::vector<BallState>& balls, double h);
  void touchGround(std::size_t b, const BallState& ball, double margin);
  void touch(const Solid& a, const Solid& b, double margin);
  void handOut(std::vector<std::vector<ExternalForce>>& on_robots);
  Solid solidOf(std::size_t r, std::size_t i, const RobotBody& robot) const;

  const WorldModel& world_;
  std::vector<CollisionBody> solids_;  // by robot
  ContactSolver solver_;
  std::vector<bool> resting_;  // by ball, for the length of a step
};

}  // namespace nao::sim

#include "core/robot_model_parts.h"

// Masses as they are published: a robot of the same tree but of another year has other solids.

namespace nao {
namespace {

// [xx, yy, zz, xy, xz, yz], the order of the tables.
Mat3 tensorAt(Config& solid, const std::string& key) {
  const auto i = solid.numbers(key, 6);
  Mat3 tensor;
  tensor << i[0], i[3], i[4],  //
      i[3], i[1], i[5],        //
      i[4], i[5], i[2];
  return tensor;
}

void readSolid(Config& solid, Body& body) {
  body.mass = solid.number("mass", kPositive);
  body.p_BoBcm = solid.vector("com");
  const Vec3& c = body.p_BoBcm;
  if (solid.has("inertia_at_origin")) {
    body.I_Bcm = tensorAt(solid, "inertia_at_origin") -
                 body.mass * (c.squaredNorm() * Mat3::Identity() - c * c.transpose());
  } else {
    body.I_Bcm = tensorAt(solid, "inertia_at_com");
  }
  const std::string flaw = flawOf(body);
  if (!flaw.empty()) solid.fail(flaw);
}

}  // namespace

void readSolids(Config& body, RobotModel& model) {
  body.map("solids", Config::Presence::Optional, [&](Config& solids) {
    for (const std::string& name : solids.keys()) {
      const auto found = model.findBody(name);
      if (!found) solids.reject(name, "the name of a link of model.urdf");
      solids.map(name, Config::Presence::Required, [&](Config& solid) {
        readSolid(solid, model.bodies[static_cast<std::size_t>(*found)]);
      });
    }
  });
}

}  // namespace nao

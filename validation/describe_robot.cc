#include "validation/describe_robot.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace nao::validation {
namespace {

constexpr double kDegrees = 180 / M_PI;

std::string textOf(double value) {
  std::ostringstream text;
  text.precision(6);
  text << value;
  return text.str();
}

std::string textOf(const Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return textOf(*number);
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  std::string list;
  for (const double number : std::get<std::vector<double>>(cell)) {
    list += (list.empty() ? "" : " ") + textOf(number);
  }
  return list;
}

// The same rows for programs and for people.
void addTable(const std::string& name, const std::vector<Row>& rows, Report& report) {
  report.figures.push_back({name, rows});
  if (rows.empty()) return;
  TextTable table{name, {}, {}};
  for (const auto& [head, unused] : rows.front()) table.head.push_back(head);
  for (const Row& row : rows) {
    table.lines.emplace_back();
    for (const auto& [unused, cell] : row) table.lines.back().push_back(textOf(cell));
  }
  report.tables.push_back(table);
}

std::vector<double> numbersOf(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

std::string bodyName(const RobotModel& model, int body) {
  return body < 0 ? "" : model.bodies[static_cast<std::size_t>(body)].name;
}

std::string jointName(const RobotModel& model, Joint joint) {
  return model.actuators[index(joint)].name;
}

std::vector<Row> robotRows(const RobotModel& model) {
  return {{{"name", model.name},
           {"body_type", model.body_type},
           {"version", model.version},
           {"mass_kg", model.totalMass()},
           {"joints", static_cast<double>(model.jointCount())},
           {"cycle_ms", toSeconds(model.cycle) * 1e3},
           {"base", std::string(model.fixed_base ? "bolted" : "free")},
           {"start", model.start_posture}}};
}

std::vector<Row> bodyRows(const RobotModel& model) {
  std::vector<Row> rows;
  for (const Body& body : model.bodies) {
    const Mat3& I = body.I_Bcm;
    rows.push_back({{"body", body.name},
                    {"parent", bodyName(model, body.parent)},
                    {"mass_kg", body.mass},
                    {"com_m", numbersOf(body.p_BoBcm)},
                    {"Ixx_Iyy_Izz_kgm2", numbersOf(I.diagonal())},
                    {"Ixy_Ixz_Iyz_kgm2", numbersOf(Vec3(I(0, 1), I(0, 2), I(1, 2)))},
                    {"solids", static_cast<double>(body.collisions.size())}});
  }
  return rows;
}

std::string hingesOf(const RobotModel& model, const Actuator& motor) {
  std::string names;
  for (const int c : motor.coordinates) {
    names += (names.empty() ? "" : " ") + model.coordinates[static_cast<std::size_t>(c)].name;
  }
  return names;
}

std::vector<Row> jointRows(const RobotModel& model) {
  std::vector<Row> rows;
  for (const Actuator& motor : model.actuators) {
    rows.push_back({{"joint", motor.name},
                    {"hinges", hingesOf(model, motor)},
                    {"min_rad", motor.lower},
                    {"max_rad", motor.upper},
                    {"min_deg", motor.lower * kDegrees},
                    {"max_deg", motor.upper * kDegrees},
                    {"max_rad_per_s", motor.max_velocity},
                    {"max_Nm", motor.max_torque}});
  }
  return rows;
}

std::vector<Row> motorRows(const RobotModel& model) {
  std::vector<Row> rows;
  for (const Actuator& motor : model.actuators) {
    rows.push_back({{"joint", motor.name},
                    {"stall_Nm", motor.stall_torque},
                    {"efficiency", motor.efficiency},
                    {"no_load_rad_per_s", motor.no_load_speed},
                    {"rotor_kgm2", motor.rotor_inertia},
                    {"kp_Nm_per_rad", motor.kp},
                    {"kd_Nms_per_rad", motor.kd},
                    {"board", static_cast<double>(motor.board)}});
  }
  return rows;
}

std::vector<Row> coupledRows(const RobotModel& model) {
  std::vector<Row> rows;
  for (const CoupledLimit& limit : model.coupled_limits) {
    for (const CoupledLimit::Row& row : limit.rows) {
      rows.push_back({{"driver", jointName(model, limit.driver)},
                      {"limited", jointName(model, limit.limited)},
                      {"driver_rad", row.driver},
                      {"min_rad", row.min},
                      {"max_rad", row.max},
                      {"stop", std::string(limit.stop ? "yes" : "no")},
                      {"clip", std::string(limit.clip ? "yes" : "no")}});
    }
  }
  return rows;
}

std::vector<Row> cameraRows(const RobotModel& model) {
  std::vector<Row> rows;
  for (const CameraModel& camera : model.cameras) {
    rows.push_back({{"camera", camera.name},
                    {"body", bodyName(model, camera.body)},
                    {"hfov_deg", camera.hfov * kDegrees},
                    {"vfov_deg", camera.vfov * kDegrees},
                    {"max_px", std::vector<double>{static_cast<double>(camera.max_width),
                                                   static_cast<double>(camera.max_height)}},
                    {"max_fps", static_cast<double>(camera.frame_rates.back())}});
  }
  return rows;
}

std::vector<Row> sensorRows(const RobotModel& model) {
  std::vector<Row> rows;
  const auto add = [&](const char* sensor, double count, const std::string& more) {
    rows.push_back({{"sensor", std::string(sensor)}, {"count", count}, {"more", more}});
  };
  add("encoders", static_cast<double>(model.jointCount()), "");
  add("gyroscope axes", model.gyro_axes, "on " + bodyName(model, model.imu_body));
  add("force sensors", 4.0 * static_cast<double>(model.feet.size()), "four to a foot");
  const SonarModel& sonar = model.sonar;
  if (!sonar.receivers.empty()) {
    add("sonar receivers", static_cast<double>(sonar.receivers.size()),
        textOf(sonar.min_range) + " to " + textOf(sonar.max_range) + " m, cone " +
            textOf(2 * sonar.half_cone * kDegrees) + " deg");
  }
  return rows;
}

std::vector<Row> effectRows(const RobotModel& model) {
  std::vector<Row> rows;
  const auto add = [&](const EffectSetting& effect, const char* when) {
    std::string parameters;
    for (const auto& [name, value] : effect.parameters) {
      parameters += (parameters.empty() ? "" : ", ") + name + " " + textOf(value);
    }
    std::string joints;
    for (const Joint joint : effect.joints) {
      joints += (joints.empty() ? "" : " ") + jointName(model, joint);
    }
    rows.push_back({{"effect", effect.name},
                    {"when", std::string(when)},
                    {"parameters", parameters},
                    {"joints", joints.empty() ? "all" : joints}});
  };
  for (const EffectSetting& effect : model.effects) add(effect, "always");
  for (const EffectSetting& effect : model.variation) add(effect, "with a seed");
  return rows;
}

std::vector<Row> postureRows(const RobotModel& model) {
  std::vector<Row> rows;
  for (const Posture& posture : model.postures) {
    rows.push_back({{"posture", posture.name}, {"family", posture.family}});
  }
  return rows;
}

std::vector<Row> noteRows(const RobotModel& model) {
  std::vector<Row> rows;
  for (const std::string& note : model.notes) rows.push_back({{"note", note}});
  return rows;
}

}  // namespace

Report describeRobot(const RobotModel& model) {
  Report report;
  report.command = "describe";
  report.robot = model.name;
  addTable("robot", robotRows(model), report);
  addTable("bodies", bodyRows(model), report);
  addTable("joints", jointRows(model), report);
  addTable("motors", motorRows(model), report);
  addTable("coupled_limits", coupledRows(model), report);
  addTable("cameras", cameraRows(model), report);
  addTable("sensors", sensorRows(model), report);
  addTable("effects", effectRows(model), report);
  addTable("postures", postureRows(model), report);
  report.figures.push_back({"notes", noteRows(model)});
  report.remarks = model.notes;
  return report;
}

}  // namespace nao::validation

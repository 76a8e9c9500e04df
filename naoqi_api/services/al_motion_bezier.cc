#include "naoqi_api/services/al_motion_bezier.h"

#include "motion/trajectory.h"
#include "naoqi_api/call_error.h"
#include "naoqi_api/services/al_motion_names.h"

namespace nao::services {
namespace {

using Items = std::vector<rpc::Value>;

const Items& itemsOf(const rpc::Value& value, const char* what) {
  const Items* items = value.findItems();
  if (items == nullptr) throw rpc::CallError(std::string("expected ") + what);
  return *items;
}

motion::Handle readHandle(const rpc::Value& value) {
  const Items& parts = itemsOf(value, "a handle [type, dTime, dAngle]");
  if (parts.size() != 3) throw rpc::CallError("expected a handle [type, dTime, dAngle]");
  const double type = readNumber(parts[0]);
  if (type != 0 && type != 1 && type != 2 && type != 3) {
    throw rpc::CallError("the type of a handle is 0, 1, 2 or 3");
  }
  return {static_cast<motion::Handle::Kind>(static_cast<int>(type)), readNumber(parts[1]),
          readNumber(parts[2])};
}

// Handles that are not written stay as `automatic`.
struct WrittenKey {
  double angle = 0;
  const rpc::Value* before = nullptr;
  const rpc::Value* after = nullptr;
};

WrittenKey readKey(const rpc::Value& value) {
  const Items* parts = value.findItems();
  if (parts == nullptr) return {readNumber(value), nullptr, nullptr};
  if (parts->empty() || parts->size() > 3) {
    throw rpc::CallError("expected a key [angle, handle, handle]");
  }
  WrittenKey key{readNumber((*parts)[0]), nullptr, nullptr};
  if (parts->size() > 1) key.before = &(*parts)[1];
  if (parts->size() > 2) key.after = &(*parts)[2];
  return key;
}

motion::Curve readCurve(Joint joint, double present, const rpc::Value& times,
                        const rpc::Value& values) {
  const rpc::Value one_time = times.isList() ? times : rpc::Value::list({times});
  const rpc::Value one_key = values.isList() ? values : rpc::Value::list({values});
  const Items& key_times = *one_time.findItems();
  const Items& keys = *one_key.findItems();
  if (key_times.size() != keys.size()) {
    throw rpc::CallError("expected one time per key, got " + std::to_string(key_times.size()) +
                         " for " + std::to_string(keys.size()));
  }
  motion::Curve curve;
  curve.joint = joint;
  std::vector<WrittenKey> written;
  double before = 0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    written.push_back(readKey(keys[i]));
    motion::Key key;
    key.time = readNumber(key_times[i]);
    key.angle = written.back().angle;
    if (key.time <= before) throw rpc::CallError("times must be positive and ascending");
    before = key.time;
    curve.keys.push_back(key);
  }
  motion::setAutoHandles(present, curve.keys);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (written[i].before != nullptr) curve.keys[i].before = readHandle(*written[i].before);
    if (written[i].after != nullptr) curve.keys[i].after = readHandle(*written[i].after);
  }
  return curve;
}

}  // namespace

std::vector<motion::Curve> readBezierCurves(const RobotModel& model,
                                            const JointArray<double>& present,
                                            const std::vector<std::string>& names,
                                            const rpc::Value& times, const rpc::Value& keys) {
  const std::vector<Joint> joints = jointsNamed(model, names);
  const Items& all_times = itemsOf(times, "a list of times per joint");
  const Items& all_keys = itemsOf(keys, "a list of keys per joint");
  if (all_times.size() != joints.size() || all_keys.size() != joints.size()) {
    throw rpc::CallError("expected one list of times and one list of keys per joint, got " +
                         std::to_string(all_times.size()) + " and " +
                         std::to_string(all_keys.size()) + " for " + std::to_string(joints.size()) +
                         " joints");
  }
  std::vector<motion::Curve> curves;
  motion::JointSet seen;  // LHipYawPitch wins over RHipYawPitch
  for (std::size_t i = 0; i < joints.size(); ++i) {
    motion::Curve curve = readCurve(joints[i], present[joints[i]], all_times[i], all_keys[i]);
    if (seen.test(index(joints[i]))) continue;
    seen.set(index(joints[i]));
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace nao::services

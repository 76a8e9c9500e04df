#pragma once

#include <optional>
#include <string>

namespace nao::validation {

/// A column of RobotLog 1 as NAOqi's ALMemory holds it.
struct MemoryColumn {
  std::string column;
  double scale = 1;  // value in the column = scale * value in memory
};

/// The column of a key such as Device/SubDeviceList/HeadYaw/Position/Sensor/Value, of NAOqi 1.14 to
/// 2.8; nothing for keys that have none.
std::optional<MemoryColumn> findMemoryColumn(const std::string& key);

/// The joint in a column such as "q.HeadYaw"; empty for columns that belong to none.
std::string findColumnJoint(const std::string& column);

}  // namespace nao::validation

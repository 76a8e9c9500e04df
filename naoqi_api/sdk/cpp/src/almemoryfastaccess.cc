#include <almemoryfastaccess/almemoryfastaccess.h>

namespace AL {
namespace {

bool isNumber(const ALValue& value) { return value.isFloat() || value.isInt() || value.isBool(); }

}  // namespace

void ALMemoryFastAccess::ConnectToVariables(boost::shared_ptr<ALBroker> broker,
                                            const std::vector<std::string>& keys,
                                            bool leave_out_missing) {
  memory_ = broker->getProxy("ALMemory");
  keys_ = ALValue();
  keys_.arraySetSize(0);
  for (const std::string& key : keys) {
    try {
      memory_->callVoid("getData", key);
      keys_.arrayPush(key);
    } catch (const ALError&) {
      if (leave_out_missing) continue;
      throw ALERROR("ALMemoryFastAccess", "ConnectToVariables", "Data not found " + key);
    }
  }
}

ALValue ALMemoryFastAccess::read() const {
  if (!memory_) {
    throw ALERROR("ALMemoryFastAccess", "GetValues", "expected ConnectToVariables() before it");
  }
  return memory_->call<ALValue>("getListData", keys_);
}

void ALMemoryFastAccess::GetValues(std::vector<float>& values) {
  const ALValue read_now = read();
  values.resize(read_now.getSize());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ALValue& value = read_now[static_cast<int>(i)];
    values[i] = isNumber(value) ? static_cast<float>(value) : 0;
  }
}

void ALMemoryFastAccess::GetValues(ALValue& values) { values = read(); }

}  // namespace AL

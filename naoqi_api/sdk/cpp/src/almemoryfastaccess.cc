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

ALProxy& ALMemoryFastAccess::memory(const char* method) const {
  if (!memory_) {
    throw ALERROR("ALMemoryFastAccess", method, "expected ConnectToVariables() before it");
  }
  return *memory_;
}

template <class T>
void ALMemoryFastAccess::read(std::vector<T>& values) const {
  const auto read_now = memory("GetValues").call<ALValue>("getListData", keys_);
  values.resize(read_now.getSize());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ALValue& value = read_now[static_cast<int>(i)];
    values[i] = isNumber(value) ? static_cast<T>(value) : 0;
  }
}

void ALMemoryFastAccess::GetValues(std::vector<float>& values) const { read(values); }
void ALMemoryFastAccess::GetValues(std::vector<int>& values) const { read(values); }

void ALMemoryFastAccess::GetValues(ALValue& values) const {
  values = memory("GetValues").call<ALValue>("getListData", keys_);
}

void ALMemoryFastAccess::write(const ALValue& values) {
  ALProxy& memory_now = memory("SetValues");
  if (values.getSize() != keys_.getSize()) {
    throw ALERROR("ALMemoryFastAccess", "SetValues",
                  "expected " + std::to_string(keys_.getSize()) + " values, found " +
                      std::to_string(values.getSize()));
  }
  ALValue pairs;
  pairs.arraySetSize(0);
  for (int i = 0; i < static_cast<int>(values.getSize()); ++i) {
    pairs.arrayPush(ALValue::array(keys_[i], values[i]));
  }
  memory_now.callVoid("insertListData", pairs);
}

void ALMemoryFastAccess::SetValues(const std::vector<float>& values) { write(values); }
void ALMemoryFastAccess::SetValues(const std::vector<int>& values) { write(values); }

void ALMemoryFastAccess::insertBuffer(const std::string& key, const ALValue& bytes) {
  memory("insertBuffer").callVoid("insertData", key, bytes);
}

void* ALMemoryFastAccess::getDataPtr(boost::shared_ptr<ALBroker> broker, const std::string& key,
                                     bool leave_out_missing) {
  const boost::shared_ptr<ALProxy> memory = broker->getProxy("ALMemory");
  try {
    memory->callVoid("getData", key);
  } catch (const ALError&) {
    if (leave_out_missing) return nullptr;
    throw;
  }
  return detail::memoryPointer(*memory, key);
}

}  // namespace AL

#include "naoqi_api/sdk/cpp/src/memory_pointers.h"

#include <usarnaoqi_sdk/memory_pointer.h>

#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <mutex>

namespace nao::client {
namespace {

using AL::ALProxy;
using AL::ALValue;

struct Cell {
  std::uint32_t bits = 0;  // the module's pointer is to these
  std::uint32_t read = 0;  // as they came from ALMemory
  bool is_float = false;
};

struct Cells {
  std::mutex mutex;  // of the rest, but for the bits
  boost::shared_ptr<ALProxy> memory;
  std::map<std::string, Cell> all;  // whose addresses stay
};

// Never destroyed: a module may read its pointers to the very end.
Cells& cells() {
  static Cells* const the_cells = new Cells;
  return *the_cells;
}

bool isOf32Bits(const ALValue& value) { return value.isInt() || value.isFloat(); }

void take(Cell& cell, ALValue value) {
  if (!isOf32Bits(value)) return;  // removed, or another type: it stays as it was
  std::memcpy(&cell.read, value.getPtrValue(), sizeof cell.read);
  cell.bits = cell.read;
  cell.is_float = value.isFloat();
}

ALValue valueOf(const Cell& cell) {
  ALValue value = cell.is_float ? ALValue(0.0F) : ALValue(0);
  std::memcpy(value.getPtrValue(), &cell.bits, sizeof cell.bits);
  return value;
}

void refresh(ALProxy& memory, std::map<std::string, Cell>& all) {
  ALValue keys, written;
  for (auto& [key, cell] : all) {
    keys.arrayPush(key);
    if (cell.bits != cell.read) written.arrayPush(ALValue::array(key, valueOf(cell)));
    cell.read = cell.bits;  // what ALMemory refuses is told once
  }
  if (written.isArray()) memory.callVoid("insertListData", written);
  const auto values = memory.call<ALValue>("getListData", keys);
  int at = 0;
  for (auto& [key, cell] : all) take(cell, values[at++]);
}

}  // namespace

std::vector<std::string> refreshMemoryPointers() {
  const std::lock_guard lock(cells().mutex);
  if (cells().all.empty()) return {};
  try {
    refresh(*cells().memory, cells().all);
    return {};
  } catch (const AL::ALError& error) {
    return {error.what()};
  }
}

}  // namespace nao::client

void* AL::detail::memoryPointer(const ALProxy& memory, const std::string& key) {
  using nao::client::cells;
  if (!memory.isLocal()) {
    throw ALError("ALMemory", "getDataPtr",
                  "Cannot be called remotely: only a local module has pointers");
  }
  const auto value = memory.call<ALValue>("getData", key);
  if (!nao::client::isOf32Bits(value)) {
    throw ALError("ALMemory", "getDataPtr",
                  "expected an int or a float at " + key + ", found " + value.toString());
  }
  const std::lock_guard lock(cells().mutex);
  if (!cells().memory) cells().memory = memory.getGenericProxy();
  const auto [cell, is_new] = cells().all.try_emplace(key);
  if (is_new) nao::client::take(cell->second, value);
  return &cell->second.bits;
}

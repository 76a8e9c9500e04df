#pragma once

#include <string>
#include <string_view>

namespace nao::rpc {

/// 20 bytes that name one object: the same seed gives the same bytes, others differ.
std::string objectUid(std::string_view seed);

}  // namespace nao::rpc

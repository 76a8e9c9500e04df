#pragma once

namespace nao::client {

/// Calls what was left with qi::Application::atStop().
void actAtStop();

}  // namespace nao::client

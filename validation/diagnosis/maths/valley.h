#pragma once

#include <functional>

namespace nao::validation {

/// The number from `x` on, between `lower` and `upper`, where `cost` [nats] is least: by steps of a
/// factor and a parabola through the best one and its neighbours, nearer ones where it does not
/// fit. For costs that hold chance, of which the slopes between near neighbours would show little
/// else. `x` keeps its sign; 0 stays.
double lowestAlong(const std::function<double(double)>& cost, double x, double lower, double upper);

}  // namespace nao::validation

#pragma once

#include "preprocess/volumes/plane_pair_data.hpp"

namespace edgeshade {

/// Number of records whose multiplicity is not zero for a homogeneous light in the batch's space.
std::size_t countSilhouettes(const PlanePairShadow& shadow, const glm::dvec4& light);

} // namespace edgeshade

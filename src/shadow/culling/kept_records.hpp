#pragma once

#include "src/shadow/primitive_map/caster_edges.hpp"

#include <cstdint>
#include <span>

namespace edgeshade {

/// The records of a rigid batch without the casters that are `gone`, by cap. Their caps stay where
/// they are, for winding numbers tell of all of a component, with the plane (0, 0, 0, 0): their
/// sign is 0 in every light, here and at their edges, so that what the others emit is as closed as
/// ever (docs/method.md, C43). In closed clusters, that plane stands in pairs for what is gone;
/// edges of nothing but such planes have no record. `casters`: casterEdgesOf() the shadow.
PlanePairShadow withoutCasters(const PlanePairShadow& shadow, const CasterEdges& casters,
                               std::span<const std::uint8_t> gone);

} // namespace edgeshade

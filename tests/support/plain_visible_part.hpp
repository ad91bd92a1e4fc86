#pragma once

#include "src/shadow/view/frustum.hpp"
#include "src/shadow/view/visible_part.hpp"

namespace edgeshade::test {

/// The visible part of a batch, from a loop that clips every triangle: what visiblePart() has to
/// find, bit for bit. Extends `part`.
void addPlainly(const Scene& scene, const Batch& batch, const Frustum& frustum, VisiblePart& part);

/// The same of all batches; `ground`: the ground, too.
VisiblePart plainVisiblePart(const Scene& scene, const Frustum& frustum, bool ground);

} // namespace edgeshade::test

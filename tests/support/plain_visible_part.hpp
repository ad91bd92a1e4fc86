#pragma once

#include "src/shadow/view/visible_depth.hpp"

#include <array>
#include <gtest/gtest.h>

namespace edgeshade::test {

/// The visible part of a batch, from a loop that clips every triangle: what visiblePart() has to
/// find, bit for bit. Extends `part`.
void addPlainly(const Scene& scene, const Batch& batch, const Frustum& frustum, VisiblePart& part);

/// The same of all batches; `ground`: the ground, too.
VisiblePart plainVisiblePart(const Scene& scene, const Frustum& frustum, bool ground);

/// Depths, box and slopes.
std::array<double, 12> numbersOf(const VisiblePart& part);

/// Whether the tree finds what the loop does, for the scene and for each of its batches.
testing::AssertionResult findsTheSame(const Scene& scene, const SceneTree& tree,
                                      const Frustum& frustum, bool ground = false);

} // namespace edgeshade::test

// Boxes that are left out of a picture because a slice's planes exclude them.

#include "src/shadow/view/view_planes.hpp"

#include "src/shadow/geometry/box_plane.hpp"
#include "tests/support/hard_lights.hpp"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::Random;

constexpr int width = 240, height = 180;

FrameView randomView(Random& random) {
    FrameView view;
    view.frustum = frustumOf({3.0 * random.inCube(), 3.0 * random.inCube(), random.uniform(5, 150)},
                             static_cast<double>(width) / height);
    view.width = width;
    view.height = height;
    const double near = random.magnitude(-3, 0);
    const double far = near * random.magnitude(0.2, 2);
    view.farthestDepth = far * random.magnitude(-0.1, 1);
    view.slices = {{near, far}};
    return view;
}

glm::dmat4 randomPlace(Random& random) {
    glm::dmat4 place = glm::translate(glm::dmat4(1.0), random.inCube());
    place = glm::rotate(place, random.uniform(0, 6), random.inCube());
    return glm::scale(place, glm::dvec3(random.magnitude(-1, 1), random.magnitude(-1, 1),
                                        -random.magnitude(-1, 1)));
}

/// Whether the slice shows the point, by GL's own rules.
bool isShown(const glm::dvec4& inWorld, const FrameView& view) {
    const DepthSlice& slice = view.slices[0];
    const glm::dvec4 clip = view.clipFromView(slice) * view.frustum.viewFromWorld * inWorld;
    return std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w && -clip.w <= clip.z &&
           clip.w <= std::min(slice.far, view.farthestDepth);
}

TEST(ViewPlanes, NothingShownIsOutside) {
    Random random(7);
    int outside = 0, shown = 0;
    for (int i = 0; i < 20000; ++i) {
        const FrameView view = randomView(random);
        const glm::dmat4 worldFromBatch = randomPlace(random);
        const ViewPlanes planes = viewPlanes(view, view.slices[0], worldFromBatch);
        Box box;
        const glm::dvec3 center = 3.0 * random.inCube();
        for (int corner = 0; corner < 2; ++corner)
            box.add(center + random.inCube() * random.magnitude(-3, 0));
        const bool isLeftOut = std::any_of(planes.begin(), planes.end(),
                                           [&](const glm::dvec4& p) { return isOutside(box, p); });
        outside += isLeftOut;
        for (int p = 0; p < 40; ++p) {
            // One in three at a corner.
            glm::dvec3 share(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
            if (p % 3 == 0) share = glm::round(share);
            const glm::dvec3 point = glm::mix(box.low, box.high, share);
            if (!isShown(worldFromBatch * glm::dvec4(point, 1.0), view)) continue;
            ++shown;
            ASSERT_FALSE(isLeftOut) << i;
        }
    }
    EXPECT_GT(outside, 2000);
    EXPECT_GT(shown, 2000);
}

} // namespace
} // namespace edgeshade

// Clipped meshes in the mask engine: what is cut away casts nothing, or casts and is invisible.
#include "tests/engine/masks_in_a_host.hpp"

#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <stdexcept>

namespace edgeshade {
namespace {

using namespace test;
using Plane = std::array<double, 4>;
using Mask = std::vector<std::uint8_t>;

const Camera corner{{5, 4, 6}, {0, 0.5, 0}, 50.0};
const glm::vec3 low{-0.75f, 0.25f, -0.75f}, high{0.75f, 1.25f, 0.75f};

/// Faces of a box, without those that are missing.
struct Faces {
    std::vector<float> positions;
    std::vector<std::uint32_t> indices;

    MaskMesh mesh() const { return {.positions = positions, .indices = indices}; }
};

/// `missing`: axis, and 0 for the low or 1 for the high side.
Faces boxWithout(const glm::vec3& from, const glm::vec3& to,
                 const std::vector<std::array<int, 2>>& missing = {}) {
    Faces made;
    for (int number = 0; number < 8; ++number)
        for (int axis = 0; axis < 3; ++axis)
            made.positions.push_back((number >> axis & 1) != 0 ? to[axis] : from[axis]);
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) {
            if (std::find(missing.begin(), missing.end(), std::array<int, 2>{axis, side}) !=
                missing.end())
                continue;
            const std::uint32_t u = 1u << (axis + 1) % 3, v = 1u << (axis + 2) % 3,
                                at = side == 0 ? 0u : 1u << axis;
            if (side == 1)
                made.indices.insert(made.indices.end(),
                                    {at, at + u, at + u + v, at, at + u + v, at + v});
            else
                made.indices.insert(made.indices.end(),
                                    {at, at + u + v, at + u, at, at + v, at + u + v});
        }
    return made;
}

Faces ground() {
    return boxWithout({-4, -0.2f, -4}, {4, 0, 4});
}

const std::vector<Light>& lights() {
    static const std::vector<Light> all = {sun({0.5, 1, -0.3}), pointLight({0.1, 0.55, 0.2}),
                                           pointLight({1.3, 4, 0.7})};
    return all;
}

class ClippedMasks : public testing::Test {
  protected:
    /// The masks of all lights, one after the other.
    static Mask drawn(ShadowMasks& masks, const Camera& camera = corner, bool nearness = false) {
        std::vector<MaskLight> asked;
        for (const Light& light : lights())
            asked.push_back(hostLight(light));
        MaskView view = viewOf(camera);
        view.nearness = nearness;
        masks.draw(view, asked);
        Mask all;
        for (std::size_t i = 0; i < asked.size(); ++i) {
            const Mask one = readMask(masks, i);
            all.insert(all.end(), one.begin(), one.end());
        }
        return all;
    }

    static Mask drawnWith(const std::vector<Faces>& meshes) {
        ShadowMasks masks(eglLookUp);
        for (const Faces& of : meshes)
            masks.add(of.mesh());
        return drawn(masks);
    }

    static std::size_t unlike(const Mask& a, const Mask& b) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            count += a[i] != b[i];
        return count;
    }

    const gl::HeadlessContext context_{{hostWidth, hostHeight}};
};

void clip(ShadowMasks& masks, ShadowMasks::Id id, const std::vector<Plane>& planes,
          bool intersection = false, bool casts = false) {
    const MaskClipping clipping{planes, intersection, casts};
    masks.setClippings(id, {&clipping, 1});
}

} // namespace

TEST_F(ClippedMasks, AreThoseOfTheSceneCutByHand) {
    const Mask whole = drawnWith({ground(), boxWithout(low, high)});
    glm::vec3 top = high;
    top.y = 0.75f;
    const Mask opened = drawnWith({ground(), boxWithout(low, top, {{1, 1}})});
    top.x = 0.25f;
    const Mask cornered = drawnWith({ground(), boxWithout(low, top, {{1, 1}, {0, 1}})});
    const Mask alone = drawnWith({ground()});
    ASSERT_GT(unlike(whole, opened), 500u);
    ASSERT_GT(unlike(cornered, opened), 500u);

    ShadowMasks masks(eglLookUp);
    masks.add(ground().mesh());
    const auto box = masks.add(boxWithout(low, high).mesh());
    EXPECT_EQ(drawn(masks), whole);
    clip(masks, box, {{0, -2, 0, 1.5}});
    EXPECT_EQ(drawn(masks), opened);
    clip(masks, box, {{0, -2, 0, 1.5}, {-1, 0, 0, 0.25}});
    EXPECT_EQ(drawn(masks), cornered);
    clip(masks, box, {{0, 1, 0, -2}});
    EXPECT_EQ(drawn(masks), alone) << "all of it is cut away";
    clip(masks, box, {{0, 1, 0, 3}});
    EXPECT_EQ(drawn(masks), whole) << "the plane keeps it";
    masks.setClippings(box, {});
    EXPECT_EQ(drawn(masks), whole);
}

TEST_F(ClippedMasks, FollowMovedAndChangedMeshes) {
    const glm::dmat4 up = glm::translate(glm::dmat4(1.0), {0, 0.5, 0});
    glm::vec3 from = low, to = high;
    from.y += 0.5f;
    to.y = 1.0f;
    const Mask expected = drawnWith({ground(), boxWithout(from, to, {{1, 1}})});
    ShadowMasks masks(eglLookUp);
    masks.add(ground().mesh());
    const auto box = masks.add(boxWithout({-1, -1, -1}, {1, 1, 1}).mesh());
    clip(masks, box, {{0, -1, 0, 1}});
    masks.change(box, boxWithout(low, high).mesh());
    drawn(masks);
    masks.move(box, numbersOf(up));
    EXPECT_EQ(drawn(masks), expected) << "planes stay in the world";
    masks.move(box, identity16);
    masks.move(box, numbersOf(up));
    EXPECT_EQ(drawn(masks), expected);
}

TEST_F(ClippedMasks, OfAnIntersectionKeepWhatAnyPlaneKeeps) {
    struct Case {
        std::vector<Plane> planes;
        std::size_t most; ///< pixels that two meshes' cuts and one's may differ in
    };
    const std::vector<Case> cases = {
        {{{1, 0, 0, 0}, {0, -1, 0, 0.75}}, 2},
        {{{0.3, 0.5, -0.2, -0.3}, {-0.7, 0.1, 0.4, -0.1}}, 8},
    };
    for (const auto& [planes, most] : cases) {
        ShadowMasks pieces(eglLookUp), masks(eglLookUp);
        for (ShadowMasks* of : {&pieces, &masks})
            of->add(ground().mesh());
        const Faces faces = boxWithout(low, high);
        const Plane opposite = {-planes[0][0], -planes[0][1], -planes[0][2], -planes[0][3]};
        clip(pieces, pieces.add(faces.mesh()), {planes[0]});
        clip(pieces, pieces.add(faces.mesh()), {opposite, planes[1]});
        const auto box = masks.add(faces.mesh());
        const Mask whole = drawn(masks);
        clip(masks, box, planes, true);
        const Mask clipped = drawn(masks);
        EXPECT_LE(unlike(clipped, drawn(pieces)), most);
        EXPECT_GT(unlike(clipped, whole), 300u);
        clip(masks, box, {planes[0], {0, 1, 0, 9}}, true);
        EXPECT_EQ(drawn(masks), whole) << "one plane keeps all";
        clip(masks, box, {}, true);
        EXPECT_EQ(drawn(masks), whole) << "no planes clip nothing";
    }
}

TEST_F(ClippedMasks, CastWholeWhereOnlySurfacesAreClipped) {
    const Faces slab = boxWithout({-1, 1.5f, -1}, {1, 1.75f, 1});
    const Camera below{{3, 0.7, 3.4}, {0, 0.1, 0}, 60.0}; // doesn't see the slab's cut
    for (const Plane& plane : {Plane{0, 1, 0, -5}, Plane{0.9, 0.2, 0.1, -0.2}}) {
        ShadowMasks masks(eglLookUp), whole(eglLookUp), without(eglLookUp);
        for (ShadowMasks* of : {&masks, &whole, &without})
            of->add(ground().mesh());
        whole.add(slab.mesh());
        const auto id = masks.add(slab.mesh());
        clip(masks, id, {plane}, false, true);
        const Camera down{{0, 1.4, 0.01}, {0, 0, 0}, 80.0}; // from just below the slab
        EXPECT_EQ(drawn(masks, down), drawn(whole, down));
        EXPECT_GT(unlike(drawn(masks, down), drawn(without, down)), 500u);
        EXPECT_GT(unlike(drawn(masks, below), drawn(without, below)), 100u);
    }
    // From above, the slab is invisible and its shadow isn't.
    ShadowMasks masks(eglLookUp), without(eglLookUp);
    for (ShadowMasks* of : {&masks, &without})
        of->add(ground().mesh());
    clip(masks, masks.add(slab.mesh()), {{0, 1, 0, -5}}, false, true);
    const Mask shadowed = drawn(masks, corner, true), lit = drawn(without, corner, true);
    EXPECT_EQ(readTexture(masks.nearness().texture), readTexture(without.nearness().texture));
    EXPECT_GT(unlike(shadowed, lit), 500u);
}

TEST_F(ClippedMasks, CanBeClippedInBothWaysAtOnce) {
    // The upper half casts nothing, and the front is only invisible.
    const std::vector<Plane> upper = {{0, -1, 0, 0.75}}, front = {{0, 0, -1, 0.25}};
    const std::array<MaskClipping, 2> both = {MaskClipping{front, false, true},
                                              MaskClipping{upper, false, false}};
    glm::vec3 top = high;
    top.y = 0.75f;
    ShadowMasks masks(eglLookUp), byHand(eglLookUp);
    for (ShadowMasks* of : {&masks, &byHand})
        of->add(ground().mesh());
    masks.setClippings(masks.add(boxWithout(low, high).mesh()), both);
    clip(byHand, byHand.add(boxWithout(low, top, {{1, 1}}).mesh()), front, false, true);
    EXPECT_EQ(drawn(masks), drawn(byHand));
}

TEST_F(ClippedMasks, EndALookupOnlyWhereCastersChange) {
    ShadowMasks masks(eglLookUp);
    masks.add(ground().mesh());
    const auto box = masks.add(boxWithout(low, high).mesh());
    auto state = masks.casterState();
    const auto changes = [&] { return std::exchange(state, masks.casterState()) != state; };
    clip(masks, box, {{0, -1, 0, 1}}, false, true);
    EXPECT_FALSE(changes()) << "it casts as before";
    clip(masks, box, {{0, -1, 0, 0.5}}, false, true);
    EXPECT_FALSE(changes());
    clip(masks, box, {{0, -1, 0, 9}});
    EXPECT_FALSE(changes()) << "the plane keeps it";
    clip(masks, box, {{0, -1, 0, 1}});
    EXPECT_TRUE(changes());
    clip(masks, box, {{0, -1, 0, 1}});
    EXPECT_FALSE(changes()) << "the same planes";
    clip(masks, box, {{0, 1, 0, -5}});
    EXPECT_TRUE(changes());
    clip(masks, box, {{0, 1, 0, -6}});
    EXPECT_FALSE(changes()) << "it stays cut away";
    masks.setClippings(box, {});
    EXPECT_TRUE(changes());
}

TEST_F(ClippedMasks, StayRightWhenMeshesAreMerged) {
    ShadowMasks masks(eglLookUp), byHand(eglLookUp);
    std::vector<ShadowMasks::Id> boxes;
    for (ShadowMasks* of : {&masks, &byHand})
        of->add(ground().mesh());
    for (int i = 0; i < 24; ++i) {
        const glm::vec3 at(0.5f * static_cast<float>(i % 6) - 1.5f, 0.0f,
                           0.5f * static_cast<float>(i / 6) - 1.0f);
        const glm::vec3 to = at + glm::vec3(0.25f, 1.0f, 0.25f), cut(to.x, 0.5f, to.z);
        boxes.push_back(masks.add(boxWithout(at, to).mesh()));
        byHand.add(boxWithout(at, cut, {{1, 1}}).mesh());
    }
    for (const auto box : boxes)
        clip(masks, box, {{0, -1, 0, 2}});
    const std::size_t before = (drawn(masks), masks.cost().batches);
    for (int i = 0; i < 40; ++i)
        masks.draw(viewOf(corner), {});
    EXPECT_LT(masks.cost().batches, before) << "what no plane crosses is merged";
    for (const auto box : boxes)
        clip(masks, box, {{0, -1, 0, 0.5}});
    EXPECT_EQ(drawn(masks), drawn(byHand));
}

TEST_F(ClippedMasks, AreRefusedInASentence) {
    ShadowMasks masks(eglLookUp);
    const auto box = masks.add(boxWithout(low, high).mesh());
    const auto sentence = [&](const std::vector<Plane>& planes) -> std::string {
        try {
            clip(masks, box, planes);
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "none";
    };
    EXPECT_EQ(sentence(std::vector<Plane>(13, Plane{0, 1, 0, 0})),
              "13 planes are more than the 12 that can clip a mesh.");
    EXPECT_EQ(sentence({{0, 1, 0, 0}, {0, 1, 0, std::numeric_limits<double>::quiet_NaN()}}),
              "Clipping plane 1 has a number that is not finite.");
    EXPECT_EQ(sentence(std::vector<Plane>(12, Plane{0, 1, 0, 0})), "none");
}

} // namespace edgeshade

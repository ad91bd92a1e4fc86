#include "preprocess/volumes/plane_pair_data.hpp"
#include "src/shadow/layers/face_chain.hpp"
#include "tests/support/generated_meshes.hpp"
#include "tests/support/hard_lights.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <map>

namespace edgeshade {
namespace {

using test::Random;

/// The records of some boxes: `scale` times as large, and moved from the origin.
PlanePairShadow boxes(double scale, const glm::dvec3& from) {
    test::Soup soup = test::manyBoxes(60);
    for (glm::vec3& position : soup.positions)
        position = glm::vec3(scale * glm::dvec3(position) + from);
    CasterMesh mesh;
    mesh.welded = weld(soup.positions, soup.indices);
    mesh.groups = {{0, 0, static_cast<std::uint32_t>(mesh.welded.triangles.size())}};
    return buildPlanePairs(mesh, buildEdges(mesh.welded), {Material()});
}

/// Coordinates of a mesh, from its size on to 10 million times that.
glm::dvec3 anywhere(Random& random, double scale) {
    return scale * random.magnitude(0, 7) * random.inCube();
}

/// A batch as a light sees it.
struct Seen {
    Seen(const PlanePairShadow& shadow, const Light& light, const glm::dmat4& worldFromBatch)
        : view(light), chain(shadow), rays(view, worldFromBatch, chain.size()),
          faces(view.faces.size()) {
        if (view.directional) {
            faces[0].frame = FaceFrame::around(rays.outlineOf(chain.bounds()));
            rays.enter(faces[0].frame);
        }
        FollowedChain followed;
        chain.look(lightInBatch(light, worldFromBatch), {}, followed, casters);
        ChainPaths paths;
        drawChain(view, rays, chain, casters, paths, faces);
    }

    LightView view;
    CasterChain chain;
    RaysOfBatch rays;
    SeenCasters casters;
    std::vector<FaceChain> faces;
};

/// The distance of a segment's ends from those of an edge, whichever of these is the lower one.
double farthestEnd(const FaceSegment& segment, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 from(segment.from), to(segment.to);
    return std::min(std::max(glm::distance(from, a), glm::distance(to, b)),
                    std::max(glm::distance(from, b), glm::distance(to, a)));
}

TEST(FaceChain, ASunsSegmentsAreWithinTheirErrorOfTheEdges) {
    Random random(61);
    std::size_t compared = 0;
    double largest = 0.0; // difference as a share of the error
    for (int i = 0; i < 60; ++i) {
        const double scale = random.magnitude(-12, 12);
        const PlanePairShadow shadow = boxes(scale, anywhere(random, scale));
        glm::dmat4 place = glm::translate(glm::dmat4(1.0),
                                          1e3 * scale * random.magnitude(-6, 0) * random.inCube());
        place = glm::rotate(place, random.uniform(0, 6), random.inCube());
        const Seen seen(shadow, {glm::dvec4(random.inCube(), 0.0)}, place);
        const FaceChain& face = seen.faces[0];
        ASSERT_EQ(face.segments.size(), seen.casters.pairs.size() + seen.casters.singles.size());
        EXPECT_LT(face.error, 1e-5) << scale; // far-off coordinates cost nothing
        for (std::size_t k = 0; k < seen.casters.pairs.size(); ++k) {
            const PairRecord& pair = shadow.pairs[seen.casters.pairs[k].record];
            const glm::dvec2 a(seen.rays.to(pair.a)), b(seen.rays.to(pair.b));
            const double off = farthestEnd(face.segments[k], a, b);
            EXPECT_LE(off, face.error) << scale;
            largest = std::max(largest, off / face.error);
            EXPECT_LE(face.segments[k].from.y, face.segments[k].to.y);
            ++compared;
        }
    }
    EXPECT_GT(compared, 2000u);
    EXPECT_GT(largest, 0.01);
}

TEST(FaceChain, ALampsSegmentsAreWithinTheirErrorOfThoseOnTheFace) {
    Random random(62);
    std::size_t compared = 0;
    for (int i = 0; i < 60; ++i) {
        const double scale = random.magnitude(-12, 12);
        const PlanePairShadow shadow = boxes(scale, {});
        const glm::dvec3 at = scale * random.magnitude(0.5, 4) * random.inCube();
        Seen seen(shadow, {glm::dvec4(at, 1.0)}, glm::dmat4(1.0));
        for (FaceChain& face : seen.faces) {
            const double before = face.error;
            settle(face);
            for (std::size_t k = 0; k < face.segments.size(); ++k) {
                const DrawnSegment& drawn = face.drawn[k];
                EXPECT_LE(farthestEnd(face.segments[k], face.frame.to(drawn.from),
                                      face.frame.to(drawn.to)) +
                              before * face.frame.scale,
                          face.error);
                EXPECT_LE(glm::length(face.segments[k].from), 1.5f);
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 2000u);
}

/// Paths that start at a place, and by how much more rises from it than to it.
struct Rising {
    int starts = 0, more = 0;
};

template <class Segment>
void expectPaths(const std::vector<Segment>& segments, bool cut) {
    std::map<std::pair<double, double>, Rising> rising;
    for (const Segment& segment : segments) {
        const int weight = std::max<int>(segment.weight, 0);
        Rising& from = rising[{segment.from.x, segment.from.y}];
        from.starts += segment.starts;
        from.more += weight;
        rising[{segment.to.x, segment.to.y}].more -= weight;
    }
    for (const auto& [place, of] : rising) {
        EXPECT_GE(of.starts, std::max(of.more, 0));
        EXPECT_TRUE(cut || of.starts == std::max(of.more, 0));
    }
}

TEST(FaceChain, PathsGoOnFromEdgeToEdge) {
    Random random(64);
    for (int i = 0; i < 40; ++i) {
        const PlanePairShadow shadow = boxes(1.0, {});
        const Seen sun(shadow, {glm::dvec4(random.inCube(), 0.0)}, glm::dmat4(1.0));
        expectPaths(sun.faces[0].segments, false);
        const Seen lamp(shadow, {glm::dvec4(random.magnitude(0, 2) * random.inCube(), 1.0)},
                        glm::dmat4(1.0));
        for (const FaceChain& face : lamp.faces)
            expectPaths(face.drawn, true);
    }
}

/// Expects segments to rise in their exact places, unless they are level. `exact`: the ends of each
/// segment's edge, in the face's frame. Returns the number of level ones.
std::size_t expectRises(const std::vector<FaceSegment>& segments,
                        const std::vector<std::array<glm::dvec2, 2>>& exact) {
    std::size_t level = 0;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const glm::dvec2 from(segments[i].from);
        const auto& [a, b] = exact[i];
        const double rise = glm::distance(from, a) < glm::distance(from, b) ? b.y - a.y : a.y - b.y;
        EXPECT_TRUE(segments[i].level || rise > 0.0) << rise;
        level += segments[i].level;
    }
    return level;
}

// A third of the boxes' edges run across the light's plane, but for rounding.
TEST(FaceChain, ASunsSegmentsThatMayFallAreLevel) {
    Random random(65);
    std::size_t level = 0, all = 0;
    for (int i = 0; i < 60; ++i) {
        const PlanePairShadow shadow = boxes(1.0, {});
        const Light light{glm::dvec4(random.inCube(), 0.0)};
        const glm::dvec3 edge = LightView(light).axes[0];
        const glm::dmat4 place =
            glm::rotate(glm::dmat4(1.0), -std::atan2(edge.y, edge.x), glm::dvec3(light.position));
        const Seen seen(shadow, light, place);
        std::vector<std::array<glm::dvec2, 2>> exact;
        for (const ChainEdge& of : seen.casters.pairs)
            exact.push_back({glm::dvec2(seen.rays.to(shadow.pairs[of.record].a)),
                             glm::dvec2(seen.rays.to(shadow.pairs[of.record].b))});
        const std::span<const FaceSegment> pairs(seen.faces[0].segments.data(), exact.size());
        level += expectRises({pairs.begin(), pairs.end()}, exact);
        all += exact.size();
    }
    EXPECT_GT(level, all / 10);
    EXPECT_LT(level, all / 2);
}

TEST(FaceChain, ALampsSegmentsThatMayFallAreLevel) {
    Random random(66);
    std::size_t level = 0, all = 0;
    for (int i = 0; i < 60; ++i) {
        const PlanePairShadow shadow = boxes(1.0, {});
        const Light light{glm::dvec4(random.magnitude(0, 2) * random.inCube(), 1.0)};
        const glm::dmat4 place(glm::transpose(LightView(light).axes));
        Seen seen(shadow, light, place);
        for (FaceChain& face : seen.faces) {
            settle(face);
            std::vector<std::array<glm::dvec2, 2>> exact;
            for (const DrawnSegment& drawn : face.drawn)
                exact.push_back({face.frame.to(drawn.from), face.frame.to(drawn.to)});
            level += expectRises(face.segments, exact);
            all += exact.size();
        }
    }
    EXPECT_GT(level, all / 10);
    EXPECT_LT(level, all / 2);
}

TEST(FaceChain, FramesAreThereAndBack) {
    Random random(63);
    for (int i = 0; i < 200; ++i) {
        const double size = random.magnitude(-300, 300);
        const glm::dvec2 low(random.uniform(-1, 1), random.uniform(-1, 1));
        const glm::dvec2 high = low + glm::dvec2(random.uniform(0, 1), random.uniform(0, 1));
        const Outline outline{size * low.x, size * high.x, size * low.y, size * high.y};
        const FaceFrame frame = FaceFrame::around(outline);
        const glm::dvec2 corner = frame.to(size * high), back = frame.from(corner);
        EXPECT_LE(std::max(std::abs(corner.x), std::abs(corner.y)), 1.0);
        EXPECT_NEAR(back.x / size, high.x, 1e-15);
        EXPECT_NEAR(back.y / size, high.y, 1e-15);
    }
    EXPECT_EQ(FaceFrame::around({0.0, INFINITY, 0.0, 1.0}).scale, 1.0);
}

} // namespace
} // namespace edgeshade

// Records that follow a cut, beside those that topology found again gives (docs/method.md, C51).
#include "preprocess/section/component_blocks.hpp"
#include "preprocess/section/cut_scene.hpp"
#include "preprocess/volumes/cut_records.hpp"
#include "src/scene/cut_loaded.hpp"
#include "tests/support/generated_meshes.hpp"
#include "tests/support/loaded_scene.hpp"
#include "tests/support/plane_pair_chain.hpp"
#include "tests/support/scene_builder.hpp"
#include "tests/support/small_soups.hpp"

#include <cstring>
#include <gtest/gtest.h>
#include <set>

namespace edgeshade {
namespace {

using test::Random;
using test::Soup;

/// `doubleSided`: triangles at the end that are seen from both sides.
Scene sceneOf(const Soup& soup, std::size_t doubleSided = 0) {
    test::SceneBuilder builder;
    for (std::size_t i = 0; i < soup.indices.size(); i += 3) {
        if (soup.indices.size() - i == 3 * doubleSided) {
            Material material;
            material.doubleSided = true;
            builder.material(material);
        }
        builder.triangle(soup.positions[soup.indices[i]], soup.positions[soup.indices[i + 1]],
                         soup.positions[soup.indices[i + 2]]);
    }
    return builder.scene();
}

/// Some or none of a soup's triangles.
std::size_t someOf(Random& random, const Soup& soup) {
    return static_cast<std::size_t>(
        std::max(0, random.below(static_cast<int>(soup.indices.size() / 3)) - 5));
}

/// A closed surface around the origin, of 2 * rings * sectors triangles, whose radius varies
/// between 2 and 4. On a lattice many of its corners coincide and many faces are coplanar.
Soup bumpySolid(Random& random, int rings, int sectors, bool onLattice) {
    std::vector<glm::vec3> points;
    const auto at = [&](double height, double around) {
        const double radius = random.uniform(2.0, 4.0), low = std::sin(3.14159265358979 * height);
        const glm::dvec3 point(radius * low * std::cos(2.0 * 3.14159265358979 * around),
                               radius * std::cos(3.14159265358979 * height),
                               radius * low * std::sin(2.0 * 3.14159265358979 * around));
        return glm::vec3(onLattice ? glm::round(point) : point) + 0.0f;
    };
    for (int ring = 1; ring < rings; ++ring)
        for (int sector = 0; sector < sectors; ++sector)
            points.push_back(
                at(ring / static_cast<double>(rings), sector / static_cast<double>(sectors)));
    const glm::vec3 top(0, 3, 0), bottom(0, -3, 0);
    Soup soup;
    const auto add = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        for (const glm::vec3& of : {a, b, c}) {
            soup.indices.push_back(static_cast<std::uint32_t>(soup.positions.size()));
            soup.positions.push_back(of);
        }
    };
    const auto point = [&](int ring, int sector) {
        return points[static_cast<std::size_t>((ring - 1) * sectors + sector % sectors)];
    };
    for (int sector = 0; sector < sectors; ++sector) {
        add(top, point(1, sector + 1), point(1, sector));
        for (int ring = 1; ring + 1 < rings; ++ring) {
            add(point(ring, sector), point(ring, sector + 1), point(ring + 1, sector));
            add(point(ring + 1, sector), point(ring, sector + 1), point(ring + 1, sector + 1));
        }
        add(point(rings - 1, sector), point(rings - 1, sector + 1), bottom);
    }
    return soup;
}

/// A plane askew, through a vertex, through an edge, or in a face of the scene.
glm::dvec4 randomPlane(Random& random, const Soup& soup) {
    const auto corner = [&](std::size_t triangle, std::size_t of) {
        return glm::dvec3(soup.positions[soup.indices[3 * triangle + of]]);
    };
    const auto triangle =
        static_cast<std::size_t>(random.below(static_cast<int>(soup.indices.size() / 3)));
    const glm::dvec3 a = corner(triangle, 0), b = corner(triangle, 1), c = corner(triangle, 2);
    glm::dvec3 normal = random.inCube();
    const int kind = random.below(5);
    if (kind == 1) normal = glm::round(2.0 * normal) + glm::dvec3(0.0, 0.0, 3.0);
    if (kind == 2) normal = glm::cross(b - a, normal);
    if (kind == 3) normal = glm::cross(b - a, c - a) * (random.below(2) == 0 ? 1.0 : -1.0);
    if (normal == glm::dvec3(0.0)) normal = {0.0, 1.0, 0.0};
    const glm::dvec3 through = kind == 0 ? random.inCube() : a;
    return {normal, -glm::dot(normal, through)};
}

/// Whether rounding may decide the side of a light.
bool isGrazed(const glm::vec4& plane, const glm::vec4& light) {
    const glm::dvec4 terms = glm::dvec4(plane) * glm::dvec4(light);
    const glm::dvec4 sizes = glm::abs(terms);
    return std::abs(terms.x + terms.y + terms.z + terms.w) <
           1e-3 * (sizes.x + sizes.y + sizes.z + sizes.w);
}

enum class Solids { none, apart, overlap };

/// Compares the records that follow a cut with those that are found again.
class Comparison {
  public:
    std::size_t followed = 0, closed = 0; ///< cuts that were compared; those of closed records
    std::size_t cutUp = 0;                ///< that left some caps, and pieces

    /// `solids`: chains without a boundary whose cuts are filled.
    void compare(const Scene& whole, const Section& section, Solids solids, Random& random) {
        SceneCutter cutter(whole, false);
        const UncutRecords uncut = uncutRecords(whole.batches[0], whole.materials, false);
        if (!uncut.canFollowCuts()) return;
        const Scene cut = cutter.cut(section);
        const Batch& batch = cut.batches[0];
        if (!batch.origins) return;
        const CutOrigins& origins = *batch.origins;
        ++followed;
        const PlanePairShadow made =
            cutRecords(uncut, *batch.geometry, origins, cut.materials, false, memory_);
        const CasterMesh mesh = weldForRecords(batch, castersOf(batch, cut.materials, false));
        const EdgeList edges = buildEdges(mesh.welded);
        const PlanePairShadow found = buildPlanePairs(mesh, edges, cut.materials);
        cutUp += !origins.met.empty() && !made.caps.empty();
        ASSERT_EQ(made.clusters.empty(), found.clusters.empty());
        if (made.clusters.empty()) return;

        expectSameCaps(made, found, mesh.welded);
        expectRecordsAtEdges(made, mesh.welded, edges);
        expectWellFormed(made);
        expectGroups(made, mesh, cut.materials);
        if (solids != Solids::none) expectSameKinds(made, found, solids == Solids::overlap);
        closed += made.clusters.front().closed;
        for (int turn = 0; turn < 14; ++turn)
            expectSameCounts(made, found, mesh, edges, lightFor(random, turn, mesh.welded));
    }

  private:
    static glm::vec4 lightFor(Random& random, int turn, const WeldedMesh& mesh) {
        const Triangle& of = mesh.triangles[static_cast<std::size_t>(
            random.below(static_cast<int>(mesh.triangles.size())))];
        return test::randomLight(
            random, {mesh.positions[of[0]], mesh.positions[of[1]], mesh.positions[of[2]]},
            static_cast<test::LightKind>(turn % test::lightKindCount));
    }

    static void expectSameCaps(const PlanePairShadow& made, const PlanePairShadow& found,
                               const WeldedMesh& mesh) {
        ASSERT_EQ(made.caps.size(), found.caps.size());
        std::set<std::uint32_t> triangles;
        for (std::size_t i = 0; i < made.caps.size(); ++i) {
            const Triangle& corners = mesh.triangles[made.capTriangles[i]];
            triangles.insert(made.capTriangles[i]);
            ASSERT_EQ(made.caps[i].a, mesh.positions[corners[0]]);
            ASSERT_EQ(made.caps[i].b, mesh.positions[corners[1]]);
            ASSERT_EQ(made.caps[i].c, mesh.positions[corners[2]]);
        }
        EXPECT_EQ(triangles.size(), made.caps.size());
    }

    static void expectRecordsAtEdges(const PlanePairShadow& made, const WeldedMesh& mesh,
                                     const EdgeList& edges) {
        std::set<std::pair<std::array<float, 3>, std::array<float, 3>>> ends;
        const auto keyOf = [](const glm::vec3& a, const glm::vec3& b) {
            return std::pair{std::array{a.x, a.y, a.z}, std::array{b.x, b.y, b.z}};
        };
        for (const Edge& edge : edges.edges)
            ends.insert(keyOf(mesh.positions[edge.a], mesh.positions[edge.b]));
        for (const PairRecord& of : made.pairs)
            ASSERT_TRUE(ends.contains(keyOf(of.a, of.b)));
        for (const SingleRecord& of : made.singles)
            ASSERT_TRUE(ends.contains(keyOf(of.a, of.b)));
        // A piece may come to lie on an edge that it doesn't share.
        EXPECT_GE(made.edges, ends.size());
        EXPECT_LE(made.flatEdges, made.edges);
    }

    /// Materials of caps, and how they are grouped.
    static void expectGroups(const PlanePairShadow& made, const CasterMesh& mesh,
                             const std::vector<Material>& materials) {
        std::vector<std::size_t> materialOf; // by triangle
        for (const MaterialCasters& group : mesh.groups)
            materialOf.resize(materialOf.size() + group.capCount, group.material);
        std::uint32_t next = 0;
        for (const ShadowCluster& cluster : made.clusters) {
            ASSERT_EQ(cluster.caps.first, next);
            for (std::uint32_t g = cluster.groups.first; g < cluster.groups.end(); ++g) {
                const MaterialCasters& group = made.groups[g];
                const Material& shared = materials[group.material];
                ASSERT_EQ(group.firstCap, next);
                ASSERT_GT(group.capCount, 0u);
                next += group.capCount;
                for (std::uint32_t cap = group.firstCap; cap < next; ++cap) {
                    const Material& own = materials[materialOf[made.capTriangles[cap]]];
                    ASSERT_EQ(shared.isSeen(), own.isSeen());
                    ASSERT_EQ(cap - cluster.caps.first < cluster.singleSided, !own.doubleSided);
                    ASSERT_TRUE(cluster.alphaTested || own.alphaMode == AlphaMode::opaque);
                }
            }
            ASSERT_EQ(cluster.caps.end(), next);
        }
        EXPECT_EQ(next, made.caps.size());
    }

    /// Each triangle is in a cluster of the kind that is found again. Where solids overlap, their
    /// fills may leave gaps in some of them; then all of them count as open.
    static void expectSameKinds(const PlanePairShadow& made, const PlanePairShadow& found,
                                bool overlap) {
        const auto kindsOf = [](const PlanePairShadow& of) {
            std::vector<std::pair<bool, bool>> kinds(of.caps.size());
            for (const ShadowCluster& cluster : of.clusters)
                for (std::uint32_t cap = cluster.caps.first; cap < cluster.caps.end(); ++cap)
                    kinds[of.capTriangles[cap]] = {cluster.closed, cluster.alphaTested};
            return kinds;
        };
        const auto own = kindsOf(made), other = kindsOf(found);
        std::size_t gaps = 0;
        for (std::size_t i = 0; i < own.size(); ++i) {
            ASSERT_LE(own[i].first, other[i].first);
            ASSERT_EQ(own[i].second, other[i].second);
            gaps += own[i].first != other[i].first;
        }
        if (!overlap) {
            EXPECT_EQ(gaps, 0u);
        }
    }

    static void expectWellFormed(const PlanePairShadow& made) {
        const auto planeOf = [&](PlaneOf of) {
            const glm::vec4& plane = made.caps[of.cap()].plane;
            return of.negated() ? -plane : plane;
        };
        ASSERT_EQ(made.pairPlanes.size(), made.pairs.size());
        ASSERT_EQ(made.singlePlanes.size(), made.singles.size());
        for (std::size_t i = 0; i < made.pairs.size(); ++i) {
            ASSERT_EQ(planeOf(made.pairPlanes[i][0]), made.pairs[i].plane0);
            ASSERT_EQ(planeOf(made.pairPlanes[i][1]), made.pairs[i].plane1);
        }
        for (std::size_t i = 0; i < made.singles.size(); ++i)
            ASSERT_EQ(planeOf(made.singlePlanes[i]), made.singles[i].plane);
        RecordRange pairs, singles, leaves;
        for (const ShadowCluster& cluster : made.clusters) {
            ASSERT_EQ(cluster.pairs.first, pairs.end());
            ASSERT_EQ(cluster.singles.first, singles.end());
            ASSERT_EQ(cluster.leaves.first, leaves.end());
            pairs = cluster.pairs, singles = cluster.singles, leaves = cluster.leaves;
            ASSERT_EQ(leaves.count, (cluster.caps.count + 31) / 32);
            for (std::uint32_t i = 0; i < cluster.caps.count; ++i) {
                const CapRecord& cap = made.caps[cluster.caps.first + i];
                for (const glm::vec3& corner : {cap.a, cap.b, cap.c})
                    for (const Box& box : {cluster.bounds, made.leaves[leaves.first + i / 32]}) {
                        const glm::dvec3 at(corner);
                        ASSERT_EQ(glm::clamp(at, box.low, box.high), at);
                    }
            }
        }
        EXPECT_EQ(pairs.end(), made.pairs.size());
        EXPECT_EQ(singles.end(), made.singles.size());
        EXPECT_EQ(leaves.end(), made.leaves.size());
    }

    static void expectSameCounts(const PlanePairShadow& made, const PlanePairShadow& found,
                                 const CasterMesh& mesh, const EdgeList& edges,
                                 const glm::vec4& light) {
        const test::PlanePairSigns signs = test::signsOf(made, light, test::countAll);
        ASSERT_EQ(test::openEdges(mesh, edges, made, signs), 0u);
        ASSERT_EQ(test::openClusters(mesh.welded.positions, made, light), 0u);
        const test::PlanePairSigns others = test::signsOf(found, light, test::countAll);
        std::vector<int> facings(made.caps.size());
        for (std::size_t i = 0; i < found.caps.size(); ++i)
            facings[found.capTriangles[i]] = others.caps[i];
        for (std::size_t i = 0; i < made.caps.size(); ++i)
            if (!isGrazed(made.caps[i].plane, light)) {
                ASSERT_EQ(signs.caps[i], facings[made.capTriangles[i]]);
            }
    }

    CutMemory memory_; ///< of all comparisons
};

std::vector<Section> randomSections(Random& random, const Soup& soup) {
    std::vector<Section> sections;
    for (const SectionShadows shadows : {SectionShadows::cut, SectionShadows::whole}) {
        std::vector<glm::dvec4> planes = {randomPlane(random, soup)};
        while (random.below(3) == 0)
            planes.push_back(randomPlane(random, soup));
        sections.push_back({planes, shadows, glm::vec3(1.0f)});
    }
    return sections;
}

TEST(CutRecords, OfSolidsCountAsThoseFoundAgain) {
    Random random(54);
    Comparison comparison;
    for (int turn = 0; turn < 300; ++turn) {
        const Soup soup = bumpySolid(random, 4 + random.below(5), 5 + random.below(9), turn % 2);
        SCOPED_TRACE(turn);
        for (const Section& section : randomSections(random, soup))
            comparison.compare(sceneOf(soup, someOf(random, soup)), section, Solids::apart, random);
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(comparison.followed, 300u);
    EXPECT_GT(comparison.cutUp, 250u);
    EXPECT_GT(comparison.closed, 100u);
}

TEST(CutRecords, WithoutAFillCountAsThoseFoundAgain) {
    Random random(55);
    Comparison comparison;
    for (int turn = 0; turn < 100; ++turn) {
        const Soup soup = bumpySolid(random, 5, 7, turn % 2);
        SCOPED_TRACE(turn);
        for (Section section : randomSections(random, soup)) {
            section.fill.reset();
            comparison.compare(sceneOf(soup, someOf(random, soup)), section, Solids::none, random);
        }
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(comparison.cutUp, 50u);
}

TEST(CutRecords, OfOpenSoupsCountAsThoseFoundAgain) {
    Random random(56);
    Comparison comparison;
    for (int turn = 0; turn < 400; ++turn) {
        const Soup soup = turn % 4 == 0   ? test::tangle(60)
                          : turn % 4 == 1 ? test::hillyGrid(100)
                                          : test::randomSoup(random, 4 + random.below(30));
        SCOPED_TRACE(turn);
        for (const Section& section : randomSections(random, soup))
            comparison.compare(sceneOf(soup, someOf(random, soup)), section, Solids::none, random);
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(comparison.followed, 300u);
    EXPECT_GT(comparison.cutUp, 200u);
}

TEST(CutRecords, OfSeveralSolidsAndSheetsCountAsThoseFoundAgain) {
    Random random(59);
    Comparison comparison;
    for (int turn = 0; turn < 100; ++turn) {
        Soup soup = bumpySolid(random, 3, 4, false);
        for (int i = 0; i < 3; ++i) {
            const Soup more = i == 1 ? test::hillyGrid(8) : bumpySolid(random, 3, 5, false);
            const auto first = static_cast<std::uint32_t>(soup.positions.size());
            const glm::vec3 place(10.0 * random.inCube());
            for (const glm::vec3& point : more.positions)
                soup.positions.push_back(point + place);
            for (const std::uint32_t index : more.indices)
                soup.indices.push_back(first + index);
        }
        SCOPED_TRACE(turn);
        for (const Section& section : randomSections(random, soup))
            comparison.compare(sceneOf(soup, someOf(random, soup)), section, Solids::overlap,
                               random);
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(comparison.cutUp, 150u);
    EXPECT_GT(comparison.closed, 100u);
}

TEST(CutRecords, OfACubeUnderPlanesInItsFacesAndEdges) {
    Random random(57);
    Comparison comparison;
    const Soup cube = test::cube();
    for (int turn = 0; turn < 200; ++turn)
        for (const Section& section : randomSections(random, cube))
            comparison.compare(sceneOf(cube), section, Solids::apart, random);
    EXPECT_GT(comparison.cutUp, 20u);
}

/// Whether two arrays of records are the same, bit for bit.
template <class Record>
bool areSame(const std::vector<Record>& s, const std::vector<Record>& t) {
    return s.size() == t.size() &&
           (s.empty() || std::memcmp(s.data(), t.data(), s.size() * sizeof(Record)) == 0);
}

TEST(CutRecords, DontDependOnWhereThePlaneWasBefore) {
    Random random(58);
    const Scene scene = sceneOf(bumpySolid(random, 9, 14, false));
    for (const SectionShadows shadows : {SectionShadows::cut, SectionShadows::whole}) {
        LoadedScene dragged = test::loadedOf(scene);
        for (const double at : {0.0, 0.5, 1.0, 1.5, 9.0, 1.2, 0.7, 0.2, -0.4, -9.0, 0.1}) {
            const Section section{{{0.1, -1.0, 0.2, at}}, shadows, glm::vec3(1.0f)};
            cutScene(dragged, section);
            LoadedScene fresh = test::loadedOf(scene);
            cutScene(fresh, section);
            const PlanePairShadow &made = *dragged.planePairs[0], &other = *fresh.planePairs[0];
            EXPECT_TRUE(areSame(made.pairs, other.pairs)) << at;
            EXPECT_TRUE(areSame(made.caps, other.caps)) << at;
            EXPECT_EQ(made.capTriangles, other.capTriangles) << at;
            EXPECT_EQ(dragged.scene.batches[0].geometry->indices,
                      fresh.scene.batches[0].geometry->indices);
            EXPECT_EQ(dragged.scene.batches[0].geometry->positions,
                      fresh.scene.batches[0].geometry->positions);
        }
    }
}

/// Adds a soup's triangles to another, moved along x.
void append(Soup& to, const Soup& soup, float along) {
    for (const std::uint32_t index : soup.indices) {
        to.indices.push_back(static_cast<std::uint32_t>(to.positions.size()));
        to.positions.push_back(soup.positions[index] + glm::vec3(along, 0.0f, 0.0f));
    }
}

// The topology of all triangles serves where they all cast, and no others.
TEST(CutRecords, AreTheSameOfATopologyThatIsKnown) {
    Random random(61);
    for (const bool allCast : {true, false}) {
        Scene scene = sceneOf(bumpySolid(random, 6, 9, false), 20);
        if (!allCast) scene.materials.back().alphaMode = AlphaMode::blend;
        const Batch& batch = scene.batches[0];
        const UncutRecords found = uncutRecords(batch, scene.materials, false);
        const UncutRecords made =
            uncutRecords(batch, scene.materials, false, nullptr,
                         topologyOf(batch.geometry->positions, batch.geometry->indices));
        EXPECT_EQ(made.capOf, found.capOf);
        EXPECT_EQ(made.edgesOf, found.edgesOf);
        EXPECT_EQ(made.edgeCaps, found.edgeCaps);
        EXPECT_EQ(made.closed, found.closed);
        EXPECT_EQ(made.flat, found.flat);
        EXPECT_EQ(made.closed, std::vector<std::uint8_t>(made.closed.size(), allCast));
    }
}

TEST(ComponentBlocks, DivideABatchUnlessOneComponentIsNearlyAllOfIt) {
    Random random(59);
    Soup large = bumpySolid(random, 25, 25, false), several;
    append(large, bumpySolid(random, 3, 4, false), 20.0f);
    for (int i = 0; i < 4; ++i)
        append(several, bumpySolid(random, 20, 20, false), 20.0f * static_cast<float>(i));
    const Scene whole = sceneOf(large);
    const SceneInBlocks one = inBlocks(whole), four = inBlocks(sceneOf(several));
    EXPECT_EQ(one.scene.batches.size(), 1u);
    EXPECT_TRUE(one.topologies.contains(&*whole.batches[0].geometry));
    EXPECT_EQ(four.scene.batches.size(), 4u);
    EXPECT_TRUE(four.topologies.empty()) << "that of the batch is none of its blocks'";

    Soup flat; // no triangle has an area, so none is in a component
    flat.positions = {{0, 0, 0}, {1, 0, 0}};
    for (int i = 0; i < 1100; ++i)
        flat.indices.insert(flat.indices.end(), {0, 1, 0});
    EXPECT_EQ(inBlocks(sceneOf(flat)).scene.batches.size(), 1u);
}

TEST(SharedPool, GivesTheMemoryOfValuesThatNobodyHolds) {
    SharedPool<std::vector<int>> pool;
    std::shared_ptr<std::vector<int>> held = pool.share({1, 2, 3});
    const int* const memory = held->data();
    const std::weak_ptr<std::vector<int>> watched = held;
    EXPECT_TRUE(pool.take().empty());
    EXPECT_EQ(held->size(), 3u);
    held.reset();
    EXPECT_FALSE(watched.expired());
    const std::vector<int> taken = pool.take();
    EXPECT_EQ(taken.data(), memory);
    EXPECT_TRUE(watched.expired());
    EXPECT_TRUE(pool.take().empty());
}

} // namespace
} // namespace edgeshade

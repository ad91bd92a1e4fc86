// The tree leaves out triangles that can't change the answer: it must be that of a loop over all
// of them, bit for bit.
#include "src/shadow/view/frame_view.hpp"
#include "src/shadow/view/visible_depth.hpp"
#include "tests/support/generated_meshes.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/plain_visible_part.hpp"
#include "tests/support/scene_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <numbers>

namespace edgeshade {
namespace {

using test::findsTheSame;
using test::numbersOf;
using test::Random;
using test::SceneBuilder;

testing::AssertionResult findsTheSame(const Scene& scene, const Frustum& frustum) {
    return findsTheSame(scene, SceneTree(scene), frustum);
}

/// Triangles of one batch, single-sided or not by turns of `sided`.
void addBatch(Scene& scene, std::vector<glm::vec3> positions, std::vector<std::uint32_t> indices,
              std::size_t sided = 1) {
    scene.culls = true;
    if (scene.materials.empty()) {
        scene.materials.resize(2);
        scene.materials[1].doubleSided = true;
    }
    Geometry geometry;
    geometry.positions = std::move(positions);
    geometry.indices = std::move(indices);
    const std::uint32_t count = static_cast<std::uint32_t>(geometry.indices.size()) / 3;
    for (std::uint32_t first = 0, turn = 0; first < count; ++turn) {
        const std::uint32_t some = std::min<std::uint32_t>(count - first, 1 + count / 5);
        geometry.groups.push_back({turn % 2 < sided ? std::size_t{0} : 1, 3 * first, 3 * some});
        first += some;
    }
    scene.batches.emplace_back().geometry = CopyOnWrite(std::move(geometry));
}

/// Triangles of all shapes and scales around the origin, one vertex shared now and then.
void addSoup(Scene& scene, Random& random, int triangles) {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;
    const double scale = random.magnitude(-2, 1);
    for (int t = 0; t < triangles; ++t) {
        const glm::dvec3 middle = 4.0 * random.inCube();
        const double size = random.below(20) == 0 ? 3.0 : 0.3;
        for (int c = 0; c < 3; ++c) {
            if (c == 2 && random.below(10) == 0) { // a sliver, or no area
                indices.push_back(indices.back());
                continue;
            }
            indices.push_back(static_cast<std::uint32_t>(positions.size()));
            positions.emplace_back(scale * (middle + size * random.inCube()));
        }
    }
    addBatch(scene, std::move(positions), std::move(indices), random.below(3));
}

/// A closed ball, wound outwards. `sided`: as in addBatch().
void addBall(Scene& scene, std::uint32_t rows, std::size_t sided = 1) {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;
    const std::uint32_t columns = 2 * rows;
    for (std::uint32_t row = 0; row <= rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column) {
            const double up = std::numbers::pi * row / rows;
            const double around = 2.0 * std::numbers::pi * column / columns;
            positions.emplace_back(std::sin(up) * std::cos(around), std::cos(up),
                                   std::sin(up) * std::sin(around));
        }
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t next = (column + 1) % columns;
            const std::uint32_t a = row * columns + column, b = row * columns + next;
            const std::uint32_t c = (row + 1) * columns + next, d = (row + 1) * columns + column;
            indices.insert(indices.end(), {a, b, c, a, c, d});
        }
    addBatch(scene, std::move(positions), std::move(indices), sided);
}

glm::dvec3 direction(Random& random) {
    const glm::dvec3 v = random.inCube();
    return glm::length(v) > 0.01 ? glm::normalize(v) : glm::dvec3(0.0, 0.0, -1.0);
}

glm::dmat4 somePlace(Random& random, double distance) {
    glm::dmat4 place = glm::translate(glm::dmat4(1.0), distance * random.inCube());
    if (random.below(3) == 0) return place;
    place = glm::rotate(place, random.uniform(-3, 3), direction(random));
    if (random.below(3) == 0) // mirrored, too
        place = glm::scale(
            place, {random.magnitude(-1, 1), random.magnitude(-1, 1), -random.magnitude(-1, 1)});
    return place;
}

Frustum frustumFrom(Random& random, const glm::dvec3& eye, const glm::dvec3& to, double size) {
    const Camera camera{
        eye, to, random.below(4) == 0 ? random.uniform(0.01, 3.0) : random.uniform(10.0, 150.0)};
    Frustum frustum = frustumOf(camera, random.uniform(0.3, 3.0));
    if (random.below(3) == 0)
        frustum = frustumOf(camera, random.uniform(0.3, 3.0), size * random.magnitude(-2, 1));
    if (random.below(5) == 0) { // off its axis
        const glm::dvec2 shift = frustum.size() * random.uniform(-1.0, 1.0);
        frustum.low += shift;
        frustum.high += shift;
    }
    return frustum;
}

/// Around, within, and at a vertex of a scene; along axes or not.
Frustum someFrustum(Random& random, const Scene& scene) {
    const Box bounds = worldBounds(scene);
    const double size = bounds.empty() ? 1.0 : bounds.diagonal();
    glm::dvec3 eye = bounds.center() + size * random.magnitude(-2, 1) * random.inCube();
    if (random.below(4) == 0) {
        const Batch& batch =
            scene.batches[static_cast<std::size_t>(random.below(int(scene.batches.size())))];
        const auto& positions = batch.geometry->positions;
        if (!positions.empty())
            eye = glm::dvec3(
                batch.worldFromBatch *
                glm::dvec4(positions[static_cast<std::size_t>(random.below(int(positions.size())))],
                           1.0));
    }
    glm::dvec3 to = bounds.center() + 0.3 * size * random.inCube();
    if (random.below(4) == 0) {
        glm::dvec3 axis(0.0);
        axis[random.below(3)] = random.below(2) ? 1.0 : -1.0;
        to = eye + size * axis;
    }
    if (to == eye) to.z -= size + 1.0;
    return frustumFrom(random, eye, to, size);
}

TEST(VisiblePart, OfSoupsIsThatOfEveryTriangle) {
    Random random(21);
    for (int i = 0; i < 60; ++i) {
        Scene scene;
        const int batches = 1 + random.below(4);
        for (int b = 0; b < batches; ++b) {
            addSoup(scene, random, 1 + random.below(random.below(4) == 0 ? 3000 : 200));
            scene.batches.back().worldFromBatch = somePlace(random, 3.0);
        }
        scene.culls = random.below(3) != 0;
        const SceneTree tree(scene);
        for (int view = 0; view < 12; ++view)
            EXPECT_TRUE(findsTheSame(scene, tree, someFrustum(random, scene)))
                << "soup " << i << ", view " << view;
    }
}

// Hosts make trees of large meshes ahead, in steps of their own.
TEST(SceneTree, TakesTreesThatWereMadeAhead) {
    Random random(24);
    Scene scene;
    addSoup(scene, random, 300);
    addSoup(scene, random, 300);
    const Geometry& known = *scene.batches[1].geometry;
    const CopyOnWrite ahead(TriangleTree(known, scene.materials));
    SceneTree tree;
    tree.update(scene, {{&known, ahead}});
    EXPECT_EQ(&tree.trianglesOf(1), &*ahead);
    EXPECT_TRUE(findsTheSame(scene, tree, someFrustum(random, scene)));
    tree.update(scene);
    EXPECT_EQ(&tree.trianglesOf(1), &*ahead) << "it is kept";
}

// Triangles of any size make boxes useless: the search gives up and looks at all leaves once.
TEST(VisiblePart, OfATangleIsThatOfEveryTriangle) {
    Random random(22);
    for (const int triangles : {3000, 60000}) {
        Scene scene;
        test::Soup soup = test::tangle(static_cast<std::size_t>(triangles));
        addBatch(scene, std::move(soup.positions), std::move(soup.indices), 2);
        SceneBuilder ground;
        for (int x = -90; x < 90; x += 9)
            for (int z = -90; z < 90; z += 9)
                ground.quad({x, -3, z}, {x, -3, z + 9}, {x + 9, -3, z + 9}, {x + 9, -3, z});
        scene.batches.push_back(ground.scene().batches.front());
        scene.batches.back().ground = true;
        const SceneTree tree(scene);
        for (int view = 0; view < 6; ++view)
            EXPECT_TRUE(findsTheSame(scene, tree, someFrustum(random, scene), view % 2 == 0))
                << triangles << " triangles, view " << view;
    }
}

// Equal coordinates that are rounded differently: each may be the least.
TEST(VisiblePart, OfGridsAlongTheAxesIsThatOfEveryTriangle) {
    Random random(23);
    for (int i = 0; i < 20; ++i) {
        SceneBuilder builder;
        const float step = static_cast<float>(random.magnitude(-1, 1));
        for (int x = -9; x < 9; ++x)
            for (int z = -9; z < 9; ++z) {
                const float x0 = step * float(x), z0 = step * float(z);
                const float y = (x + z) % 7 == 0 ? step : 0.0f;
                builder.quad({x0, y, z0}, {x0, y, z0 + step}, {x0 + step, y, z0 + step},
                             {x0 + step, y, z0});
            }
        Scene scene = builder.scene();
        scene.culls = i % 2 == 0;
        if (i % 3 == 0) scene.batches[0].worldFromBatch = somePlace(random, 1e3);
        const SceneTree tree(scene);
        for (int view = 0; view < 20; ++view)
            EXPECT_TRUE(findsTheSame(scene, tree, someFrustum(random, scene)))
                << "grid " << i << ", view " << view;
    }
}

// Cones of normals leave out what shows its back; only what certainly does so is culled.
TEST(VisiblePart, OfCulledBallsIsThatOfEveryTriangle) {
    Random random(24);
    for (const std::uint32_t rows : {4u, 12u, 90u}) {
        Scene scene;
        addBall(scene, rows);
        for (int i = 0; i < 3; ++i) {
            scene.batches.push_back(scene.batches.front());
            scene.batches.back().worldFromBatch = somePlace(random, 4.0);
        }
        const SceneTree tree(scene);
        for (int view = 0; view < 40; ++view)
            EXPECT_TRUE(findsTheSame(scene, tree, someFrustum(random, scene)))
                << rows << " rows, view " << view;
    }
}

TEST(VisiblePart, OfMirroredBallsIsThatOfEveryTriangle) {
    Random random(33);
    Scene scene;
    addBall(scene, 24, 2);
    for (const double scale : {1.0, 0.1, 20.0}) {
        scene.batches[0].worldFromBatch =
            glm::scale(glm::dmat4(1.0), scale * glm::dvec3(1.0, -1.0, 1.0));
        const SceneTree tree(scene);
        for (int view = 0; view < 20; ++view)
            EXPECT_TRUE(findsTheSame(scene, tree, someFrustum(random, scene)))
                << "scale " << scale << ", view " << view;
    }
}

TEST(VisiblePart, FollowsMaterialsThatBecomeDoubleSided) {
    Scene scene;
    addBall(scene, 20, 2);
    SceneTree tree(scene);
    scene.materials.front().doubleSided = true;
    tree.update(scene);
    Random random(34);
    for (int view = 0; view < 20; ++view) {
        const glm::dvec3 eye = 5.0 * direction(random);
        EXPECT_TRUE(findsTheSame(scene, tree, frustumOf({eye, {0, 0, 0}, 60.0}, 1.0))) << view;
    }
}

// Cones only serve to cull.
TEST(VisiblePart, HasConesOfAWholeSceneAndNoneOfACutOne) {
    Scene whole;
    addBall(whole, 20, 2);
    const Scene cut = [&] {
        Scene made = whole;
        made.culls = false;
        made.cutFrom = CutFrom{std::make_shared<const Scene>(whole), {}};
        made.batches.front().geometry.edit().indices.resize(300);
        made.batches.front().geometry.edit().groups = {{0, 0, 300}};
        made.batches.push_back(whole.batches.front());
        return made;
    }();
    Random random(35);
    SceneTree tree(cut);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_FALSE(tree.trianglesOf(i).hasCones());
    EXPECT_TRUE(findsTheSame(cut, tree, someFrustum(random, cut)));
    tree.update(whole); // which has the geometry of the second batch
    EXPECT_TRUE(tree.trianglesOf(0).hasCones());
    for (int view = 0; view < 20; ++view)
        EXPECT_TRUE(findsTheSame(whole, tree, someFrustum(random, whole))) << view;
}

/// Corners of a rectangle across the viewing direction -z.
std::vector<glm::vec3> rectangle(const glm::vec2& low, const glm::vec2& high, float z) {
    return {{low.x, low.y, z}, {high.x, low.y, z}, {high.x, high.y, z}, {low.x, high.y, z}};
}
const std::vector<std::uint32_t> twoTriangles = {0, 1, 2, 0, 2, 3};

/// Lets a GL place a batch's corners with an error of 0.004, and changes nothing else.
void coarsen(Batch& batch) {
    batch.geometry.edit().positions.emplace_back(1000.0f); // of no triangle
}

// Errors of placing depend on a batch's coordinates: a place that reaches less far, in any
// direction, may still have the larger slopes.
TEST(VisiblePart, HasTheMarginsOfEachPlace) {
    const Frustum frustum = frustumOf({{0, 0, 0}, {0, 0, -1}, 90.0}, 1.0);
    Scene scene;
    addBatch(scene, rectangle({-1, -1}, {1, 1}, -5.0f), twoTriangles);
    addBatch(scene, rectangle({-1.19f, -1.19f}, {1.19f, 1.19f}, -6.0f), twoTriangles);
    addBatch(scene, rectangle({-1.098f, -1.098f}, {1.098f, 1.098f}, -5.5f), twoTriangles);
    coarsen(scene.batches[2]);
    EXPECT_TRUE(findsTheSame(scene, frustum));
    EXPECT_GT(visiblePart(scene, SceneTree(scene), frustum, false).slopes.right.high, 0.2 + 1e-3);
}

// Closer to the eye than errors of placing, surfaces may be anywhere in the window. That may be all
// that a place adds.
TEST(VisiblePart, FillsTheWindowCloseToTheEye) {
    const Frustum frustum = frustumOf({{0, 0, 0}, {0, 0, -1}, 150.0}, 1.0);
    Scene scene;
    addBatch(scene, rectangle({-15, -25}, {25, 25}, -5.0f), twoTriangles);
    addBatch(scene, rectangle({0.0272f, -1e-4f}, {0.0274f, 1e-4f}, -0.0078f), twoTriangles);
    addBatch(scene, rectangle({-1e-4f, -1e-4f}, {1e-4f, 1e-4f}, -0.001f), twoTriangles);
    coarsen(scene.batches[1]);
    EXPECT_TRUE(findsTheSame(scene, frustum));
    EXPECT_LT(visiblePart(scene, SceneTree(scene), frustum, false).slopes.right.low, -3.7);
}

TEST(VisiblePart, OfManyPlacesIsThatOfEveryTriangle) {
    Random random(25);
    for (int i = 0; i < 6; ++i) {
        Scene scene;
        for (int mesh = 0; mesh < 3; ++mesh) {
            addSoup(scene, random, 60);
            const CopyOnWrite<Geometry> shared = scene.batches.back().geometry;
            const double spread = random.magnitude(0, 2);
            const int places = random.below(120);
            scene.batches.back().worldFromBatch = somePlace(random, spread);
            for (int place = 0; place < places; ++place) {
                Batch& batch = scene.batches.emplace_back();
                batch.geometry = shared;
                batch.worldFromBatch = somePlace(random, spread);
            }
        }
        const SceneTree tree(scene);
        for (int view = 0; view < 10; ++view)
            EXPECT_TRUE(findsTheSame(scene, tree, someFrustum(random, scene)))
                << "scene " << i << ", view " << view;
    }
}

TEST(VisiblePart, FollowsPlacesThatMove) {
    Random random(26);
    Scene scene;
    addSoup(scene, random, 100);
    for (int place = 0; place < 30; ++place) {
        Batch& batch = scene.batches.emplace_back();
        batch.geometry = scene.batches.front().geometry;
    }
    SceneTree tree(scene);
    for (int frame = 0; frame < 10; ++frame) {
        for (Batch& batch : scene.batches)
            if (random.below(2)) batch.worldFromBatch = somePlace(random, 5.0);
        const SceneTree before = tree; // a copy stays as it is
        tree.update(scene);
        EXPECT_TRUE(findsTheSame(scene, tree, someFrustum(random, scene))) << "frame " << frame;
        EXPECT_EQ(&before.trianglesOf(0), &tree.trianglesOf(0)) << "the geometry is the same";
    }
}

TEST(VisiblePart, FollowsBatchesThatComeAndGo) {
    Random random(27);
    Scene scene;
    SceneTree tree;
    for (int frame = 0; frame < 30; ++frame) {
        switch (random.below(4)) {
        case 0:
            addSoup(scene, random, 40);
            scene.batches.back().worldFromBatch = somePlace(random, 3.0);
            break;
        case 1:
            if (!scene.batches.empty()) scene.batches.erase(scene.batches.begin());
            break;
        case 2: // nothing is left of it
            if (!scene.batches.empty()) scene.batches.back().geometry = CopyOnWrite<Geometry>();
            break;
        default: // another mesh in its place
            if (!scene.batches.empty()) {
                addSoup(scene, random, 30);
                scene.batches.front().geometry = scene.batches.back().geometry;
                scene.batches.pop_back();
            }
        }
        if (scene.batches.empty()) addSoup(scene, random, 5);
        tree.update(scene);
        EXPECT_TRUE(findsTheSame(scene, tree, someFrustum(random, scene))) << "frame " << frame;
    }
}

// Whoever edits a geometry that a tree knows gets a copy, so that no stale boxes are left.
TEST(VisiblePart, FollowsAGeometryThatIsEdited) {
    Random random(28);
    Scene scene;
    addSoup(scene, random, 50);
    SceneTree tree(scene);
    for (int frame = 0; frame < 5; ++frame) {
        for (glm::vec3& position : scene.batches[0].geometry.edit().positions)
            position += glm::vec3(random.inCube());
        tree.update(scene);
        EXPECT_TRUE(findsTheSame(scene, tree, someFrustum(random, scene))) << "frame " << frame;
    }
}

TEST(VisiblePart, FollowsBatchesThatDeform) {
    Random random(29);
    Scene scene;
    addBall(scene, 12);
    addSoup(scene, random, 50);
    Batch& ball = scene.batches.front();
    ball.deformation = std::make_shared<const Deformation>();
    ball.shape.weights = {{0.0}};
    SceneTree tree(scene);
    const Geometry* const geometry = &*ball.geometry;
    for (int frame = 0; frame < 8; ++frame) {
        const double bend = random.uniform(-0.5, 0.5);
        for (glm::vec3& position : ball.geometry.edit().positions)
            position = glm::vec3(glm::dvec3(position) + bend * random.inCube());
        ball.shape.weights[0][0] = frame + 1.0;
        const SceneTree before = tree;
        tree.update(scene);
        EXPECT_TRUE(findsTheSame(scene, tree, someFrustum(random, scene))) << "frame " << frame;
        EXPECT_NE(&before.trianglesOf(0), &tree.trianglesOf(0)) << "the copy is another pose's";
    }
    EXPECT_EQ(geometry, &*ball.geometry) << "a pose copies no mesh";
}

TEST(VisiblePart, OfHugeTinyAndFarOffScenesIsThatOfEveryTriangle) {
    Random random(30);
    for (const double scale : {1e-30, 1e-9, 1.0, 1e9, 1e30})
        for (const double away : {0.0, 1.0, 1e4, 1e9}) {
            Scene scene;
            addSoup(scene, random, 150);
            for (glm::vec3& position : scene.batches[0].geometry.edit().positions)
                position *= static_cast<float>(scale);
            const glm::dvec3 offset = scale * away * direction(random);
            scene.batches[0].worldFromBatch = glm::translate(glm::dmat4(1.0), offset);
            const SceneTree tree(scene);
            for (int view = 0; view < 8; ++view)
                EXPECT_TRUE(findsTheSame(scene, tree, someFrustum(random, scene)))
                    << "scale " << scale << ", away " << away << ", view " << view;
        }
}

// Sums overflow or aren't numbers: nothing may be left out because of a comparison with them.
TEST(VisiblePart, OfPlacesBeyondDoublesIsThatOfEveryTriangle) {
    Random random(31);
    for (const double far : {1e150, 1e300, 1e307, 1e308}) {
        Scene scene;
        addSoup(scene, random, 20);
        for (int place = 0; place < 8; ++place) {
            Batch& batch = scene.batches.emplace_back();
            batch.geometry = scene.batches.front().geometry;
            batch.worldFromBatch = glm::scale(
                glm::translate(glm::dmat4(1.0), far * random.inCube()),
                random.below(2) ? glm::dvec3(1.0) : glm::dvec3(far * random.uniform(0.0, 1.0)));
        }
        const SceneTree tree(scene);
        for (int view = 0; view < 8; ++view) {
            const glm::dvec3 eye = 3.0 * random.inCube();
            const Frustum frustum = frustumFrom(random, eye, eye + direction(random), 1.0);
            EXPECT_TRUE(findsTheSame(scene, tree, frustum)) << far << ", view " << view;
        }
    }
}

// One triangle overflows, but another one of the same batch is visible. Other places, which are
// not, are neighbours in the tree.
TEST(VisiblePart, HasSurfacesOfAPlaceWhoseBoxOverflows) {
    Scene scene;
    const float small = 1e-40f;
    addBatch(scene,
             {{-small, -small, -small},
              {small, -small, -small},
              {0, small, -small},
              {9, 9, 9},
              {8, 9, 9},
              {9, 8, 9}},
             {0, 1, 2, 3, 4, 5});
    scene.batches[0].worldFromBatch = glm::scale(glm::dmat4(1.0), glm::dvec3(1e308));
    for (int i = 0; i < 12; ++i)
        scene.batches.push_back(SceneBuilder().box({-1, -1, 4}, {1, 1, 5}).scene().batches[0]);
    scene.culls = false;
    const Frustum frustum = frustumOf({{0, 0, 0}, {0, 0, -1}, 120.0}, 1.0);
    EXPECT_TRUE(findsTheSame(scene, frustum));
    EXPECT_GT(visiblePart(scene, SceneTree(scene), frustum, false).depth.farthest, 1e267);
}

TEST(VisiblePart, IsEmptyWithoutSurfaces) {
    const Frustum frustum = frustumOf({{0, 0, 1}, {0, 0, 0}, 60.0}, 1.0);
    Scene scene;
    EXPECT_TRUE(findsTheSame(scene, frustum));
    scene.batches.resize(3);
    EXPECT_TRUE(findsTheSame(scene, frustum));
    EXPECT_TRUE(visiblePart(scene, SceneTree(scene), frustum, false).depth.empty());
    // Behind the eye there is one.
    scene.batches[1] = SceneBuilder().box({-1, -1, 4}, {1, 1, 5}).scene().batches[0];
    EXPECT_TRUE(visiblePart(scene, SceneTree(scene), frustum, false).depth.empty());
}

TEST(VisiblePart, HasTheGroundIfItIsShown) {
    Scene scene = SceneBuilder().box({-1, 0, -1}, {1, 1, 1}).scene();
    scene.batches.push_back(SceneBuilder().floor(50.0f).scene().batches.front());
    scene.batches.back().ground = true;
    const Frustum frustum = frustumOf({{0, 3, 9}, {0, 0, 0}, 50.0}, 1.0);
    const SceneTree tree(scene);
    EXPECT_TRUE(findsTheSame(scene, tree, frustum, true));
    EXPECT_TRUE(findsTheSame(scene, tree, frustum, false));
    EXPECT_GT(visiblePart(scene, tree, frustum, true).depth.farthest,
              visiblePart(scene, tree, frustum, false).depth.farthest);
}

// A frame's numbers, from the bounds that the loop finds.
TEST(FrameView, HasTheNumbersOfEveryTriangle) {
    Random random(32);
    for (int i = 0; i < 40; ++i) {
        Scene scene;
        addSoup(scene, random, 80);
        addBall(scene, 6);
        for (Batch& batch : scene.batches)
            batch.worldFromBatch = somePlace(random, 2.0);
        scene.batches.front().hidden = i % 4 == 0; // it counts, as it did at its last place
        scene.batches.push_back(SceneBuilder().floor(9.0f, -5.0f).scene().batches.front());
        scene.batches.back().ground = true;
        const Box bounds = worldBounds(scene);
        FrameRequest request;
        request.frustum = someFrustum(random, scene);
        request.lights = {{{0.3, 1.0, 0.2, 0.0}}};
        request.ground = i % 3 != 0;
        if (i % 5 == 0) request.depth.near = random.magnitude(-3, 1);
        const FrameView view = makeFrameView(scene, request, bounds, SceneTree(scene));
        const VisiblePart wanted = test::plainVisiblePart(scene, view.frustum, view.ground);
        VisiblePart found{{wanted.depth.nearest, view.farthestDepth}, view.visible, view.slopes};
        EXPECT_EQ(numbersOf(found), numbersOf(wanted)) << i;
        if (!view.frustum.orthographic) {
            EXPECT_EQ(view.near(), request.depth.near.value_or(
                                       fittedNear(wanted.depth.nearest, bounds.diagonal())))
                << i;
        }
        ASSERT_EQ(view.nearestDepths.size(), scene.batches.size());
        for (std::size_t b = 0; b < scene.batches.size(); ++b) {
            VisiblePart alone;
            if (!scene.batches[b].ground || view.ground)
                test::addPlainly(scene, scene.batches[b], view.frustum, alone);
            EXPECT_EQ(view.nearestDepths[b], alone.depth.nearest) << i << ", batch " << b;
        }
        request.nearestDepths = false;
        EXPECT_TRUE(makeFrameView(scene, request, bounds).nearestDepths.empty());
    }
}

TEST(FrameView, MayMeetTheNearPlaneWhereDepthsAreUnknown) {
    FrameView view;
    EXPECT_TRUE(view.mayMeetNear(3, {.near = 0.1}));
    view.nearestDepths = {0.05, 0.1, 0.2};
    EXPECT_TRUE(view.mayMeetNear(0, {.near = 0.1}));
    EXPECT_TRUE(view.mayMeetNear(1, {.near = 0.1}));
    EXPECT_FALSE(view.mayMeetNear(2, {.near = 0.1}));
}

} // namespace
} // namespace edgeshade

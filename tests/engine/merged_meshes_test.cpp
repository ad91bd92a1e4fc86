// Small meshes that rest are merged, and masks stay what they were.
#include "src/engine/lookup_work.hpp"
#include "src/engine/mesh_merging.hpp"
#include "tests/engine/masks_in_a_host.hpp"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace edgeshade {
namespace {

using namespace test;

const Camera above{{6, 7, 9}, {0, 0.5, 0}, 50.0};
constexpr int draws = 40; // more than meshes have to rest

Scene box() {
    return SceneBuilder().box({-0.25f, 0.25f, -0.25f}, {0.25f, 0.75f, 0.25f}).scene();
}

/// Places of small boxes over a yard, row by row.
std::vector<glm::dmat4> rows(int count) {
    std::vector<glm::dmat4> places;
    for (int i = 0; i < count; ++i)
        places.push_back(
            glm::translate(glm::dmat4(1.0), {i % 6 - 2.5, 0.5 * (i % 3), i / 6 - 2.5}));
    return places;
}

/// Masks of boxes over a yard.
class Yard {
  public:
    explicit Yard(const std::vector<glm::dmat4>& places, const MaskMesh& mesh) : prepared_(mesh) {
        const Scene ground = yard().scene();
        masks.add(meshOf(geometryOf(ground)));
        for (const glm::dmat4& place : places)
            ids.push_back(masks.add(prepared_, numbersOf(place)));
    }
    std::vector<std::uint8_t> drawn(int times = 1) {
        const MaskLight light = hostLight(pointLight({0.3, 6, 0.7}));
        for (int i = 0; i < times; ++i)
            masks.draw(viewOf(above), {&light, 1});
        return readMask(masks, 0);
    }
    std::size_t batches() const { return masks.cost().batches; }

    ShadowMasks masks{eglLookUp};
    std::vector<ShadowMasks::Id> ids;

  private:
    PreparedMesh prepared_;
};

std::size_t differing(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        count += a[i] != b[i];
    return count;
}

} // namespace

TEST(MergedMeshes, TakeTheDrawsOfFewMeshesOnceTheyRest) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const Scene scene = box();
    Yard yard(rows(36), meshOf(geometryOf(scene)));
    const auto single = yard.drawn();
    const std::size_t state = yard.masks.casterState();
    EXPECT_EQ(yard.batches(), 37u);
    EXPECT_EQ(yard.drawn(draws), single);
    EXPECT_LE(yard.batches(), 3u);
    EXPECT_EQ(yard.masks.casterState(), state) << "lights that rest keep their lookups";
}

TEST(MergedMeshes, MadeBeforeTheyAreAddedTakeFewDrawsFromTheFirst) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const Scene scene = box(), ground = yard().scene();
    const std::vector<glm::dmat4> places = rows(36);
    const PreparedMesh prepared(meshOf(geometryOf(scene)));
    std::vector<MergedMeshes::Member> members;
    for (const glm::dmat4& place : places)
        members.push_back({prepared, numbersOf(place)});
    const std::vector<MergedMeshes> made = MergedMeshes::of(members);
    ASSERT_EQ(made.size(), 1u);
    ASSERT_EQ(made[0].members().size(), 36u);
    Yard single(places, meshOf(geometryOf(scene))), merged({}, meshOf(geometryOf(scene)));
    merged.masks.upload(made[0]);
    const std::vector<ShadowMasks::Id> ids = merged.masks.add(made[0]);
    EXPECT_EQ(merged.drawn(), single.drawn());
    EXPECT_EQ(merged.batches(), 2u);
    EXPECT_EQ(merged.masks.lookupWork({}).data()->task.casters.size(), 37u)
        << "lookups have each mesh by itself";
    const glm::dmat4 away = glm::translate(glm::dmat4(1.0), {0.5, 2.0, 1.5});
    merged.masks.move(ids[7], numbersOf(away));
    single.masks.move(single.ids[made[0].members()[7]], numbersOf(away));
    EXPECT_EQ(merged.drawn(), single.drawn());
    EXPECT_EQ(merged.batches(), 37u);
    for (const ShadowMasks::Id id : ids)
        merged.masks.remove(id);
    EXPECT_EQ(merged.masks.lookupWork({}).data()->task.casters.size(), 1u);
}

TEST(MergedMeshes, UploadedInStepsAreTheSame) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const Scene scene = box();
    const MaskMesh mesh = meshOf(geometryOf(scene));
    const PreparedMesh prepared(mesh);
    std::vector<MergedMeshes::Member> members;
    for (const glm::dmat4& place : rows(36))
        members.push_back({prepared, numbersOf(place)});
    const std::vector<MergedMeshes> made = MergedMeshes::of(members);
    ASSERT_EQ(made.size(), 1u);
    Yard single(rows(36), mesh);
    const std::vector<std::uint8_t> expected = single.drawn();
    for (const int steps : {1, 2, 3, 4}) { // the next draw makes what is missing
        Yard merged({}, mesh);
        for (int step = 1; step <= steps; ++step)
            EXPECT_EQ(merged.masks.uploadStep(made[0]), step == 4) << "step " << step;
        merged.masks.add(made[0]);
        EXPECT_EQ(merged.drawn(), expected) << steps << " steps";
        EXPECT_EQ(merged.batches(), 2u);
    }
}

TEST(MergedMeshes, LeaveOutLargeAlphaTestedAndLonelyMeshes) {
    const Scene scene = box();
    MaskMesh tested = meshOf(geometryOf(scene));
    tested.alphaTested = true;
    std::vector<float> many;
    for (std::size_t i = 0; i < 3 * 3 * (mostTrianglesOfMember + 1); ++i)
        many.push_back(static_cast<float>(i * i % 97));
    std::vector<std::uint32_t> corners(many.size() / 3);
    std::iota(corners.begin(), corners.end(), 0u);
    const PreparedMesh small(meshOf(geometryOf(scene))),
        large(MaskMesh{.positions = many, .indices = corners}), holes(tested);
    const glm::dmat4 faraway = glm::translate(glm::dmat4(1.0), {1e6, 0, 0});
    std::vector<MergedMeshes::Member> members{{large}, {holes}, {small, numbersOf(faraway)}};
    for (const glm::dmat4& place : rows(5))
        members.push_back({small, numbersOf(place)});
    const std::vector<MergedMeshes> made = MergedMeshes::of(members);
    ASSERT_EQ(made.size(), 1u);
    std::vector<std::size_t> merged(made[0].members().begin(), made[0].members().end());
    std::sort(merged.begin(), merged.end());
    EXPECT_EQ(merged, (std::vector<std::size_t>{3, 4, 5, 6, 7}));
    EXPECT_TRUE(MergedMeshes::of({}).empty());
    members.front().worldFromObject[0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(MergedMeshes::of(members), std::runtime_error);
}

TEST(MergedMeshes, FollowAMemberThatMovesChangesOrGoes) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const Scene scene = box(), other = SceneBuilder().box({-1, 1, -1}, {1, 1.1f, 1}).scene();
    const std::vector<glm::dmat4> places = rows(24);
    Yard merged(places, meshOf(geometryOf(scene))), fresh(places, meshOf(geometryOf(scene)));
    merged.drawn(draws);
    const glm::dmat4 away = glm::translate(glm::dmat4(1.0), {0.5, 2.0, 1.5});
    for (Yard* yard : {&merged, &fresh})
        yard->masks.move(yard->ids[7], numbersOf(away));
    EXPECT_EQ(merged.drawn(), fresh.drawn());
    EXPECT_EQ(merged.batches(), 25u) << "its neighbours are split off too";
    merged.drawn(draws);
    EXPECT_LE(merged.batches(), 4u) << "the neighbours are merged again";
    for (Yard* yard : {&merged, &fresh})
        yard->masks.change(yard->ids[3], meshOf(geometryOf(other)));
    EXPECT_EQ(merged.drawn(), fresh.drawn());
    merged.drawn(draws);
    for (Yard* yard : {&merged, &fresh})
        for (const std::size_t i : {std::size_t{3}, std::size_t{12}})
            yard->masks.remove(yard->ids[i]);
    EXPECT_EQ(merged.drawn(), fresh.drawn());
    EXPECT_THROW(merged.masks.remove(merged.ids[12]), std::runtime_error);
}

TEST(MergedMeshes, AreNotMadeOfWhatMovesEachFrame) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const Scene scene = box();
    Yard yard(rows(12), meshOf(geometryOf(scene)));
    for (int i = 0; i < draws; ++i) {
        for (const ShadowMasks::Id id : yard.ids)
            yard.masks.move(id, numbersOf(glm::translate(glm::dmat4(1.0), {0.0, 0.01 * i, 0.0})));
        yard.drawn();
    }
    EXPECT_EQ(yard.batches(), 13u);
}

TEST(MergedMeshes, AreStillMergedIfTheHostMovesThemToWhereTheyAre) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const Scene scene = box();
    const std::vector<glm::dmat4> places = rows(12);
    Yard yard(places, meshOf(geometryOf(scene)));
    for (int i = 0; i < draws; ++i) {
        for (std::size_t k = 0; k < places.size(); ++k)
            yard.masks.move(yard.ids[k], numbersOf(places[k]));
        yard.drawn();
    }
    EXPECT_LE(yard.batches(), 3u);
}

TEST(MergedMeshes, KeepTheFrontsOfMirroredOnes) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    // Boxes without lids, of which only the outside is visible.
    const Scene scene = box();
    Geometry open = geometryOf(scene);
    open.indices.resize(open.indices.size() - 6);
    open.groups.front().indexCount -= 6;
    MaskMesh mesh = meshOf(open);
    mesh.doubleSided = false;
    std::vector<glm::dmat4> places = rows(24);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (i % 2 == 0) places[i] = glm::scale(places[i], {-1.0, 1.0, 1.0});
        places[i] = glm::rotate(places[i], 0.37 * static_cast<double>(i), {0.3, 1.0, 0.2});
    }
    Yard yard(places, mesh);
    const auto single = yard.drawn();
    const auto merged = yard.drawn(draws);
    EXPECT_LE(yard.batches(), 4u);
    EXPECT_LE(differing(single, merged), 4u) << "of those on a boundary";
    EXPECT_GT(std::count(single.begin(), single.end(), 0), 500);
}

TEST(MergedMeshes, OfReceiversCastNothing) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const Scene scene = box();
    MaskMesh mesh = meshOf(geometryOf(scene));
    mesh.casts = false;
    Yard receivers(rows(24), mesh);
    const auto single = receivers.drawn();
    EXPECT_EQ(receivers.drawn(draws), single);
    EXPECT_LE(receivers.batches(), 3u);
    Yard casters(rows(24), meshOf(geometryOf(scene)));
    EXPECT_GT(differing(casters.drawn(), single), 500u);
}

TEST(MergedMeshes, AreNoLargerThanTheirVerticesPrecisionAllows) {
    std::vector<MergeCandidate> candidates;
    for (std::size_t i = 0; i < 9; ++i) {
        MergeCandidate& of = candidates.emplace_back();
        of.number = 10 + i;
        of.triangles = 12;
        of.box.add(glm::dvec3(500.0 * static_cast<double>(i), 0.0, 0.0));
        of.box.add(of.box.low + glm::dvec3(1.0));
    }
    EXPECT_EQ(neighbours(candidates), (std::vector<std::size_t>{10, 11, 12, 13}))
        << "a thousand times as large as one of them";
    candidates[1].material = 2;
    EXPECT_EQ(neighbours(candidates), (std::vector<std::size_t>{10, 12, 13})) << "of one material";
    candidates[2].triangles = mostTrianglesMerged;
    EXPECT_EQ(neighbours(candidates), (std::vector<std::size_t>{10, 13}));
    EXPECT_TRUE(neighbours({}).empty());
}

} // namespace edgeshade

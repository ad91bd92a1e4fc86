#include "web/masks/lookup_transfer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>

namespace edgeshade::test {
namespace {

/// A fan of triangles around the origin.
PreparedMesh fan(std::uint32_t triangles, bool alphaTested = false) {
    std::vector<float> positions = {0.0f, 0.0f, 0.0f};
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i <= triangles; ++i) {
        const float at = 6.0f * static_cast<float>(i) / static_cast<float>(triangles + 1);
        positions.insert(positions.end(), {std::cos(at), 0.1f * at, std::sin(at)});
        if (i > 0) indices.insert(indices.end(), {0, i, i + 1});
    }
    return PreparedMesh(MaskMesh{
        .positions = positions, .indices = indices, .casts = true, .alphaTested = alphaTested});
}

/// A task of two places of one mesh, a larger mesh, a cut-out one with texels, and a tinted one.
LookupWork sampleWork() {
    LookupTask task;
    task.light.position = {0.3, 1.0, 0.2, 0.0};
    task.settings.size = 64;
    task.settings.casters = {true, true};
    const PreparedMesh small = fan(5), large = fan(300), leaf = fan(4, true);
    auto texels = std::make_shared<MaskTexels>();
    texels->width = texels->height = 2;
    texels->alpha = {0, MaskTexels::full, MaskTexels::full, 0};
    std::vector<HeldCaster> held;
    const auto add = [&](LookupTask::Caster caster) {
        caster.worldFromBatch[3] = {static_cast<double>(held.size()), 0.0, 0.0, 1.0};
        task.casters.push_back(std::move(caster));
        held.push_back({held.size(), held.size() + 7});
    };
    add({.shadow = small.data()->shadow});
    add({.shadow = large.data()->shadow});
    add({.shadow = small.data()->shadow});
    add({.shadow = nullptr, .cutout = {leaf.data(), {.texels = texels}, {}}});
    add({.shadow = nullptr, .cutout = {leaf.data(), {}, std::array{0.5f, 0.2f, 1.0f}}});
    return workOn(std::move(task), std::move(held));
}

Bytes inParts(const LookupWork& work, std::size_t most) {
    web::TaskTransfer transfer(work);
    Bytes all;
    for (;;) {
        const Bytes part = transfer.next(most);
        EXPECT_LE(part.size(), most);
        all.insert(all.end(), part.begin(), part.end());
        if (part.size() < most) return all;
    }
}

} // namespace

TEST(LookupTransfer, PartsOfAnySizeAreTheSameBytes) {
    const LookupWork work = sampleWork();
    const Bytes whole = inParts(work, std::size_t{1} << 24);
    ASSERT_GT(whole.size(), 300 * sizeof(CapRecord));
    for (const std::size_t most : {std::size_t{1}, std::size_t{7}, std::size_t{256}, whole.size()})
        EXPECT_EQ(inParts(work, most), whole) << most;
}

TEST(LookupTransfer, TheMapIsTheSameThere) {
    LookupWork here = sampleWork(), there = web::taskFromTransfer(inParts(sampleWork(), 100));
    here.finish();
    there.finish();
    const BuiltLookup &a = here.data()->built, &b = there.data()->built;
    EXPECT_EQ(a.why, "");
    EXPECT_EQ(b.why, "");
    ASSERT_GT(a.map.texels.size(), 100u);
    EXPECT_EQ(a.map.texels, b.map.texels);
    EXPECT_EQ(a.map.mapFromWorld, b.map.mapFromWorld);
}

TEST(LookupTransfer, WhatIsGoneMeanwhileStays) {
    std::optional<LookupWork> work = sampleWork();
    const Bytes whole = inParts(*work, 1000);
    web::TaskTransfer transfer(*work);
    Bytes all = transfer.next(100);
    work.reset();
    for (Bytes part = transfer.next(100); !part.empty(); part = transfer.next(100))
        all.insert(all.end(), part.begin(), part.end());
    EXPECT_EQ(all, whole);
}

} // namespace edgeshade::test

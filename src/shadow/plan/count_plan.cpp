#include "src/shadow/plan/count_plan.hpp"

#include "src/shadow/lights/light_extent.hpp"
#include "src/shadow/view/reached_part.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace edgeshade {

namespace {

constexpr std::size_t leastDraws = 16; // that lists have room for

} // namespace

std::size_t CountPlan::vertexRuns() const {
    std::size_t runs = 0;
    for (const auto* list : {&draws.twice, &draws.once})
        for (const VolumeDraw& draw : *list)
            runs += draw.vertexRuns();
    return runs;
}

void CountPlan::clear() {
    batches.clear();
    byPoints = false;
    fullyShadowed = false;
    start = {};
    for (auto* list : {&draws.twice, &draws.once}) {
        // Room for more of them in later frames.
        const std::size_t known = list->size();
        list->clear();
        if (list->capacity() < std::max(2 * known, leastDraws))
            list->reserve(4 * known + leastDraws);
    }
}

namespace {

/// Adds a caster that is left out as a whole.
void addLeftOut(const PlacedShadow& caster, const LeftOut& leftOut, const Light& light,
                CountPlan& plan) {
    BatchPlan& of = plan.batches.add();
    of.batch = caster.batch;
    of.worldFromBatch = caster.worldFromBatch;
    of.light = lightInObject(light, caster.worldFromBatch);
    of.shadow = caster.shadow;
    of.volumes.leftOut.push_back(leftOut);
}

/// Adds a caster whose view is `place`; its clusters are planned one by one.
void addClusters(const PlacedShadow& caster, PlanView& place, const PlanSettings& settings,
                 PlanMemory& memory, CountPlan& plan) {
    // The view has the list for a while, and then the memory again.
    std::swap(place.contact, memory.contact);
    findContactCaps(*caster.shadow, place.light, settings.mantissaBits, place.contact);
    std::span<const std::uint8_t> solids;
    if (place.culls && settings.solids) solids = settings.solids->of(caster.shadow);
    BatchPlan& of = plan.batches.add();
    of.batch = caster.batch;
    of.worldFromBatch = caster.worldFromBatch;
    of.light = glm::vec4(place.light);
    of.eye = glm::vec4(place.eye);
    of.reach = place.contact.reach;
    of.shadow = caster.shadow;
    planClusters(*caster.shadow, place, solids, memory.clusters, of.volumes);
    of.ends = place.ends;
    std::swap(place.contact, memory.contact);
    plan.start.add(of.volumes);
    plan.fullyShadowed = plan.fullyShadowed || of.volumes.fullyShadowedBy.has_value();
}

/// The silhouettes of a batch that is drawn; null if they aren't listed in this frame.
const SilhouetteList* silhouettesOf(const BatchPlan& of, double range, const FrameView& view,
                                    std::size_t light, PotentialSilhouettes& silhouettes) {
    SilhouetteKey key{of.shadow, of.batch, view.numberOf(light)};
    key.range = range;
    key.reach = of.reach;
    if (const auto& among = view.lights[light].among) {
        key.light = among->light;
        key.around = ballInObject(among->region, of.worldFromBatch);
    }
    return silhouettes.of(key, of.light);
}

} // namespace

void planCount(const std::vector<PlacedShadow>& casters, const std::vector<Material>& materials,
               const FrameView& view, const DepthSlice& slice, std::size_t light,
               const PlanSettings& settings, CountPlan& plan) {
    PlanMemory own;
    PlanMemory& memory = settings.memory ? *settings.memory : own;
    const Light& source = view.lights[light].light;
    plan.clear();
    memory.ranges.clear();
    findReachedPart(view, slice, source, memory.seen);
    const PlanView inWorld =
        planView(memory.seen, slice, source, glm::dmat4(1.0), settings.mantissaBits);
    findPlanesBetween(memory.seen, source, memory.between);
    for (const PlacedShadow& caster : casters) {
        memory.betweenInBatch.clear();
        for (const glm::dvec4& plane : memory.between)
            memory.betweenInBatch.push_back(glm::transpose(caster.worldFromBatch) * plane);
        if (const auto leftOut = leftOutWhole(*caster.shadow, caster.worldFromBatch, inWorld,
                                              memory.betweenInBatch)) {
            memory.ranges.push_back(std::numeric_limits<double>::infinity());
            addLeftOut(caster, *leftOut, source, plan);
            continue;
        }
        PlanView place =
            planView(memory.seen, slice, source, caster.worldFromBatch, settings.mantissaBits);
        place.between = memory.betweenInBatch;
        memory.ranges.push_back(place.range);
        addClusters(caster, place, settings, memory, plan);
    }
    if (plan.fullyShadowed) {
        for (BatchPlan& of : plan.batches)
            mergeAlike(of.volumes);
        plan.start.setFullyShadowed();
        return;
    }
    for (std::size_t i = 0; i < plan.batches.size(); ++i) {
        BatchPlan& of = plan.batches[i];
        if (of.volumes.drawn.empty()) continue;
        if (settings.silhouettes)
            of.silhouettes =
                silhouettesOf(of, memory.ranges[i], view, light, *settings.silhouettes);
        mergeAlike(of.volumes);
        appendDraws(of, i, materials, memory.fanned, plan.draws);
    }
    if (!plan.draws.twice.empty()) plan.start.setDoubled();
}

} // namespace edgeshade

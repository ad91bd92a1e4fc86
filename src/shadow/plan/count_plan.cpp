#include "src/shadow/plan/count_plan.hpp"

#include "src/shadow/lights/light_extent.hpp"
#include "src/shadow/view/reached_part.hpp"

namespace edgeshade {

std::size_t CountPlan::vertexRuns() const {
    std::size_t runs = 0;
    for (const auto* list : {&draws.twice, &draws.once})
        for (const VolumeDraw& draw : *list)
            runs += draw.vertexRuns();
    return runs;
}

CountPlan planCount(const std::vector<PlacedShadow>& casters,
                    const std::vector<Material>& materials, const FrameView& view,
                    const DepthSlice& slice, std::size_t light, const PlanSettings& settings) {
    const Light& source = view.lights[light].light;
    CountPlan plan;
    std::vector<PlanView> places;
    const FrameView seen = reachedPart(view, slice, source);
    const PlanView inWorld = planView(seen, slice, source, glm::dmat4(1.0), settings.mantissaBits);
    for (const PlacedShadow& caster : casters) {
        if (const auto leftOut = leftOutWhole(*caster.shadow, caster.worldFromBatch, inWorld)) {
            places.emplace_back();
            BatchPlan& of = plan.batches.emplace_back();
            of.batch = caster.batch;
            of.worldFromBatch = caster.worldFromBatch;
            of.light = lightInObject(source, caster.worldFromBatch);
            of.shadow = caster.shadow;
            of.volumes.leftOut.push_back(*leftOut);
            continue;
        }
        places.push_back(
            planView(seen, slice, source, caster.worldFromBatch, settings.mantissaBits));
        places.back().contact =
            contactCapsOf(*caster.shadow, places.back().light, settings.mantissaBits);
        std::span<const std::uint8_t> solids;
        if (view.culls && settings.solids) solids = settings.solids->of(caster.shadow);
        plan.batches.push_back({.batch = caster.batch,
                                .worldFromBatch = caster.worldFromBatch,
                                .light = glm::vec4(places.back().light),
                                .eye = glm::vec4(places.back().eye),
                                .reach = places.back().contact.reach,
                                .shadow = caster.shadow,
                                .volumes = planClusters(*caster.shadow, places.back(), solids),
                                .ends = places.back().ends});
        plan.start.add(plan.batches.back().volumes);
        plan.fullyShadowed =
            plan.fullyShadowed || plan.batches.back().volumes.fullyShadowedBy.has_value();
    }
    if (plan.fullyShadowed) {
        for (BatchPlan& of : plan.batches)
            mergeAlike(of.volumes);
        plan.start.setFullyShadowed();
        return plan;
    }
    for (std::size_t i = 0; i < plan.batches.size(); ++i) {
        BatchPlan& of = plan.batches[i];
        if (of.volumes.drawn.empty()) continue;
        if (settings.silhouettes) {
            SilhouetteKey key{of.shadow, of.batch, light};
            key.range = places[i].range;
            key.reach = of.reach;
            if (const auto& among = view.lights[light].among) {
                key.light = among->light;
                key.around = ballInObject(among->region, casters[i].worldFromBatch);
            }
            of.silhouettes = &settings.silhouettes->of(key, of.light);
        }
        mergeAlike(of.volumes);
        appendDraws(of, i, materials, plan.draws);
    }
    if (!plan.draws.twice.empty()) plan.start.setDoubled();
    return plan;
}

} // namespace edgeshade

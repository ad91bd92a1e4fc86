#include "src/shadow/plan/explain.hpp"

#include "src/shadow/plan/volume_fill.hpp"

#include <cmath>
#include <sstream>

namespace edgeshade {
namespace {

/// "3 things", "1 thing".
std::string counted(std::size_t count, const std::string& thing) {
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::string clustersOf(const RecordRange& clusters) {
    return counted(clusters.count, "cluster") + " from " + std::to_string(clusters.first);
}

std::size_t trianglesOf(const PlanePairShadow& shadow, const RecordRange& clusters) {
    std::size_t triangles = 0;
    for (std::uint32_t c = clusters.first; c < clusters.end(); ++c)
        triangles += shadow.clusters[c].caps.count;
    return triangles;
}

const char* wordsFor(Counted counted) {
    switch (counted) {
    case Counted::lightFacing:
        return "light-facing triangles only: closed, with eye and light both inside or both "
               "outside";
    case Counted::facingAway:
        return "only triangles that face away from the light: closed, with eye and light both "
               "inside or both outside, and partly culled";
    case Counted::all:
        break;
    }
    return "all triangles: open, or eye, near plane or light may be inside";
}

const char* wordsFor(CapsNeeded caps) {
    switch (caps) {
    case CapsNeeded::no:
        return "z-pass without caps";
    case CapsNeeded::cutoutsAlone:
        return "z-pass with front caps in the cutouts of casters";
    case CapsNeeded::seenThrough:
        return "z-fail with caps: casters are alpha-tested";
    case CapsNeeded::nearPlaneMet:
        return "z-fail with caps: a triangle may cross the near plane";
    case CapsNeeded::outlineMet:
        return "z-fail with caps: a shadow's outline may run through the near rectangle";
    case CapsNeeded::uncertain:
        break;
    }
    return "z-fail with caps: which casters lie between near plane and light is uncertain";
}

const char* wordsFor(LeftOut::Why why) {
    switch (why) {
    case LeftOut::Why::outsideView:
        return "their volumes miss the view";
    case LeftOut::Why::tooDeep:
        return "their volumes begin behind all visible geometry";
    case LeftOut::Why::tooFar:
        return "they are beyond the light's range";
    case LeftOut::Why::outsideCone:
        return "they are outside the light's cone";
    case LeftOut::Why::besideVisible:
        return "they are not between the light and anything visible";
    }
    return {};
}

std::string placeOf(const glm::dvec4& light) {
    std::ostringstream text;
    text << (light.w == 0.0 ? "sun towards " : "at ") << light.x << "," << light.y << ","
         << light.z;
    return text.str();
}

/// Describes the records that the draws choose from.
std::string offered(const CountPlan& plan) {
    std::size_t pairs = 0, singles = 0, listed = 0;
    bool all = true;
    for (const BatchPlan& batch : plan.batches) {
        pairs += batch.shadow->pairs.size();
        singles += batch.shadow->singles.size();
        if (!batch.silhouettes) continue;
        listed += batch.silhouettes->size();
        all = false;
    }
    std::ostringstream text;
    if (all)
        text << "all " << pairs << " pair records and ";
    else
        text << listed << " of " << pairs << " pair records, those that can be silhouettes, and ";
    text << counted(singles, "single record");
    return text.str();
}

/// Describes the records and caps that the draws for one range of clusters send to the vertex
/// shader: "; 12 side records, 3 fan records, 40 caps".
std::string takenBy(const CountPlan& plan, std::size_t batch, std::size_t choice) {
    std::size_t sides = 0, twice = 0, fans = 0, caps = 0, tested = 0, culled = 0;
    for (const auto* draws : {&plan.draws.twice, &plan.draws.once})
        for (const VolumeDraw& draw : *draws) {
            if (draw.batch != batch || draw.choice != choice) continue;
            const bool isSides = draw.shape == VolumeDraw::Shape::sides;
            (isSides                                 ? sides
             : draw.shape == VolumeDraw::Shape::fans ? fans
             : draw.culled                           ? culled
                                                     : caps) += draw.range.count;
            if (isSides && draw.times == Times::twice) twice += draw.range.count;
            if (draw.alphaTested && !draw.culled) tested += draw.range.count;
        }
    std::ostringstream text;
    text << "; " << counted(sides, "side record");
    if (twice > 0) text << ", " << twice << " of them for sides that count twice";
    if (fans > 0) text << ", " << counted(fans, "fan record") << " as caps";
    if (caps > 0) text << ", " << counted(caps, "cap");
    if (tested > 0) text << ", " << tested << " of them alpha-tested";
    if (culled > 0)
        text << ", " << counted(culled, "more cap") << " of single-sided triangles, drawn in place";
    return text.str();
}

std::string explain(const FillCost& fill) {
    std::ostringstream text;
    text << "estimated fill: " << std::llround(fill.triangles) << " triangles, "
         << std::llround(fill.tilePairs) << " pairs of triangle and 64 x 64 pixel tile, "
         << std::llround(fill.fragments) << " fragments; "
         << std::round(1e-4 * FillWeights().of(fill)) / 100.0 << " ms with llvmpipe\n";
    return text.str();
}

std::string explain(const CountPlan& plan) {
    std::ostringstream text;
    text << "the stencil count starts at " << plan.start.count() << "\n";
    for (std::size_t i = 0; i < plan.batches.size(); ++i) {
        const BatchPlan& batch = plan.batches[i];
        const PlanePairShadow& shadow = *batch.shadow;
        text << "batch " << batch.batch << ": " << counted(shadow.caps.size(), "casting triangle")
             << " in " << counted(shadow.clusters.size(), "cluster") << "\n";
        if (const auto& by = batch.volumes.fullyShadowedBy) {
            text << "  cluster " << *by << " is closed, with eye and light on different sides: "
                 << "all visible geometry is in its shadow, and no volumes are drawn\n";
            continue;
        }
        for (std::size_t choice = 0; choice < batch.volumes.drawn.size(); ++choice) {
            const ClusterPlan& drawn = batch.volumes.drawn[choice];
            text << (plan.fullyShadowed ? "  not needed: " : "  drawn: ")
                 << clustersOf(drawn.clusters) << ", "
                 << counted(trianglesOf(shadow, drawn.clusters), "triangle") << "; "
                 << wordsFor(drawn.caps);
            if (drawn.end >= 0) text << ", ending beyond all visible geometry";
            if (drawn.start != 0)
                text << ", the near rectangle inside " << counted(drawn.start, "volume");
            if (drawn.zFail())
                text << (drawn.frontCaps ? "" : ", no front caps in view")
                     << (drawn.backCaps ? "" : ", no back caps in view")
                     << (drawn.nearDiscard ? ", cut at the near plane" : "");
            text << "; " << wordsFor(drawn.counted);
            if (!plan.fullyShadowed) text << takenBy(plan, i, choice);
            text << "\n";
        }
        for (const LeftOut& left : batch.volumes.leftOut)
            text << "  left out: " << clustersOf(left.clusters) << ", "
                 << counted(trianglesOf(shadow, left.clusters), "triangle") << "; "
                 << wordsFor(left.why) << "\n";
    }
    return text.str();
}

/// The slices in which a light reaches something.
std::vector<std::size_t> slicesOf(const FramePlan& frame, std::size_t light) {
    std::vector<std::size_t> slices;
    for (std::size_t s = 0; s < frame.slices.size(); ++s)
        if (!frame.slices[s].lights[light].reach.empty()) slices.push_back(s);
    return slices;
}

} // namespace

std::string explain(const FramePlan& plan, const FrameView& view) {
    std::ostringstream text;
    for (std::size_t i = 0; i < plan.slices.front().lights.size(); ++i) {
        text << "light " << i << ", " << placeOf(plan.slices.front().lights[i].position) << ": ";
        const std::vector<std::size_t> slices = slicesOf(plan, i);
        if (slices.empty()) {
            text << "it reaches no visible geometry\n";
            continue;
        }
        const LightPlan& first = plan.slices[slices.front()].lights[i];
        if (!first.isCounted()) {
            text << "no volumes\n";
            continue;
        }
        if (first.counts.front().byPoints) {
            text << "no volumes: each visible point is tested by itself\n";
            continue;
        }
        if (first.inGroups())
            text << "casters in " << first.counts.size() << " groups, since "
                 << (first.cut ? "they are cut at the light's depth\n"
                               : "more volumes may overlap than the stencil can count\n");
        for (std::size_t g = 0; g < first.counts.size(); ++g) {
            if (first.inGroups()) text << "group " << g << ": ";
            text << offered(first.counts[g]) << "\n";
            for (const std::size_t s : slices) {
                if (view.slices.size() > 1)
                    text << "depths from " << view.slices[s].near << " to " << view.slices[s].far
                         << ": ";
                const LightPlan& light = plan.slices[s].lights[i];
                text << explain(light.counts[g])
                     << explain(fillOf(light.counts[g], view, view.slices[s], light.reach));
            }
        }
    }
    std::string lines = text.str();
    lines.pop_back(); // remove the last newline
    return lines;
}

} // namespace edgeshade

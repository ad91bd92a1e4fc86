#include "src/shadow/plan/volume_fill.hpp"

#include "src/shadow/plan/record_multiplicity.hpp"
#include "src/shadow/plan/side_fill.hpp"

#include <cstdlib>

namespace edgeshade {
namespace {

/// Sums up the draws of one batch.
class DrawFill {
  public:
    DrawFill(const BatchPlan& batch, const FillMeter& meter)
        : batch_(batch), shadow_(*batch.shadow), meter_(meter) {}

    FillCost of(const VolumeDraw& draw) const {
        FillCost cost;
        if (draw.shape == VolumeDraw::Shape::caps) {
            forEachCap(draw, [&](const CapRecord& cap) { addCap(draw, cap, cost); });
            return cost;
        }
        const glm::vec3 apex(shadow_.clusters[draw.cluster].bounds.center());
        forEachEdge(draw, [&](const glm::vec3& a, const glm::vec3& b, int multiplicity) {
            if (std::abs(multiplicity) != static_cast<int>(draw.times)) return;
            if (draw.shape == VolumeDraw::Shape::sides)
                cost += sideFill(meter_, glm::dvec3(a), glm::dvec3(b), glm::dvec4(batch_.light),
                                 glm::dvec4(draw.end));
            else
                addCorners(draw, glm::dvec3(a), glm::dvec3(b), glm::dvec3(apex), cost);
        });
        return cost;
    }

  private:
    template <class Use>
    void forEachEdge(const VolumeDraw& draw, Use use) const {
        const auto pair = [&](const PairRecord& record) {
            use(record.a, record.b, multiplicityOf(record, batch_.light, draw.counted));
        };
        const auto listed = [&](const PairList& list) {
            for (std::uint32_t i = draw.range.first; i < draw.range.end(); ++i)
                pair(shadow_.pairs[list.pairs[i]]);
        };
        switch (draw.records) {
        case VolumeDraw::Records::allPairs:
            for (std::uint32_t i = draw.range.first; i < draw.range.end(); ++i)
                pair(shadow_.pairs[i]);
            return;
        case VolumeDraw::Records::certainPairs:
            return listed(batch_.silhouettes->certain);
        case VolumeDraw::Records::uncertainPairs:
            return listed(batch_.silhouettes->uncertain);
        default:
            for (std::uint32_t i = draw.range.first; i < draw.range.end(); ++i) {
                const SingleRecord& record = shadow_.singles[i];
                use(record.a, record.b, multiplicityOf(record, batch_.light, draw.counted));
            }
        }
    }

    template <class Use>
    void forEachCap(const VolumeDraw& draw, Use use) const {
        const RecordRange& caps = shadow_.clusters[draw.cluster].caps;
        if (draw.records == VolumeDraw::Records::lightFacingCaps) {
            for (std::uint32_t i = caps.first; i < caps.end(); ++i)
                if (mayFaceTheLight(batch_.silhouettes->facings[i])) use(shadow_.caps[i]);
            return;
        }
        for (std::uint32_t i = draw.range.first; i < draw.range.end(); ++i)
            use(shadow_.caps[caps.first + i]);
    }

    void addCap(const VolumeDraw& draw, const CapRecord& cap, FillCost& cost) const {
        if (countedSideOf(cap.plane, batch_.light, draw.counted) == 0) return;
        const bool seen = glm::dot(glm::dvec4(cap.plane), glm::dvec4(batch_.eye)) >= 0.0;
        if (!draw.culled || !seen)
            addCorners(draw, glm::dvec3(cap.a), glm::dvec3(cap.b), glm::dvec3(cap.c), cost);
    }

    /// A triangle of a front cap, of a back cap, or of both.
    void addCorners(const VolumeDraw& draw, const glm::dvec3& a, const glm::dvec3& b,
                    const glm::dvec3& c, FillCost& cost) const {
        const glm::dvec4 light(batch_.light), atInfinity(0, 0, 0, 1);
        if (draw.faces != CapFaces::back) {
            // Moved to the far plane, nothing of it is before the near one.
            const FillCost front = meter_.of(
                {glm::dvec4(a, 1.0), glm::dvec4(b, 1.0), glm::dvec4(c, 1.0)}, draw.culled);
            cost +=
                draw.alphaTested && !draw.cutoutsAlone && !draw.culled ? front.times(2.0) : front;
        }
        if (draw.faces != CapFaces::front)
            cost += meter_.of({pushedTo(atInfinity, a, light), pushedTo(atInfinity, b, light),
                               pushedTo(atInfinity, c, light)});
    }

    const BatchPlan& batch_;
    const PlanePairShadow& shadow_;
    const FillMeter& meter_;
};

} // namespace

FillCost fillOf(const CountPlan& plan, const FrameView& view, const DepthSlice& slice,
                const PixelRectangle& reach) {
    const glm::dmat4 clipFromWorld = view.clipFromView(slice) * view.frustum.viewFromWorld;
    FillCost cost;
    for (const auto* draws : {&plan.draws.twice, &plan.draws.once})
        for (const VolumeDraw& draw : *draws) {
            const BatchPlan& batch = plan.batches[draw.batch];
            if (!batch.shadow) continue; // of opposite-vertex records
            const FillMeter meter(clipFromWorld * batch.worldFromBatch, view.width, view.height,
                                  reach);
            cost += DrawFill(batch, meter).of(draw);
        }
    return cost;
}

FillCost fillOf(const FramePlan& plan, const FrameView& view) {
    FillCost cost;
    for (std::size_t s = 0; s < plan.slices.size(); ++s)
        for (const LightPlan& light : plan.slices[s].lights)
            for (const CountPlan& count : light.counts)
                cost += fillOf(count, view, view.slices[s], light.reach);
    return cost;
}

} // namespace edgeshade

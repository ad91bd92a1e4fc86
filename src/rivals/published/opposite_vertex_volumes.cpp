#include "src/rivals/published/opposite_vertex_volumes.hpp"

#include "src/render/drawing/cap_alpha_test.hpp"
#include "src/rivals/published/corner_records.hpp"

namespace edgeshade {
namespace {

CapsVariant variantOf(const VolumeDraw& draw) {
    return {draw.nearDiscard, draw.alphaTested.has_value()};
}

} // namespace

OppositeVertexVolumes::OppositeVertexVolumes(MultiplicityMethod method, SidesLayout layout,
                                             std::optional<gl::Instancing> instancing,
                                             std::optional<VolumeTints> tints)
    : tints_(tints) {
    for (const bool contact : {false, true}) {
        std::vector<std::string> defines = tintDefines(tints);
        if (contact) defines.push_back("CONTACT");
        passes_.emplace_back(method, layout, instancing, std::move(defines));
    }
}

void OppositeVertexVolumes::plan(const GpuScene& scene, const CasterGroupInSlice& casters,
                                 CountPlan& plan) {
    planCornerRecords(scene, casters, layout(), plan,
                      [&](const ShadowBuffers& records, std::size_t batch, std::size_t index,
                          std::vector<VolumeDraw>& draws) {
                          const bool nearDiscard = casters.view.mayMeetNear(batch, casters.slice);
                          appendOppositeVertexDraws(records.records(), index, nearDiscard,
                                                    scene.materials, draws);
                      });
}

void OppositeVertexVolumes::prepare(const CountPlan& plan, GpuScene& scene,
                                    const CasterGroupInSlice& casters) {
    for (const VolumeDraw& draw : plan.draws.once) {
        const BatchPlan& of = plan.batches[draw.batch];
        RecordPasses& passes = passes_[isInContact(of)];
        if (draw.shape == VolumeDraw::Shape::caps) {
            passes.prepareCaps(variantOf(draw));
            continue;
        }
        const BatchVolumes& volumes =
            scene.volumesOf(of.batch, casters.source(), layout(), casters.group);
        passes.prepareSides(cornerRecordsOf(volumes, layout()).maxMultiplicity);
    }
}

void OppositeVertexVolumes::draw(const VolumeDraw& draw, const DrawnBatch& batch) const {
    const ShadowBuffers& shadow = cornerRecordsOf(batch.volumes, layout());
    const RecordPasses& passes = passes_[isInContact(batch.plan)];
    if (draw.shape == VolumeDraw::Shape::sides) {
        setVolume(passes.useSides(shadow.maxMultiplicity), draw, batch, tints_);
        passes.drawSides(shadow);
        return;
    }
    const gl::Program& program = passes.useCaps(variantOf(draw));
    setVolume(program, draw, batch, tints_);
    if (!draw.alphaTested) {
        passes.drawCaps(shadow, draw.range, false);
        return;
    }
    setCapAlphaTest(program, *batch.scene, batch.plan.batch, *draw.alphaTested);
    for (const float atInfinity : {1.0f, 0.0f}) {
        program.set("u_frontCapAtInfinity", atInfinity);
        passes.drawCaps(shadow, draw.range, true);
    }
}

} // namespace edgeshade

#include "src/rivals/published/opposite_vertex_volumes.hpp"

#include "src/render/drawing/cap_alpha_test.hpp"
#include "src/rivals/published/corner_records.hpp"

namespace edgeshade {
namespace {

std::vector<std::string> definesOf(const std::optional<VolumeTints>& tints, bool contact) {
    std::vector<std::string> defines;
    if (tints) defines = {"UNIFORM_TINT", "TINT u_tint"};
    if (contact) defines.push_back("CONTACT");
    return defines;
}

const ShadowBuffers& buffersOf(const BatchVolumes& volumes) {
    return static_cast<const ShadowBuffers&>(*volumes.recordsOf(VolumeLayout::oppositeVertices));
}

CapsVariant variantOf(const VolumeDraw& draw) {
    return {draw.nearDiscard, draw.alphaTested.has_value()};
}

} // namespace

OppositeVertexVolumes::OppositeVertexVolumes(MultiplicityMethod method, SidesLayout layout,
                                             std::optional<gl::Instancing> instancing,
                                             std::optional<VolumeTints> tints)
    : tints_(tints) {
    for (const bool contact : {false, true}) {
        const std::vector<std::string> defines = definesOf(tints, contact);
        passes_.push_back(
            {{method, layout, instancing, defines}, {method, layout, instancing, defines}});
    }
}

void OppositeVertexVolumes::plan(const GpuScene& scene, const CasterGroupInSlice& casters,
                                 CountPlan& plan) {
    plan.clear();
    for (std::size_t i = 0; i < scene.batches.size(); ++i) {
        const GpuBatch& batch = scene.batches[i];
        if (!casters.counts(batch)) continue;
        plan.batches.push_back(cornerRecordPlan(batch, i, casters.source().light));
        const BatchVolumes& volumes = scene.volumesOf(i, casters.source(), layout(), casters.group);
        appendOppositeVertexDraws(buffersOf(volumes).records(), plan.batches.size() - 1,
                                  casters.view.mayMeetNear(i, casters.slice), scene.materials,
                                  plan.draws.once);
    }
}

void OppositeVertexVolumes::prepare(const CountPlan& plan, GpuScene& scene,
                                    const CasterGroupInSlice& casters) {
    for (const VolumeDraw& draw : plan.draws.once) {
        const std::size_t batch = plan.batches[draw.batch].batch;
        if (draw.shape == VolumeDraw::Shape::caps)
            passes_[isInContact(plan.batches[draw.batch])].caps.prepare(variantOf(draw));
        else
            passes_[isInContact(plan.batches[draw.batch])].sides.prepare(
                buffersOf(scene.volumesOf(batch, casters.source(), layout(), casters.group))
                    .maxMultiplicity);
    }
}

void OppositeVertexVolumes::draw(const VolumeDraw& draw, const DrawnBatch& batch) const {
    const ShadowBuffers& shadow = buffersOf(batch.volumes);
    const auto& [sides, caps] = passes_[isInContact(batch.plan)];
    if (draw.shape == VolumeDraw::Shape::sides) {
        setCommon(sides.use(shadow.maxMultiplicity), draw, batch);
        sides.draw(shadow);
        return;
    }
    const gl::Program& program = caps.use(variantOf(draw));
    setCommon(program, draw, batch);
    if (!draw.alphaTested) {
        caps.draw(shadow, draw.range, false);
        return;
    }
    setCapAlphaTest(program, *batch.scene, batch.plan.batch, *draw.alphaTested);
    for (const float atInfinity : {1.0f, 0.0f}) {
        program.set("u_frontCapAtInfinity", atInfinity);
        caps.draw(shadow, draw.range, true);
    }
}

void OppositeVertexVolumes::setCommon(const gl::Program& program, const VolumeDraw& draw,
                                      const DrawnBatch& batch) const {
    program.set("u_light", batch.plan.light);
    program.set("u_reach", batch.plan.reach);
    program.set("u_clipFromObject", batch.clipFromObject);
    if (tints_) program.set("u_tint", tints_->of(draw));
}

} // namespace edgeshade

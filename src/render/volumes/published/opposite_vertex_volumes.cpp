#include "src/render/volumes/published/opposite_vertex_volumes.hpp"

#include "src/render/drawing/cap_alpha_test.hpp"

namespace edgeshade {
namespace {

std::vector<std::string> definesOf(const std::optional<VolumeTints>& tints) {
    if (!tints) return {};
    return {"UNIFORM_TINT", "TINT u_tint"};
}

CapsVariant variantOf(const VolumeDraw& draw) {
    return {draw.nearDiscard, draw.alphaTested.has_value()};
}

} // namespace

OppositeVertexVolumes::OppositeVertexVolumes(MultiplicityMethod method, SidesLayout layout,
                                             std::optional<gl::Instancing> instancing,
                                             std::optional<VolumeTints> tints)
    : tints_(tints), sides_(method, layout, instancing, definesOf(tints)),
      caps_(method, layout, instancing, definesOf(tints)) {}

CountPlan OppositeVertexVolumes::plan(const GpuScene& scene, const CasterGroupInSlice& casters) {
    CountPlan plan;
    for (std::size_t i = 0; i < scene.batches.size(); ++i) {
        const GpuBatch& batch = scene.batches[i];
        if (!casters.counts(batch)) continue;
        plan.batches.push_back(
            {.batch = i, .light = lightInObject(casters.source().light, batch.worldFromBatch)});
        const BatchVolumes& volumes = scene.volumesOf(i, casters.source(), layout(), casters.group);
        appendOppositeVertexDraws(volumes.oppositeVertices->records(), plan.batches.size() - 1,
                                  casters.view.nearestDepths[i] <= casters.slice.near,
                                  scene.materials, plan.draws.once);
    }
    return plan;
}

void OppositeVertexVolumes::prepare(const CountPlan& plan, GpuScene& scene,
                                    const CasterGroupInSlice& casters) {
    for (const VolumeDraw& draw : plan.draws.once) {
        const std::size_t batch = plan.batches[draw.batch].batch;
        if (draw.shape == VolumeDraw::Shape::caps)
            caps_.prepare(variantOf(draw));
        else
            sides_.prepare(scene.volumesOf(batch, casters.source(), layout(), casters.group)
                               .oppositeVertices->maxMultiplicity);
    }
}

void OppositeVertexVolumes::draw(const VolumeDraw& draw, const DrawnBatch& batch) const {
    const ShadowBuffers& shadow = *batch.volumes.oppositeVertices;
    if (draw.shape == VolumeDraw::Shape::sides) {
        setCommon(sides_.use(shadow.maxMultiplicity), draw, batch);
        sides_.draw(shadow);
        return;
    }
    const gl::Program& program = caps_.use(variantOf(draw));
    setCommon(program, draw, batch);
    if (!draw.alphaTested) {
        caps_.draw(shadow, draw.range, false);
        return;
    }
    setCapAlphaTest(program, *batch.scene, batch.plan.batch, *draw.alphaTested);
    for (const float atInfinity : {1.0f, 0.0f}) {
        program.set("u_frontCapAtInfinity", atInfinity);
        caps_.draw(shadow, draw.range, true);
    }
}

void OppositeVertexVolumes::setCommon(const gl::Program& program, const VolumeDraw& draw,
                                      const DrawnBatch& batch) const {
    program.set("u_light", batch.plan.light);
    program.set("u_clipFromObject", batch.clipFromObject);
    if (tints_) program.set("u_tint", tints_->of(draw));
}

} // namespace edgeshade

#include "src/render/volumes/plane_pair_volumes.hpp"

#include "shaders_es2.hpp"
#include "src/render/drawing/attributes.hpp"
#include "src/render/drawing/cap_alpha_test.hpp"

#include <algorithm>
#include <array>

namespace edgeshade {
namespace {

/// Number of quads that 16-bit indices reach, four vertices each. Index 65535 is excluded: WebGL 2
/// uses it for primitive restart.
constexpr std::uint32_t quadsPerDraw = 65535 / verticesPerQuad;

/// Component counts of the attributes after the corner.
const std::vector<int> pairComponents = {3, 3, 4, 4};
const std::vector<int> singleComponents = {3, 3, 4};
const std::vector<int> capComponents = {3, 3, 3, 4};

gl::Buffer indexBuffer(std::span<const std::uint16_t> pattern, std::uint32_t quads) {
    std::vector<std::uint16_t> indices;
    indices.reserve(quads * pattern.size());
    for (std::uint32_t quad = 0; quad < quads; ++quad)
        for (const std::uint16_t corner : pattern)
            indices.push_back(static_cast<std::uint16_t>(verticesPerQuad * quad + corner));
    return gl::Buffer(gl::Buffer::Kind::indices,
                      std::as_bytes(std::span<const std::uint16_t>(indices)));
}

std::size_t floatsOf(const std::vector<int>& components) {
    std::size_t floats = 0;
    for (const int count : components)
        floats += static_cast<std::size_t>(count);
    return floats;
}

/// Binds the attributes of records from byte `offset` on. Copied records start with their corner;
/// otherwise the corner comes from its own buffer, from vertex `firstCorner` on.
void bindRecords(AttributeBinding& binding, const gl::Buffer& buffer,
                 const std::vector<int>& components, std::size_t offset, bool copied,
                 const gl::Buffer& corners, std::size_t firstCorner) {
    const std::size_t stride = sizeof(float) * (floatsOf(components) + (copied ? 1 : 0));
    if (copied) {
        binding.add(buffer, 1, GL_FLOAT, false, stride, offset, false);
        offset += sizeof(float);
    } else {
        binding.add(corners, 1, GL_FLOAT, false, sizeof(float), firstCorner * sizeof(float), false);
    }
    for (const int count : components) {
        binding.add(buffer, count, GL_FLOAT, false, stride, offset, !copied);
        offset += sizeof(float) * static_cast<std::size_t>(count);
    }
}

std::vector<std::string> joined(std::vector<std::string> words,
                                const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

glm::vec2 rangeOf(Counted counted) {
    switch (counted) {
    case Counted::lightFacing:
        return {0.0f, 1.0f};
    case Counted::facingAway:
        return {-1.0f, 0.0f};
    case Counted::all:
        break;
    }
    return {-1.0f, 1.0f};
}

/// The variant of the program that draws sides or fans.
PlanePairSidesVariant variantOf(const VolumeDraw& draw) {
    const bool fans = draw.shape == VolumeDraw::Shape::fans;
    return {.pair = draw.isPair(), .directional = !fans && draw.isTriangle(), .cap = fans};
}

PlanePairCapsVariant capsVariantOf(const VolumeDraw& draw) {
    return {.nearDiscard = draw.nearDiscard,
            .alphaTest = draw.alphaTested.has_value(),
            .culled = draw.culled};
}

} // namespace

gl::Program makePlanePairSidesProgram(const PlanePairSidesVariant& variant,
                                      const std::vector<std::string>& extraDefines,
                                      const std::vector<std::string>& extraAttributes) {
    std::vector<std::string> defines = extraDefines;
    if (variant.pair) defines.push_back("PAIR");
    if (variant.directional) defines.push_back("DIRECTIONAL");
    if (variant.cap) defines.push_back("CAP");
    return {shaders::plane_pair_sides_vert, shaders::sides_frag, defines,
            joined(variant.pair
                       ? std::vector<std::string>{"a_corner", "a_edgeA", "a_edgeB", "a_plane0",
                                                  "a_plane1"}
                       : std::vector<std::string>{"a_corner", "a_edgeA", "a_edgeB", "a_plane0"},
                   extraAttributes)};
}

gl::Program makePlanePairCapsProgram(const PlanePairCapsVariant& variant,
                                     const std::vector<std::string>& extraDefines,
                                     const std::vector<std::string>& extraAttributes) {
    std::vector<std::string> defines = extraDefines;
    std::vector<std::string> attributes = {"a_corner", "a_capA", "a_capB", "a_capC", "a_plane"};
    if (variant.nearDiscard) defines.push_back("NEAR_DISCARD");
    if (variant.culled) defines.push_back("CULLED");
    if (variant.alphaTest) {
        defines.push_back("ALPHA_TEST");
        attributes.insert(attributes.end(), {"a_alphaCornerA", "a_alphaCornerB", "a_alphaCornerC"});
    }
    return {shaders::plane_pair_caps_vert, shaders::caps_frag, defines,
            joined(std::move(attributes), extraAttributes)};
}

PlanePairVolumes::PlanePairVolumes(const RenderSettings& settings,
                                   const gl::Capabilities& capabilities,
                                   std::optional<VolumeTints> tints,
                                   std::vector<std::string> defines)
    : instancing_(capabilities.instancing), tints_(tints), defines_(std::move(defines)),
      gathered_(settings.layout) {
    planning_.mantissaBits = capabilities.vertexHighpMantissaBits;
    defines_ = joined(std::move(defines_), tintDefines(tints_));
    if (settings.silhouette == SilhouetteChoice::proposed)
        silhouettes_.emplace(planning_.mantissaBits);
    const std::uint32_t quads = settings.layout == SidesLayout::notInstanced ? quadsPerDraw : 1;
    // The published order: rasterisers round a triangle's depths by which corner comes first.
    quadIndices_ = indexBuffer(std::array<std::uint16_t, 6>{2, 1, 0, 1, 2, 3}, quads);
    triangleIndices_ = indexBuffer(std::array<std::uint16_t, 3>{2, 1, 0}, quads);
    if (settings.layout == SidesLayout::notInstanced) return;
    quadCorners_ = gl::vertexBuffer<float>(std::array<float, 4>{0, 1, 2, 3});
    capCorners_ = gl::vertexBuffer<float>(std::array<float, 6>{0, 1, 2, 3, 4, 5});
}

void PlanePairVolumes::beginFrame(const GpuScene& scene, std::size_t mostListed) {
    if (silhouettes_) silhouettes_->beginFrame(scene.identity, mostListed);
    gathered_.dropExpired();
}

void PlanePairVolumes::plan(const GpuScene& scene, const CasterGroupInSlice& casters,
                            CountPlan& plan) {
    placed_.clear();
    for (std::size_t i = 0; i < scene.batches.size(); ++i) {
        if (!casters.counts(scene.batches[i])) continue;
        const BatchVolumes& volumes = scene.volumesOf(i, casters.source(), layout(), casters.group);
        placed_.push_back({i, volumes.planePairs->shadow(), scene.batches[i].worldFromBatch});
    }
    PlanSettings planning = planning_;
    planning.silhouettes = silhouettes_ ? &*silhouettes_ : nullptr;
    planning.solids = &solids_;
    planning.memory = &memory_;
    planCount(placed_, scene.materials, casters.view, casters.slice, casters.light, planning, plan);
    placed_.clear(); // it holds records, which others may replace
}

void PlanePairVolumes::prepare(const CountPlan& plan, GpuScene& scene,
                               const CasterGroupInSlice& casters) {
    for (const auto* draws : {&plan.draws.twice, &plan.draws.once})
        for (const VolumeDraw& draw : *draws) {
            const BatchPlan& of = plan.batches[draw.batch];
            upload(
                draw, of,
                *scene.volumesOf(of.batch, casters.source(), layout(), casters.group).planePairs);
            makeProgram(draw);
        }
}

void PlanePairVolumes::upload(const VolumeDraw& draw, const BatchPlan& plan,
                              PlanePairBuffers& buffers) {
    using Records = VolumeDraw::Records;
    switch (draw.records) {
    case Records::allPairs:
        return buffers.uploadAllPairs();
    case Records::caps:
        return buffers.uploadCapsOf(draw.cluster);
    case Records::certainPairs:
    case Records::uncertainPairs:
        return gathered_.upload(*plan.shadow, *plan.silhouettes);
    case Records::lightFacingCaps:
        gathered_.upload(*plan.shadow, *plan.silhouettes);
        return gathered_.uploadCapsOf(*plan.shadow, *plan.silhouettes, draw.cluster);
    default:
        return; // singles are there
    }
}

void PlanePairVolumes::makeProgram(const VolumeDraw& draw) {
    if (draw.shape == VolumeDraw::Shape::caps)
        makeProgram(capsVariantOf(draw));
    else
        makeProgram(variantOf(draw));
}

void PlanePairVolumes::makeProgram(const PlanePairSidesVariant& variant) {
    sides_.get(variant, [&] { return makePlanePairSidesProgram(variant, defines_); });
}

void PlanePairVolumes::makeProgram(const PlanePairCapsVariant& variant) {
    caps_.get(variant, [&] { return makePlanePairCapsProgram(variant, defines_); });
}

void PlanePairVolumes::beginPrograms(bool directional, bool open) {
    for (const bool pair : {true, false}) {
        if (!pair && !open) continue;
        makeProgram(PlanePairSidesVariant{.pair = pair});
        if (directional) makeProgram(PlanePairSidesVariant{.pair = pair, .directional = true});
    }
    if (open) makeProgram(PlanePairCapsVariant{.culled = true});
}

void PlanePairVolumes::forEachProgram(const gl::ProgramVisitor& visit) const {
    sides_.forEachProgram(visit);
    caps_.forEachProgram(visit);
}

void PlanePairVolumes::draw(const VolumeDraw& draw, const DrawnBatch& batch) const {
    switch (draw.shape) {
    case VolumeDraw::Shape::sides:
        return drawSides(draw, batch);
    case VolumeDraw::Shape::fans:
        return drawFans(draw, batch);
    default:
        return drawCaps(draw, batch);
    }
}

const gl::Buffer& PlanePairVolumes::bufferOf(const VolumeDraw& draw,
                                             const DrawnBatch& batch) const {
    switch (draw.records) {
    case VolumeDraw::Records::certainPairs:
        return gathered_.of(*batch.plan.silhouettes).certainPairs;
    case VolumeDraw::Records::uncertainPairs:
        return gathered_.of(*batch.plan.silhouettes).uncertainPairs;
    case VolumeDraw::Records::allPairs:
        return batch.volumes.planePairs->pairs();
    default:
        return batch.volumes.planePairs->singles();
    }
}

const gl::Program& PlanePairVolumes::sidesProgram(const VolumeDraw& draw,
                                                  const DrawnBatch& batch) const {
    const gl::Program& program = sides_.use(variantOf(draw));
    setVolume(program, draw, batch, tints_);
    program.set("u_end", draw.end);
    program.set("u_counted", rangeOf(draw.counted));
    program.set("u_times", static_cast<float>(draw.times));
    return program;
}

void PlanePairVolumes::drawSides(const VolumeDraw& draw, const DrawnBatch& batch) const {
    sidesProgram(draw, batch);
    drawRecords(draw, batch, draw.isTriangle());
}

void PlanePairVolumes::drawFans(const VolumeDraw& draw, const DrawnBatch& batch) const {
    const gl::Program& program = sidesProgram(draw, batch);
    program.set("u_apex", glm::vec3(batch.plan.shadow->clusters[draw.cluster].bounds.center()));
    for (const CapFaces face : {CapFaces::front, CapFaces::back}) {
        if (draw.faces != face && draw.faces != CapFaces::both) continue;
        program.set("u_back", face == CapFaces::back ? 1.0f : 0.0f);
        drawRecords(draw, batch, true);
    }
}

void PlanePairVolumes::drawRecords(const VolumeDraw& draw, const DrawnBatch& batch,
                                   bool triangles) const {
    const gl::Buffer& buffer = bufferOf(draw, batch);
    const std::vector<int>& components = draw.isPair() ? pairComponents : singleComponents;
    const RecordRange& range = draw.range;
    const int indices = triangles ? 3 : 6;
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, (triangles ? triangleIndices_ : quadIndices_).name());
    if (!batch.volumes.planePairs->copied()) {
        AttributeBinding binding(&*instancing_);
        bindRecords(binding, buffer, components, range.first * sizeof(float) * floatsOf(components),
                    false, quadCorners_, 0);
        instancing_->drawIndexedTriangles(indices, static_cast<int>(range.count));
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
        return;
    }
    const std::size_t recordBytes = verticesPerQuad * sizeof(float) * (floatsOf(components) + 1);
    for (std::uint32_t done = 0; done < range.count; done += quadsPerDraw) {
        const std::uint32_t count = std::min(quadsPerDraw, range.count - done);
        AttributeBinding binding(nullptr);
        bindRecords(binding, buffer, components, (range.first + done) * recordBytes, true,
                    quadCorners_, 0);
        glDrawElements(GL_TRIANGLES, static_cast<int>(count) * indices, GL_UNSIGNED_SHORT, nullptr);
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

void PlanePairVolumes::drawCaps(const VolumeDraw& draw, const DrawnBatch& batch) const {
    const PlanePairBuffers& buffers = *batch.volumes.planePairs;
    const CapBuffers& caps =
        draw.records == VolumeDraw::Records::lightFacingCaps
            ? gathered_.of(*batch.plan.silhouettes).caps.find(draw.cluster)->second
            : buffers.capsOf(draw.cluster);
    const gl::Program& program = caps_.use(capsVariantOf(draw));
    setVolume(program, draw, batch, tints_);
    program.set("u_counted", rangeOf(draw.counted));
    if (draw.culled) program.set("u_eye", batch.plan.eye);
    if (!draw.alphaTested) {
        drawCapRecords(caps, buffers.copied(), draw.range, draw.faces, false);
        return;
    }
    setCapAlphaTest(program, *batch.scene, batch.plan.batch, *draw.alphaTested);
    if (!draw.cutoutsAlone) {
        program.set("u_frontCapAtInfinity", 1.0f);
        drawCapRecords(caps, buffers.copied(), draw.range, draw.faces, true);
    }
    if (draw.culled) return;
    program.set("u_frontCapAtInfinity", 0.0f);
    drawCapRecords(caps, buffers.copied(), draw.range, CapFaces::front, true);
}

void PlanePairVolumes::drawCapRecords(const CapBuffers& buffers, bool copied,
                                      const RecordRange& caps, CapFaces faces,
                                      bool alphaTested) const {
    const std::size_t floats = floatsOf(capComponents);
    const auto count = static_cast<int>(caps.count);
    if (!copied) {
        AttributeBinding binding(&*instancing_);
        bindRecords(binding, buffers.records, capComponents, caps.first * sizeof(float) * floats,
                    false, capCorners_, faces == CapFaces::back ? verticesPerCap : 0);
        if (alphaTested)
            binding.addRecords(buffers.alphaCorners, 3, caps.first * 3 * sizeof(glm::vec4), true);
        instancing_->drawTriangles(faces == CapFaces::both ? 2 * verticesPerCap : verticesPerCap,
                                   count);
        return;
    }
    for (const CapFaces face : {CapFaces::front, CapFaces::back}) {
        if (faces != face && faces != CapFaces::both) continue;
        const std::size_t first =
            verticesPerCap * (caps.first + (face == CapFaces::back ? buffers.count : 0));
        AttributeBinding binding(nullptr);
        bindRecords(binding, buffers.records, capComponents, first * sizeof(float) * (floats + 1),
                    true, capCorners_, 0);
        if (alphaTested)
            binding.addRecords(buffers.alphaCorners, 3, first * 3 * sizeof(glm::vec4), false);
        glDrawArrays(GL_TRIANGLES, 0, count * verticesPerCap);
    }
}

} // namespace edgeshade

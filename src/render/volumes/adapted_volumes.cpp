#include "src/render/volumes/adapted_volumes.hpp"

#include "shaders_es2.hpp"
#include "src/render/drawing/attributes.hpp"
#include "src/render/drawing/cap_holes.hpp"

#include <algorithm>
#include <array>

namespace edgeshade {
namespace {

/// Quads that 16-bit indices reach, four vertices each.
constexpr std::uint32_t quadsPerDraw = 65536 / verticesPerQuad;

/// Components of the attributes after the corner.
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

/// The attributes of records from byte `offset` on. Copied records have the corner in front; else
/// it comes from a buffer of its own, from vertex `firstCorner` on.
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
    return counted == Counted::all ? glm::vec2(-1.0f, 1.0f) : glm::vec2(0.0f, 1.0f);
}

const gl::Buffer& bufferOf(SideRecords::Kind kind, const AdaptedBuffers& buffers,
                           const ProposedRecords* proposed) {
    using Kind = SideRecords::Kind;
    switch (kind) {
    case Kind::singles:
        return buffers.singles();
    case Kind::certainPairs:
        return proposed->certainPairs;
    case Kind::uncertainPairs:
        return proposed->uncertainPairs;
    case Kind::allPairs:
        break;
    }
    return buffers.pairs();
}

} // namespace

gl::Program makeAdaptedSidesProgram(const AdaptedSidesVariant& variant,
                                    const std::vector<std::string>& extraDefines,
                                    const std::vector<std::string>& extraAttributes) {
    std::vector<std::string> defines = extraDefines;
    if (variant.pair) defines.push_back("PAIR");
    if (variant.sun) defines.push_back("SUN");
    if (variant.cap) defines.push_back("CAP");
    return {shaders::adapted_sides_vert, shaders::sides_frag, defines,
            joined(variant.pair
                       ? std::vector<std::string>{"a_corner", "a_edgeA", "a_edgeB", "a_plane0",
                                                  "a_plane1"}
                       : std::vector<std::string>{"a_corner", "a_edgeA", "a_edgeB", "a_plane0"},
                   extraAttributes)};
}

gl::Program makeAdaptedCapsProgram(bool nearDiscard, bool alphaTest,
                                   const std::vector<std::string>& extraDefines,
                                   const std::vector<std::string>& extraAttributes) {
    std::vector<std::string> defines = extraDefines;
    std::vector<std::string> attributes = {"a_corner", "a_capA", "a_capB", "a_capC", "a_plane"};
    if (nearDiscard) defines.push_back("NEAR_DISCARD");
    if (alphaTest) {
        defines.push_back("ALPHA_TEST");
        attributes.insert(attributes.end(), {"a_holesA", "a_holesB", "a_holesC"});
    }
    return {shaders::adapted_caps_vert, shaders::caps_frag, defines,
            joined(std::move(attributes), extraAttributes)};
}

AdaptedVolumes::AdaptedVolumes(SidesLayout layout, std::optional<gl::Instancing> instancing,
                               std::vector<std::string> defines, std::optional<VolumeTints> tints)
    : instancing_(instancing), tints_(tints), sidesDefines_(std::move(defines)) {
    if (tints_)
        for (auto* shaders : {&sidesDefines_, &capsDefines_})
            shaders->insert(shaders->end(), {"UNIFORM_TINT", "TINT u_tint"});
    const std::uint32_t quads = layout == SidesLayout::notInstanced ? quadsPerDraw : 1;
    // The published order: rasterisers round a triangle's depths by which corner comes first.
    quadIndices_ = indexBuffer(std::array<std::uint16_t, 6>{2, 1, 0, 1, 2, 3}, quads);
    triangleIndices_ = indexBuffer(std::array<std::uint16_t, 3>{2, 1, 0}, quads);
    if (layout == SidesLayout::notInstanced) return;
    quadCorners_ = gl::vertexBuffer<float>(std::array<float, 4>{0, 1, 2, 3});
    capCorners_ = gl::vertexBuffer<float>(std::array<float, 6>{0, 1, 2, 3, 4, 5});
}

gl::Program& AdaptedVolumes::sidesProgram(const AdaptedSidesVariant& variant,
                                          const VolumeDraw& draw, Times times, const glm::vec4& end,
                                          const glm::vec4& light, const glm::mat4& clipFromObject) {
    auto found = sides_.find(variant);
    if (found == sides_.end())
        found = sides_.emplace(variant, makeAdaptedSidesProgram(variant, sidesDefines_)).first;
    gl::Program& program = found->second;
    program.use();
    program.set("u_light", light);
    program.set("u_end", end);
    program.set("u_counted", rangeOf(draw.counted));
    program.set("u_times", static_cast<float>(times));
    program.set("u_clipFromObject", clipFromObject);
    return program;
}

void AdaptedVolumes::drawSides(const AdaptedBuffers& buffers, const ProposedRecords* proposed,
                               const VolumeDraw& draw, Times times, const glm::vec4& end,
                               const glm::vec4& light, const glm::mat4& clipFromObject) {
    const bool sun = light.w == 0.0f && draw.end < 0;
    for (const SideRecords& records :
         sideRecords(*buffers.shadow(), listOf(proposed), draw, times)) {
        gl::Program& program = sidesProgram({.pair = records.isPair(), .sun = sun}, draw, times,
                                            end, light, clipFromObject);
        if (tints_)
            program.set("u_tint", times == Times::twice ? tints_->twice
                                  : draw.zFail()        ? tints_->behind
                                                        : tints_->before);
        drawRecords(buffers, proposed, records, sun);
    }
}

void AdaptedVolumes::drawFannedCaps(const AdaptedBuffers& buffers, const ProposedRecords* proposed,
                                    const VolumeDraw& draw, Times times, const glm::vec4& light,
                                    const glm::mat4& clipFromObject) {
    if (!draw.fannedCaps) return;
    const AdaptedShadow& shadow = *buffers.shadow();
    const glm::vec4 infinity(0, 0, 0, 1);
    for (std::uint32_t c = draw.clusters.first; c < draw.clusters.end(); ++c) {
        if (!takesFannedCaps(shadow, listOf(proposed), draw, c)) continue;
        for (const SideRecords& records :
             sideRecords(shadow, listOf(proposed), drawOf(draw, c), times)) {
            gl::Program& program = sidesProgram({.pair = records.isPair(), .cap = true}, draw,
                                                times, infinity, light, clipFromObject);
            program.set("u_apex", glm::vec3(shadow.clusters[c].bounds.center()));
            for (const bool back : {false, true}) {
                if (!(back ? draw.backCaps : draw.frontCaps)) continue;
                program.set("u_back", back ? 1.0f : 0.0f);
                drawRecords(buffers, proposed, records, true);
            }
        }
    }
}

void AdaptedVolumes::drawRecords(const AdaptedBuffers& buffers, const ProposedRecords* proposed,
                                 const SideRecords& records, bool triangles) {
    const gl::Buffer& buffer = bufferOf(records.kind, buffers, proposed);
    const std::vector<int>& components = records.isPair() ? pairComponents : singleComponents;
    const RecordRange& range = records.range;
    const int indices = triangles ? 3 : 6;
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, (triangles ? triangleIndices_ : quadIndices_).name());
    if (!buffers.copied()) {
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

gl::Program& AdaptedVolumes::capsProgram(bool nearDiscard, bool alphaTest) {
    const std::pair key(nearDiscard, alphaTest);
    auto found = caps_.find(key);
    if (found == caps_.end())
        found =
            caps_.emplace(key, makeAdaptedCapsProgram(nearDiscard, alphaTest, capsDefines_)).first;
    return found->second;
}

void AdaptedVolumes::drawCaps(const AdaptedBuffers& buffers, const ProposedRecords* proposed,
                              const VolumeDraw& draw, const std::vector<Material>& materials,
                              const Textures& textures, const glm::vec4& light,
                              const glm::mat4& clipFromObject) {
    const AdaptedShadow& shadow = *buffers.shadow();
    if (!draw.zFail() || !(draw.frontCaps || draw.backCaps)) return;
    const CapKind kind = !draw.backCaps   ? CapKind::front
                         : draw.frontCaps ? CapKind::both
                                          : CapKind::back;
    const auto use = [&](bool alphaTest) -> gl::Program& {
        gl::Program& program = capsProgram(draw.nearDiscard, alphaTest);
        program.use();
        program.set("u_light", light);
        program.set("u_counted", rangeOf(draw.counted));
        if (tints_) program.set("u_tint", tints_->caps);
        program.set("u_clipFromObject", clipFromObject);
        return program;
    };
    for (std::uint32_t c = draw.clusters.first; c < draw.clusters.end(); ++c) {
        const ShadowCluster& cluster = shadow.clusters[c];
        if (cluster.caps.count == 0 || takesFannedCaps(shadow, listOf(proposed), draw, c)) continue;
        if (proposed && takesLightFacingCaps(cluster, draw.counted)) {
            const CapBuffers& caps = lightFacingCaps(*proposed, buffers, c);
            if (caps.count == 0) continue;
            use(false);
            drawGroup(caps, buffers.copied(), {0, caps.count}, kind, false);
            continue;
        }
        const CapBuffers& caps = buffers.capsOf(c);
        for (std::uint32_t g = cluster.groups.first; g < cluster.groups.end(); ++g) {
            const CasterGroup& group = shadow.groups[g];
            const Material& material = materials[group.material];
            const bool alphaTest =
                cluster.holes && material.alphaMode != AlphaMode::opaque && draw.frontCaps;
            gl::Program& program = use(alphaTest);
            const RecordRange range{group.firstCap - cluster.caps.first, group.capCount};
            if (!alphaTest) {
                drawGroup(caps, buffers.copied(), range, kind, false);
                continue;
            }
            setCapHoles(program, material, textures);
            program.set("u_frontCapAtInfinity", 1.0f);
            drawGroup(caps, buffers.copied(), range, kind, true);
            program.set("u_frontCapAtInfinity", 0.0f);
            drawGroup(caps, buffers.copied(), range, CapKind::front, true);
        }
    }
}

void AdaptedVolumes::drawGroup(const CapBuffers& buffers, bool copied, const RecordRange& caps,
                               CapKind kind, bool holes) {
    const std::size_t floats = floatsOf(capComponents);
    if (!copied) {
        AttributeBinding binding(&*instancing_);
        bindRecords(binding, buffers.records, capComponents, caps.first * sizeof(float) * floats,
                    false, capCorners_, kind == CapKind::back ? verticesPerCap : 0);
        if (holes) binding.addRecords(buffers.holes, 3, caps.first * 3 * sizeof(glm::vec4), true);
        instancing_->drawTriangles(kind == CapKind::both ? 2 * verticesPerCap : verticesPerCap,
                                   static_cast<int>(caps.count));
        return;
    }
    for (const bool back : {false, true}) {
        if (kind == (back ? CapKind::front : CapKind::back)) continue;
        const std::size_t first = verticesPerCap * (caps.first + (back ? buffers.count : 0));
        AttributeBinding binding(nullptr);
        bindRecords(binding, buffers.records, capComponents, first * sizeof(float) * (floats + 1),
                    true, capCorners_, 0);
        if (holes) binding.addRecords(buffers.holes, 3, first * 3 * sizeof(glm::vec4), false);
        glDrawArrays(GL_TRIANGLES, 0, static_cast<int>(caps.count) * verticesPerCap);
    }
}

} // namespace edgeshade

#include "src/engine/lookup_work.hpp"

#include "preprocess/base/stopwatch.hpp"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

namespace edgeshade {
namespace {

PrimitiveMapSettings settingsOf(const LookupSettings& from) {
    PrimitiveMapSettings settings;
    settings.size = from.size;
    settings.mostBytes = from.mostBytes;
    settings.othersReceive = true; // the host's own surfaces receive too
    return settings;
}

static_assert(MaskTexels::full == fullAlpha);

CutoutTexture textureFrom(const MaskAlpha& alpha) {
    CutoutTexture texture;
    texture.cutoff = alpha.cutoff;
    if (!alpha.texels) return texture;
    const MaskTexels& texels = *alpha.texels;
    texture.size = {texels.width, texels.height};
    texture.wrapS = static_cast<CutoutWrap>(texels.wrapS);
    texture.wrapT = static_cast<CutoutWrap>(texels.wrapT);
    texture.linear = texels.linear;
    texture.own = packedAlpha(texels.alpha);
    return texture;
}

} // namespace

std::uint32_t LookupWork::Data::textureFor(const LookupTask::Cutout& cutout) {
    const auto next = static_cast<std::uint32_t>(textures.size());
    const MaskAlpha& alpha = cutout.alpha;
    if (cutout.tint) {
        const auto [known, isNew] = tintOf.emplace(*cutout.tint, next);
        if (isNew) textures.emplace_back().tint = glm::make_vec3(cutout.tint->data());
        return known->second;
    }
    const auto [known, isNew] =
        textureOf.emplace(std::pair(alpha.texels.get(), alpha.cutoff), next);
    if (isNew) textures.push_back(textureFrom(alpha));
    return known->second;
}

std::shared_ptr<const CasterEdges> LookupWork::Data::edgesOf(const LookupTask::Cutout& cutout) {
    const MaskAlpha& alpha = cutout.alpha;
    const std::uint32_t texture = textureFor(cutout);
    std::array<float, 10> numbers{alpha.opacity};
    std::copy_n(alpha.texcoordTransform.begin(), 9, numbers.begin() + 1);
    auto& of = cutoutEdges[{cutout.mesh.get(), texture, numbers}];
    if (of) return of;
    Batch batch;
    batch.geometry = cutout.mesh->geometry;
    if (cutout.tint) return of = std::make_shared<const CasterEdges>(tintedEdgesOf(batch, texture));
    CasterEdges found = cutoutEdgesOf(batch, maskMaterials());
    const glm::dmat3 transform(glm::make_mat3(alpha.texcoordTransform.data()));
    for (CutoutTriangle& triangle : found.cutouts) {
        triangle.material = texture;
        for (glm::vec3& corner : triangle.corners)
            corner = glm::vec3(glm::dvec2(transform * glm::dvec3(glm::vec2(corner), 1.0)),
                               alpha.opacity);
    }
    return of = std::make_shared<const CasterEdges>(std::move(found));
}

std::shared_ptr<const CasterEdges> LookupWork::Data::edgesOf(const LookupTask::Caster& caster) {
    if (!caster.shadow) return edgesOf(caster.cutout);
    auto& of = edges[caster.shadow.get()];
    if (!of) of = std::make_shared<const CasterEdges>(casterEdgesOf(*caster.shadow));
    return of;
}

bool LookupWork::Data::step() {
    if (!task.why.empty()) {
        built.why = task.why;
        return false;
    }
    if (placed.size() < task.casters.size()) {
        const LookupTask::Caster& caster = task.casters[placed.size()];
        placed.push_back({edgesOf(caster), caster.worldFromBatch, true});
        return true;
    }
    if (!fitting) {
        PrimitiveMapSettings settings = settingsOf(task.settings);
        settings.cutouts = textures;
        fitting.emplace(task.light, placed, settings);
    }
    if (fitting->step()) return true;
    built.why = refusalOf({fitting->map().has_value(), fitting->tooFar(), fitting->tooLong(),
                           task.settings.mostBytes});
    if (built.why.empty()) built.map = packedPrimitiveMap(*fitting->map());
    fitting.reset();
    return false;
}

bool LookupWork::advance(double milliseconds) {
    Stopwatch watch;
    double worked = 0.0;
    while (!data_->done && worked < milliseconds) {
        data_->done = !data_->step();
        worked += 1e3 * watch.lap();
    }
    data_->built.milliseconds += worked;
    return data_->done;
}

void LookupWork::finish() {
    Stopwatch watch;
    while (!data_->done) {
        data_->done = !data_->step();
        if (data_->fitting) data_->fitting->buildAllParts();
    }
    data_->built.milliseconds += 1e3 * watch.lap();
}

LookupWork workOn(LookupTask task, std::size_t casterState) {
    auto data = std::make_shared<LookupWork::Data>();
    data->task = std::move(task);
    data->casterState = casterState;
    return LookupWork(std::move(data));
}

} // namespace edgeshade

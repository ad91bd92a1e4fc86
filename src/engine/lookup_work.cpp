#include "src/engine/lookup_work.hpp"

#include "preprocess/base/stopwatch.hpp"
#include "src/shadow/lights/light_extent.hpp"

#include <glm/gtc/type_ptr.hpp>

namespace edgeshade {
namespace {

PrimitiveMapSettings settingsOf(const LookupTask& task) {
    const LookupSettings& from = task.settings;
    PrimitiveMapSettings settings;
    settings.size = from.size;
    settings.mostBytes = from.mostBytes;
    settings.othersReceive = true; // the host's own surfaces receive too
    if (!task.light.extent) return settings;
    settings.size = sizeForExtents(settings.size);
    settings.mostSplits = 0;
    settings.receivers = task.receivers;
    // A fragment goes through its list once for each sixteen points, and GLs count all turns.
    settings.longestWanted =
        std::max<std::size_t>(1, longestAsked * placesAtOnce / from.lightSamples);
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

CasterEdges edgesFor(const PreparedMesh::Data& mesh, const LookupWork::Data::Look& look) {
    Batch batch;
    batch.geometry = mesh.geometry;
    CasterEdges found =
        look.tint ? tintedEdgesOf(batch, look.texture) : cutoutEdgesOf(batch, maskMaterials());
    const glm::dmat3 transform(glm::make_mat3(look.alpha.texcoordTransform.data()));
    for (CutoutTriangle& triangle : found.cutouts) {
        triangle.material = look.texture;
        for (glm::vec3& corner : triangle.corners)
            corner = glm::vec3(glm::dvec2(transform * glm::dvec3(glm::vec2(corner), 1.0)),
                               look.alpha.opacity);
    }
    return found;
}

} // namespace

std::size_t LookupWork::Data::lookOf(const LookupTask::Cutout& cutout) {
    const MaskAlpha& alpha = cutout.alpha;
    auto texture = static_cast<std::uint32_t>(textures.size());
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const Look& look = looks[i];
        if (look.tint != cutout.tint || look.alpha.texels != alpha.texels ||
            look.alpha.cutoff != alpha.cutoff)
            continue;
        texture = look.texture;
        if (look.alpha.opacity == alpha.opacity &&
            look.alpha.texcoordTransform == alpha.texcoordTransform)
            return i;
    }
    if (texture == textures.size()) {
        textures.push_back(textureFrom(alpha));
        if (cutout.tint) textures.back().tint = glm::make_vec3(cutout.tint->data());
    }
    looks.push_back({alpha, cutout.tint, texture});
    return looks.size() - 1;
}

std::shared_ptr<const CasterEdges> LookupWork::Data::edgesOf(const LookupTask::Caster& caster) {
    if (caster.shadow) {
        auto& solid = edges[{caster.shadow.get(), ~std::size_t{0}}];
        if (!solid) solid = std::make_shared<const CasterEdges>(casterEdgesOf(*caster.shadow));
        return solid;
    }
    const std::size_t look = lookOf(caster.cutout);
    auto& cutout = edges[{caster.cutout.mesh.get(), look}];
    if (!cutout)
        cutout = std::make_shared<const CasterEdges>(edgesFor(*caster.cutout.mesh, looks[look]));
    return cutout;
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
        PrimitiveMapSettings settings = settingsOf(task);
        settings.cutouts = textures;
        fitting.emplace(task.light, placed, settings);
    }
    if (fitting->step()) return true;
    built.why = refusalOf({fitting->map().has_value(), fitting->tooFar(), fitting->tooLong(),
                           task.settings.mostBytes});
    std::vector<Light> points;
    if (task.light.extent) points = lightPoints(task.light, task.settings.lightSamples);
    if (built.why.empty()) built.map = packedPrimitiveMap(std::move(*fitting->map()), points);
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

LookupWork workOn(LookupTask task, std::vector<HeldCaster> held) {
    auto data = std::make_shared<LookupWork::Data>();
    data->task = std::move(task);
    data->held = std::move(held);
    return LookupWork(std::move(data));
}

} // namespace edgeshade

// The mask engine's interface to JavaScript. Numbers are passed as addresses in the program's
// memory; a failing call returns a negative number or false, and lastProblem() holds its sentence.

#include "edgeshade/shadow_masks.hpp"
#include "preprocess/base/error.hpp"
#include "src/engine/merged_meshes.hpp"
#include "src/engine/mesh_place.hpp"
#include "web/masks/lookup_maker.hpp"
#include "web/masks/mesh_arguments.hpp"
#include "web/masks/mesh_packer.hpp"
#include "web/masks/mesh_transfer.hpp"
#include "web/masks/web_functions.hpp"
#include "web/page_bytes.hpp"
#include "web/sentence.hpp"

#include <algorithm>
#include <emscripten/bind.h>
#include <map>

namespace edgeshade::web {
namespace {

/// `numbers`: width, height, wraps along u and v (MaskTexels::Wrap), whether they are linear.
MaskTexels texelsAt(const std::uint16_t* alpha, const std::int32_t* numbers) {
    MaskTexels texels;
    texels.width = numbers[0];
    texels.height = numbers[1];
    texels.alpha.assign(alpha, alpha + numbers[5]);
    texels.wrapS = static_cast<MaskTexels::Wrap>(numbers[2]);
    texels.wrapT = static_cast<MaskTexels::Wrap>(numbers[3]);
    texels.linear = numbers[4] != 0;
    return texels;
}

/// `numbers`: opacity, cutoff, the transform's nine.
MaskAlpha alphaAt(unsigned texture, bool green, const float* numbers) {
    MaskAlpha alpha{.texture = texture, .opacity = numbers[0], .cutoff = numbers[1]};
    if (green) alpha.channel = MaskAlpha::Channel::green;
    std::copy_n(numbers + 2, alpha.texcoordTransform.size(), alpha.texcoordTransform.begin());
    return alpha;
}

/// Clippings, each by its planes' count, whether it clips their intersection, whether what it clips
/// casts, and four numbers for each plane.
std::vector<MaskClipping> clippingsAt(const double* numbers, std::size_t count) {
    std::vector<MaskClipping> all;
    for (; all.size() < count; numbers += 3 + 4 * all.back().planes.size())
        all.push_back({{reinterpret_cast<const std::array<double, 4>*>(numbers + 3),
                        static_cast<std::size_t>(numbers[0])},
                       numbers[1] != 0.0,
                       numbers[2] != 0.0});
    return all;
}

/// Numbers of a light: kind, position, direction, range, outer angle, radius.
constexpr std::size_t lightNumbers = 10;

MaskLight lightAt(const double* numbers) {
    MaskLight light;
    light.kind = static_cast<MaskLight::Kind>(static_cast<int>(numbers[0]));
    std::copy_n(numbers + 1, 3, light.position.begin());
    std::copy_n(numbers + 4, 3, light.direction.begin());
    light.range = numbers[7];
    light.outerAngle = numbers[8];
    light.radius = numbers[9];
    return light;
}

/// The masks of one context, which must be current at every call, and whose state the page keeps.
class PageMasks {
  public:
    bool start() {
        return done([&] { masks_.emplace(webFunction, StateKeeper::host); });
    }
    /// Drops everything that belonged to a lost context.
    void forget() { masks_.reset(); }

    /// Prepares a mesh and returns its number, which release() gives back.
    int prepare(std::uintptr_t positions, std::size_t floats, std::uintptr_t indices,
                std::size_t count, std::uintptr_t texcoords, std::size_t texcoordFloats,
                unsigned flags) {
        return numberOf([&] {
            return PreparedMesh(
                meshAt(positions, floats, indices, count, texcoords, texcoordFloats, flags));
        });
    }
    /// Begins to take over a mesh from the worker: a head of toTransfer(), `size` bytes from
    /// malloc(), which it frees. Nothing else may use the mesh before nextArray() is empty.
    int take(std::uintptr_t address, std::size_t size) {
        return numberOf([&] {
            const PageBytes bytes(address, size);
            return fillLater(meshOfHead(bytes.view()));
        });
    }
    /// Memory of the mesh that the next bytes after the head are to be copied to; empty: there are
    /// none, and the mesh may be used; null on failure.
    emscripten::val nextArray(int mesh) {
        std::span<std::uint8_t> array;
        const bool isThere = done([&] {
            std::vector<VectorApart>& apart = unfilled_.at(mesh);
            if (apart.empty()) {
                if (masks_) masks_->expect(meshes_.at(mesh));
                unfilled_.erase(mesh);
                return;
            }
            array = apart.back().bytes();
            apart.pop_back();
        });
        return isThere ? emscripten::val(emscripten::typed_memory_view(array.size(), array.data()))
                       : emscripten::val::null();
    }
    /// Whether prepareToDraw() has made what meshes that were taken over take.
    bool isPrepared() const { return !masks_ || masks_->isPrepared(); }
    int uploadStep(int mesh) {
        return truthOf([&] { return masks().uploadStep(meshes_.at(mesh)); });
    }
    void release(int mesh) {
        unfilled_.erase(mesh);
        meshes_.erase(mesh);
        worldFromMerged_.erase(mesh);
    }

    int add(int mesh, std::uintptr_t matrix) {
        int id = -1;
        done([&] { id = static_cast<int>(masks().add(meshes_.at(mesh), matrixAt(matrix))); });
        return id;
    }
    /// Takes over merged meshes from the worker, for uploadStep() and addMerged(): as take().
    /// Returns their number.
    int takeMerged(std::uintptr_t address, std::size_t size) {
        return numberOf([&] {
            const PageBytes bytes(address, size);
            Outlined<MergedMesh> taken = mergedOfHead(bytes.view());
            worldFromMerged_[nextMesh_] = taken.mesh.worldFromMerged;
            return fillLater(
                Outlined<PreparedMesh>{std::move(taken.mesh.mesh), std::move(taken.arrays)});
        });
    }
    /// Adds merged meshes. `meshes`: numbers of `count` members, which their ids replace.
    /// `matrices`: 16 numbers for each.
    bool addMerged(int merged, std::uintptr_t meshes, std::uintptr_t matrices, std::size_t count) {
        return done([&] {
            auto* const numbers = reinterpret_cast<int*>(meshes);
            MergedMeshes::Data data{{}, {}, {meshes_.at(merged), worldFromMerged_.at(merged)}};
            for (std::size_t i = 0; i < count; ++i) {
                data.numbers.push_back(i);
                data.members.push_back({meshes_.at(numbers[i]).data(),
                                        placeOf(matrixAt(matrices + i * sizeof(Matrix16)))});
            }
            const std::vector<ShadowMasks::Id> ids = masks().add(
                MergedMeshes(std::make_shared<const MergedMeshes::Data>(std::move(data))));
            std::copy(ids.begin(), ids.end(), numbers);
        });
    }
    bool change(int id, int mesh) {
        return done([&] { masks().change(idOf(id), meshes_.at(mesh)); });
    }
    /// Copies texels for setAlpha(), and returns their number, which releaseTexels() gives back.
    int addTexels(std::uintptr_t alpha, std::uintptr_t numbers) {
        const bool made = done([&] {
            texels_.emplace(nextTexels_, std::make_shared<const MaskTexels>(
                                             texelsAt(at<std::uint16_t>(alpha), at<int>(numbers))));
        });
        return made ? nextTexels_++ : -1;
    }
    void releaseTexels(int texels) { texels_.erase(texels); }
    /// Their alpha, valid until more memory is taken.
    emscripten::val texelAlpha(int texels) const {
        const std::vector<std::uint16_t>& alpha = texels_.at(texels)->alpha;
        return emscripten::val(emscripten::typed_memory_view(alpha.size(), alpha.data()));
    }
    /// Width, height, wraps and filter, as in texelsAt(), each by its index.
    int texelNumber(int texels, int index) const {
        const MaskTexels& of = *texels_.at(texels);
        const std::array<int, 5> numbers = {of.width, of.height, static_cast<int>(of.wrapS),
                                            static_cast<int>(of.wrapT), of.linear ? 1 : 0};
        return numbers.at(static_cast<std::size_t>(index));
    }
    /// `texels`: from addTexels(), or -1 for none.
    bool setAlpha(int id, unsigned texture, bool green, std::uintptr_t numbers, bool cutsOut,
                  int texels) {
        return done([&] {
            MaskAlpha alpha = alphaAt(texture, green, at<float>(numbers));
            alpha.cutsOut = cutsOut;
            if (texels >= 0) alpha.texels = texels_.at(texels);
            masks().setAlpha(idOf(id), alpha);
        });
    }
    /// `numbers`: red, green and blue, a negative red for none, and the texture's transform;
    /// `texels`: as in setAlpha().
    bool setTint(int id, std::uintptr_t numbers, int texels) {
        return done([&] {
            const float* from = at<float>(numbers);
            std::optional<std::array<float, 3>> tint;
            if (!(from[0] < 0.0f)) tint = {from[0], from[1], from[2]};
            MaskTintTexture texture;
            std::copy_n(from + 3, texture.texcoordTransform.size(),
                        texture.texcoordTransform.begin());
            if (texels >= 0) texture.texels = texels_.at(texels);
            masks().setTint(idOf(id), tint, texture);
        });
    }
    bool move(int id, std::uintptr_t matrix) {
        return done([&] { masks().move(idOf(id), matrixAt(matrix)); });
    }
    bool setClippings(int id, std::uintptr_t numbers, std::size_t count) {
        return done(
            [&] { masks().setClippings(idOf(id), clippingsAt(at<double>(numbers), count)); });
    }
    bool remove(int id) {
        return done([&] { masks().remove(idOf(id)); });
    }

    /// `matrices`: viewFromWorld, clipFromView; `lights`: each with its lookup's id after its
    /// numbers, -1 for none.
    bool draw(int width, int height, std::uintptr_t matrices, std::uintptr_t lights,
              std::size_t lightCount, std::size_t lightSamples, bool nearness) {
        return done([&] {
            const DrawnLights drawn = lightsAt(lights, lightCount);
            masks().draw(viewAt(matrices, width, height, lightSamples, nearness), drawn.lights,
                         drawn.lookups);
        });
    }
    /// As draw(), ahead of it. Returns 1 once all is there, 0 until then, -1 on failure.
    int prepareToDraw(int width, int height, std::uintptr_t matrices, std::uintptr_t lights,
                      std::size_t lightCount, std::size_t lightSamples, bool nearness) {
        return truthOf([&] {
            return masks().prepareToDraw(viewAt(matrices, width, height, lightSamples, nearness),
                                         lightsAt(lights, lightCount).lights);
        });
    }
    /// The same.
    int planAhead(int width, int height, std::uintptr_t matrices, std::uintptr_t lights,
                  std::size_t lightCount, std::size_t lightSamples, bool nearness) {
        return truthOf([&] {
            const DrawnLights drawn = lightsAt(lights, lightCount);
            return masks().planAhead(viewAt(matrices, width, height, lightSamples, nearness),
                                     drawn.lights, drawn.lookups);
        });
    }

    void setReceivers(double lowX, double lowY, double lowZ, double highX, double highY,
                      double highZ) {
        done([&] { masks().setReceivers({lowX, lowY, lowZ}, {highX, highY, highZ}); });
    }
    /// Takes a snapshot as input for LookupMaker. Returns its number, which endLookupTask() gives
    /// back.
    int beginLookupTask(std::uintptr_t light, int size, double mostBytes, double restMs,
                        bool cutouts, bool tints, std::size_t lightSamples) {
        const bool made = done([&] {
            LookupSettings settings{size, static_cast<std::size_t>(mostBytes), restMs,
                                    lightSamples};
            settings.casters = {cutouts, tints};
            tasks_.emplace(nextTask_,
                           TaskTransfer(masks().lookupWork(lightAt(at<double>(light)), settings)));
        });
        return made ? nextTask_++ : -1;
    }
    /// Its next bytes, up to `most`; none on failure, or if all were returned.
    emscripten::val lookupTaskPart(int task, std::size_t most) {
        bytes_ = {};
        done([&] { bytes_ = tasks_.at(task).next(most); });
        return viewOf(bytes_);
    }
    void endLookupTask(int task) { tasks_.erase(task); }
    /// Builds and uploads the map of cutouts and tinted meshes alone at once.
    int lookupCutouts(std::uintptr_t light, std::size_t mostTriangles) {
        int id = -1;
        done([&] {
            LookupSettings settings;
            settings.casters = {true, true};
            settings.cutoutsAlone = true;
            settings.mostTriangles = mostTriangles;
            LookupWork work = masks().lookupWork(lightAt(at<double>(light)), settings);
            work.finish();
            const auto made = masks().addLookup(work);
            masks().uploadLookup(made);
            id = static_cast<int>(made);
        });
        return id;
    }
    /// Takes over a result of LookupMaker: `size` bytes from malloc(), which it frees. The page
    /// uploads its texels.
    int addLookup(std::uintptr_t address, std::size_t size) {
        int id = -1;
        done([&] {
            const PageBytes bytes(address, size);
            id = static_cast<int>(masks().addLookup(resultFromTransfer(bytes.view())));
        });
        return id;
    }
    /// Sets the GL state that the page's upload relies on.
    bool prepareUpload(int id) {
        return done([&] { masks().uploadLookup(idOf(id)); });
    }
    bool removeLookup(int id) {
        return done([&] { masks().removeLookup(idOf(id)); });
    }
    /// Movers and, among them, those that have rested; empty if the lookup no longer holds.
    emscripten::val lookupState(int id, std::uintptr_t light, double restMs) {
        numbers_.clear();
        done([&] {
            const LookupState state = masks().state(idOf(id), lightAt(at<double>(light)), restMs);
            if (state.holds)
                numbers_ = {static_cast<double>(state.movers), static_cast<double>(state.rested)};
        });
        return numbers();
    }
    double casterState() const { return masks_ ? static_cast<double>(masks_->casterState()) : -1; }
    double restingState() const {
        return masks_ ? static_cast<double>(masks_->restingState()) : -1;
    }
    std::string lookupWhy(int id) {
        std::string why;
        const bool known = done([&] { why = masks().lookup(idOf(id)).why; });
        return known ? why : problem_;
    }
    /// Texture, table size (3), begins (2), size, kind, bytes, longest list,
    /// milliseconds, map from world (16), places (2).
    emscripten::val lookupNumbers(int id) {
        LightLookup told;
        done([&] { told = masks().lookup(idOf(id)); });
        numbers_ = {static_cast<double>(told.texture)};
        numbers_.insert(numbers_.end(), told.tableSize.begin(), told.tableSize.end());
        numbers_.insert(numbers_.end(), told.begins.begin(), told.begins.end());
        numbers_.insert(numbers_.end(), {told.size, told.kind, static_cast<double>(told.bytes),
                                         static_cast<double>(told.longestList), told.buildMs});
        numbers_.insert(numbers_.end(), told.mapFromWorld.begin(), told.mapFromWorld.end());
        numbers_.insert(numbers_.end(), told.places.begin(), told.places.end());
        return numbers();
    }

    std::string lastProblem() const { return problem_; }

    unsigned texture(std::size_t index) const {
        const auto all = masks_->textures();
        return index < all.size() ? all[index] : 0;
    }
    unsigned nearnessTexture() const { return masks_->nearness().texture; }
    double nearnessScale() const { return masks_->nearness().scale; }
    double nearnessOffset() const { return masks_->nearness().offset; }
    emscripten::val region() {
        const MaskRegion& of = masks_->region();
        numbers_ = {static_cast<double>(of.x), static_cast<double>(of.y),
                    static_cast<double>(of.width), static_cast<double>(of.height)};
        return numbers();
    }
    double buildMs() const { return masks_->cost().buildMs; }
    double drawMs() const { return masks_->cost().drawMs; }
    double vertexRuns() const { return static_cast<double>(masks_->cost().vertexRuns); }
    double batches() const { return static_cast<double>(masks_->cost().batches); }
    double bytes() const { return static_cast<double>(masks_->cost().bytes); }

  private:
    struct DrawnLights {
        std::vector<MaskLight> lights;
        std::vector<ShadowMasks::LookupId> lookups;
    };

    static ShadowMasks::Id idOf(int id) { return static_cast<ShadowMasks::Id>(id); }

    /// `matrices`: viewFromWorld and clipFromView.
    static MaskView viewAt(std::uintptr_t matrices, int width, int height, std::size_t lightSamples,
                           bool nearness) {
        return {matrixAt(matrices),
                matrixAt(matrices + sizeof(Matrix16)),
                width,
                height,
                lightSamples,
                nearness};
    }
    static DrawnLights lightsAt(std::uintptr_t address, std::size_t count) {
        DrawnLights all;
        for (std::size_t i = 0; i < count; ++i) {
            const double* numbers = at<double>(address) + (lightNumbers + 1) * i;
            all.lights.push_back(lightAt(numbers));
            const int id = static_cast<int>(numbers[lightNumbers]);
            all.lookups.push_back(id < 0 ? ShadowMasks::noLookup : idOf(id));
        }
        return all;
    }

    emscripten::val numbers() const {
        return emscripten::val(emscripten::typed_memory_view(numbers_.size(), numbers_.data()));
    }

    ShadowMasks& masks() {
        if (!masks_)
            throw Error(ExitStatus::unavailable, "The WebGL context of the shadows is lost.");
        return *masks_;
    }

    template <class Action>
    bool done(Action action) {
        problem_ = sentenceOfFailure(action);
        return problem_.empty();
    }
    /// 1 for true, 0 for false, -1 on failure.
    template <class Ask>
    int truthOf(Ask ask) {
        bool truth = false;
        return done([&] { truth = ask(); }) ? static_cast<int>(truth) : -1;
    }
    template <class Make>
    int numberOf(Make make) {
        const bool made = done([&] { meshes_.emplace(nextMesh_, make()); });
        return made ? nextMesh_++ : -1;
    }
    /// For the mesh that gets the next number.
    PreparedMesh fillLater(Outlined<PreparedMesh> taken) {
        std::reverse(taken.arrays.begin(), taken.arrays.end());
        unfilled_[nextMesh_] = std::move(taken.arrays);
        return std::move(taken.mesh);
    }

    std::optional<ShadowMasks> masks_;
    std::map<int, PreparedMesh> meshes_;
    std::map<int, std::vector<VectorApart>> unfilled_; ///< by number of a mesh, the next one last
    std::map<int, glm::dmat4> worldFromMerged_;        ///< by number of a merged mesh
    std::map<int, std::shared_ptr<const MaskTexels>> texels_;
    std::map<int, TaskTransfer> tasks_;
    int nextMesh_ = 0, nextTexels_ = 0, nextTask_ = 0;
    std::string problem_;
    Bytes bytes_;
    std::vector<double> numbers_;
};

EMSCRIPTEN_BINDINGS(edgeshade_masks) {
    emscripten::class_<PageMasks>("Masks")
        .constructor<>()
        .function("start", &PageMasks::start)
        .function("forget", &PageMasks::forget)
        .function("prepare", &PageMasks::prepare)
        .function("take", &PageMasks::take)
        .function("nextArray", &PageMasks::nextArray)
        .function("uploadStep", &PageMasks::uploadStep)
        .function("release", &PageMasks::release)
        .function("add", &PageMasks::add)
        .function("takeMerged", &PageMasks::takeMerged)
        .function("addMerged", &PageMasks::addMerged)
        .function("change", &PageMasks::change)
        .function("addTexels", &PageMasks::addTexels)
        .function("releaseTexels", &PageMasks::releaseTexels)
        .function("texelAlpha", &PageMasks::texelAlpha)
        .function("texelNumber", &PageMasks::texelNumber)
        .function("setAlpha", &PageMasks::setAlpha)
        .function("setTint", &PageMasks::setTint)
        .function("move", &PageMasks::move)
        .function("setClippings", &PageMasks::setClippings)
        .function("remove", &PageMasks::remove)
        .function("draw", &PageMasks::draw)
        .function("prepareToDraw", &PageMasks::prepareToDraw)
        .function("planAhead", &PageMasks::planAhead)
        .function("isPrepared", &PageMasks::isPrepared)
        .function("setReceivers", &PageMasks::setReceivers)
        .function("beginLookupTask", &PageMasks::beginLookupTask)
        .function("lookupTaskPart", &PageMasks::lookupTaskPart)
        .function("endLookupTask", &PageMasks::endLookupTask)
        .function("lookupCutouts", &PageMasks::lookupCutouts)
        .function("addLookup", &PageMasks::addLookup)
        .function("prepareUpload", &PageMasks::prepareUpload)
        .function("removeLookup", &PageMasks::removeLookup)
        .function("lookupState", &PageMasks::lookupState)
        .function("casterState", &PageMasks::casterState)
        .function("restingState", &PageMasks::restingState)
        .function("lookupWhy", &PageMasks::lookupWhy)
        .function("lookupNumbers", &PageMasks::lookupNumbers)
        .function("lastProblem", &PageMasks::lastProblem)
        .function("texture", &PageMasks::texture)
        .function("nearnessTexture", &PageMasks::nearnessTexture)
        .function("nearnessScale", &PageMasks::nearnessScale)
        .function("nearnessOffset", &PageMasks::nearnessOffset)
        .function("region", &PageMasks::region)
        .function("buildMs", &PageMasks::buildMs)
        .function("drawMs", &PageMasks::drawMs)
        .function("vertexRuns", &PageMasks::vertexRuns)
        .function("batches", &PageMasks::batches)
        .function("bytes", &PageMasks::bytes);
    emscripten::class_<LookupMaker>("LookupMaker")
        .constructor<>()
        .function("begin", &LookupMaker::begin)
        .function("advance", &LookupMaker::advance)
        .function("result", &LookupMaker::result)
        .function("texels", &LookupMaker::texels);
    emscripten::class_<MeshPacker>("MeshPacker")
        .constructor<>()
        .function("clear", &MeshPacker::clear)
        .function("pack", &MeshPacker::pack)
        .function("merge", &MeshPacker::merge)
        .function("mergedCount", &MeshPacker::mergedCount)
        .function("members", &MeshPacker::members)
        .function("mergedBytes", &MeshPacker::mergedBytes)
        .function("bytes", &MeshPacker::bytes);
}

} // namespace
} // namespace edgeshade::web

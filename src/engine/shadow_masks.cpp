#include "edgeshade/shadow_masks.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/base/stopwatch.hpp"
#include "preprocess/base/vectors.hpp"
#include "shaders_es2.hpp"
#include "src/engine/caster_scene.hpp"
#include "src/engine/host_lights.hpp"
#include "src/engine/light_lookups.hpp"
#include "src/engine/nearness_picture.hpp"
#include "src/gl/host_state.hpp"
#include "src/gl/scissor.hpp"
#include "src/render/accumulation/lit_counter.hpp"
#include "src/shadow/lights/light_extent.hpp"
#include "src/shadow/view/light_reach.hpp"

#include <algorithm>
#include <bit>
#include <GLES2/gl2.h>
#include <glm/gtc/type_ptr.hpp>
#include <limits>
#include <map>
#include <utility>

namespace edgeshade {
namespace {

constexpr std::size_t channels = 4;

/// Milliseconds that a call of prepareToDraw() takes over programs.
constexpr double stepMs = 4.0;

/// The context's capabilities in the framebuffers that masks are drawn into. Throws
/// Error(unavailable) where it can't draw into them.
gl::Capabilities capabilitiesOf(ShadowMasks::LookUp lookUp) {
    gl::Capabilities found = gl::queryCapabilities(lookUp);
    const gl::ColorTarget color(1, 1);
    const gl::DepthStencil depth(1, 1, found);
    depth.attach();
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ExitStatus::unavailable, "This GL can't draw into a texture with depth and "
                                             "stencil, which shadow masks need.");
    glGetIntegerv(GL_DEPTH_BITS, &found.depthBits);
    glGetIntegerv(GL_STENCIL_BITS, &found.stencilBits);
    found.samples = 0;
    return found;
}

/// The GL's functions that its version and extensions announce; queries nothing else.
gl::HostFunctions functionsOf(ShadowMasks::LookUp lookUp) {
    const auto text = [](GLenum name) {
        const GLubyte* string = glGetString(name);
        return std::string(string ? reinterpret_cast<const char*>(string) : "");
    };
    return gl::HostFunctions::find(text(GL_VERSION), text(GL_EXTENSIONS), lookUp);
}

RenderSettings settingsFor(const gl::Capabilities& capabilities) {
    RenderSettings settings;
    settings.layout = bestLayout(capabilities);
    return settings;
}

void requireSamples(std::size_t samples) {
    if (samples < 1 || samples > mostLightPoints)
        throw InputError("Lights have 1 to " + std::to_string(mostLightPoints) + " samples, not " +
                         std::to_string(samples) + ".");
}

void requireDrawable(const MaskView& view, std::size_t lights) {
    if (lights > ShadowMasks::mostLights)
        throw InputError(std::to_string(lights) + " lights are more than the " +
                         std::to_string(ShadowMasks::mostLights) + " that can have masks.");
    if (view.width < 1 || view.height < 1)
        throw InputError("A picture of " + std::to_string(view.width) + "x" +
                         std::to_string(view.height) + " pixels can't be drawn.");
    requireSamples(view.lightSamples);
}

/// Why a light with an extent has no map, whose points share one list: a clause, or empty.
/// `movers`: casters that the map would leave out.
std::string obstacleOfExtent(const LookupTask& task, std::size_t movers) {
    if (movers > 0) return "it has a radius, and casters move";
    const bool allSolid =
        std::all_of(task.casters.begin(), task.casters.end(),
                    [](const LookupTask::Caster& caster) { return caster.shadow != nullptr; });
    return allSolid ? "" : "it has a radius, and cutouts or tints cast";
}

std::size_t trianglesOf(const LookupTask& task) {
    std::size_t count = 0;
    for (const LookupTask::Caster& caster : task.casters)
        count += caster.shadow ? caster.shadow->caps.size()
                               : caster.cutout.mesh->geometry->indices.size() / 3;
    return count;
}

/// A box around receivers, with room for those that move a little.
Box withRoom(Box receivers) {
    const double room = 0.1 * receivers.diagonal();
    receivers.low -= room;
    receivers.high += room;
    return receivers;
}

} // namespace

/// A view of the casters, with what is counted for each of its lights.
struct MaskPlan {
    Frustum asked; ///< the host's
    FrameView view{};
    std::vector<std::optional<CasterScene::Movers>> movers{}; ///< empty: all casters
    std::vector<PixelRectangle> parts{};                      ///< beyond them masks are 1
};

/// Everything needed to draw; created and destroyed with the host's state kept.
struct MaskDrawing {
    explicit MaskDrawing(const gl::Capabilities& of)
        : capabilities(of), renderer(settingsFor(of), of), casters(renderer.settings().layout, of),
          counter(of), channel(shaders::mask_channel_frag), lookups(of) {}

    /// Begins to make what draw() takes. Returns whether it is there, see
    /// ShadowMasks::prepareToDraw().
    bool prepare(const MaskView& of, const std::vector<Light>& lights);
    void forEachProgram(const gl::ProgramVisitor& visit) const;
    /// `of`: by light, see ShadowMasks::draw().
    void draw(const MaskView& view, const std::vector<Light>& lights,
              std::span<const ShadowMasks::LookupId> of);
    /// Takes one step of what such a draw takes first. Returns whether it is all there.
    bool planAhead(const MaskView& view, const std::vector<Light>& lights,
                   std::span<const ShadowMasks::LookupId> of);
    MaskPlan plan(const MaskView& view, const std::vector<Light>& lights,
                  std::span<const ShadowMasks::LookupId> of);
    /// Fills in the layers of a plan's lights. Returns whether any had to be found that are known
    /// from now on.
    bool fillLayers(MaskPlan& plan);
    /// `view`: perhaps a part of it, beyond which the light's mask is 1.
    void drawLight(const FrameView& view, std::size_t light);
    /// Makes a light's mask 1.
    void clearMask(std::size_t light);
    /// Binds the framebuffer and the channel of a light's mask.
    void bindMask(std::size_t light);
    void fit(int width, int height, std::size_t lights);
    /// A box around everything that lights shine on.
    Box shoneOn() {
        Box box = casters.bounds();
        box.add(receivers);
        return box;
    }

    gl::Capabilities capabilities;
    Renderer renderer;
    CasterScene casters;
    LitCounter counter;
    WholePicture channel;
    LightLookups lookups;
    std::vector<gl::ColorTarget> masks;
    std::vector<unsigned> names;
    std::optional<NearnessPicture> nearness;
    MaskRegion region;
    Box receivers; ///< the host's that aren't casters' meshes
    int width = 0, height = 0;
    std::size_t vertexRuns = 0;
    std::size_t unfinished = 0; ///< programs that the last prepare() left so
    /// Whether open casters are expected, and whether prepare() has made what they take.
    bool open = false, openPrepared = false;
    bool hasDrawn = false;
};

void MaskDrawing::fit(int newWidth, int newHeight, std::size_t lights) {
    const std::size_t count = (lights + channels - 1) / channels;
    if (newWidth != width || newHeight != height) masks.clear();
    width = newWidth;
    height = newHeight;
    if (masks.size() > count) masks.resize(count);
    while (masks.size() < count)
        masks.emplace_back(width, height);
    names.clear();
    for (const gl::ColorTarget& mask : masks)
        names.push_back(mask.texture.name());
}

bool MaskDrawing::prepare(const MaskView& of, const std::vector<Light>& lights) {
    const bool orthographic =
        frustumOf(matrixOf(of.viewFromWorld), matrixOf(of.clipFromView)).orthographic;
    renderer.beginMaskPrograms(lights, orthographic, of.nearness, open);
    counter.beginPrograms();
    std::size_t begun = 0;
    bool completed = true;
    forEachProgram([&](const gl::Program& program) {
        begun += program.isFinished() ? 0 : 1;
        completed = completed && (!capabilities.parallelCompiling || program.isCompleted());
    });
    // The GL gets time to compile what was begun in this very call.
    const bool isNew = begun > unfinished;
    unfinished = begun;
    if (isNew || !completed) return false;
    Stopwatch watch;
    double worked = 0.0;
    forEachProgram([&](const gl::Program& program) {
        if (program.isFinished() || worked > stepMs) return;
        program.finish();
        --unfinished;
        worked += 1e3 * watch.lap();
    });
    if (unfinished > 0) return false;
    openPrepared = open;
    if (hasDrawn) return true; // the host may still show the last pictures
    fit(of.width, of.height, lights.size());
    counter.begin(of.width, of.height);
    if (of.nearness && !nearness) nearness.emplace(capabilities);
    if (of.nearness) nearness->fit(of.width, of.height);
    return true;
}

void MaskDrawing::forEachProgram(const gl::ProgramVisitor& visit) const {
    renderer.forEachProgram(visit);
    counter.forEachProgram(visit);
    channel.forEachProgram(visit);
}

MaskPlan MaskDrawing::plan(const MaskView& of, const std::vector<Light>& lights,
                           std::span<const ShadowMasks::LookupId> ids) {
    FrameRequest request{.frustum =
                             frustumOf(matrixOf(of.viewFromWorld), matrixOf(of.clipFromView)),
                         .width = of.width,
                         .height = of.height,
                         .lights = lights};
    request.lightSamples = of.lightSamples;
    request.nearestDepths = false; // volumes are drawn from plane-pair records
    MaskPlan made{request.frustum};
    FrameView& view = made.view;
    makeFrameView(casters.loaded().scene, request, casters.bounds(), casters.tree(), view);
    view.mask = view.sumsMasks = true;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        auto& movers = made.movers.emplace_back();
        view.lights[i].animatedAlone = !ids.empty() && ids[i] != ShadowMasks::noLookup;
        if (view.lights[i].animatedAlone) movers = casters.moversOver(lookups.held(ids[i]));
        made.parts.push_back(movers ? shadowReach(view, movers->bounds, view.lights[i].light)
                                    : PixelRectangle{0, 0, of.width, of.height});
    }
    return made;
}

bool MaskDrawing::fillLayers(MaskPlan& of) {
    bool isNew = casters.fillLayers(of.view);
    for (std::size_t i = 0; i < of.movers.size(); ++i)
        if (of.movers[i]) isNew = casters.fillLayers(of.view, i, *of.movers[i]) || isNew;
    return isNew;
}

bool MaskDrawing::planAhead(const MaskView& of, const std::vector<Light>& lights,
                            std::span<const ShadowMasks::LookupId> ids) {
    if (casters.prepareStep()) return false;
    MaskPlan planned = plan(of, lights, ids);
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (!casters.lookAhead(planned.view, i, planned.movers[i])) return false;
    if (fillLayers(planned)) return false;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (!planned.view.lights[i].points.empty() || planned.parts[i].empty()) continue;
        if (planned.movers[i]) casters.animate(*planned.movers[i]);
        planned.view.part = planned.parts[i];
        if (!LitCounter::planAhead(renderer, casters.gpu(), casters.loaded(),
                                   aloneView(planned.view, i), planned.view.lights))
            return false;
    }
    return true;
}

void MaskDrawing::draw(const MaskView& of, const std::vector<Light>& lights,
                       std::span<const ShadowMasks::LookupId> ids) {
    hasDrawn = true;
    casters.mergeResting();
    casters.upload();
    MaskPlan planned = plan(of, lights, ids);
    fillLayers(planned);
    FrameView& view = planned.view;
    fit(of.width, of.height, lights.size());
    vertexRuns = 0;
    const PixelRectangle whole{0, 0, width, height};
    PixelRectangle reach;
    for (const PixelRectangle& part : planned.parts)
        reach = united(reach, part);
    region = {reach.x, reach.y, reach.width, reach.height};
    // Hosts look around each pixel for their surface.
    const auto around =
        intersection(whole, {reach.x - 2, reach.y - 2, reach.width + 4, reach.height + 4});
    if (of.nearness && !nearness) nearness.emplace(capabilities);
    if (!of.nearness) nearness.reset();
    // Masks of movers need no surfaces but their depth, which they share with nearness.
    bool shares = nearness && view.slices.size() == 1;
    for (const auto& movers : planned.movers)
        shares = shares && movers;
    if (shares) counter.begin(width, height, around);
    shares = shares && counter.depthStencil();
    view.part = around;
    if (shares)
        nearness->draw(renderer, casters.gpu(), view, planned.asked, counter.depthStencil());
    view.depthDrawn = shares;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (planned.movers[i]) {
            clearMask(i);
            casters.animate(*planned.movers[i]);
        }
        view.part = planned.parts[i];
        if (!planned.parts[i].empty()) drawLight(view, i);
    }
    view.part = around;
    if (nearness && !shares) nearness->draw(renderer, casters.gpu(), view, planned.asked);
}

void MaskDrawing::drawLight(const FrameView& view, std::size_t light) {
    counter.begin(width, height, view.part);
    const std::size_t points = view.lights[light].points.size();
    if (points == 0) {
        counter.add(renderer, casters.gpu(), casters.loaded(), aloneView(view, light), view.lights);
    } else {
        counter.addPoints(renderer, casters.gpu(), casters.loaded(), view, light, 0, points,
                          view.lights);
    }
    vertexRuns += renderer.vertexRuns();
    const VisibilityLookup seen = counter.visibility();
    bindMask(light);
    const gl::ScissorScope cut(view.part);
    const gl::Program& program = channel.use();
    program.setTexture("u_visibility", 0, seen.texture);
    program.set("u_texel", 1.0f / seen.size);
    channel.draw();
    glBindTexture(GL_TEXTURE_2D, 0);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void MaskDrawing::clearMask(std::size_t light) {
    bindMask(light);
    glClearColor(1.0f, 1.0f, 1.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void MaskDrawing::bindMask(std::size_t light) {
    glBindFramebuffer(GL_FRAMEBUFFER, masks[light / channels].framebuffer.name());
    glViewport(0, 0, width, height);
    for (const GLenum off : {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_SCISSOR_TEST, GL_BLEND, GL_DITHER})
        glDisable(off);
    const auto writes = [&](std::size_t c) -> GLboolean { return light % channels == c; };
    glColorMask(writes(0), writes(1), writes(2), writes(3));
}

struct ShadowMasks::Impl {
    Impl(LookUp lookUp, StateKeeper keeper) : functions(functionsOf(lookUp)) {
        if (keeper == StateKeeper::engine) arrays.emplace(functions);
        withStateKept([&] { drawing.emplace(capabilitiesOf(lookUp)); });
    }

    /// Returns the host's own GL error.
    template <class Action>
    unsigned withStateKept(Action action) {
        if (!arrays) {
            gl::setDrawingDefaults(functions);
            action();
            return GL_NO_ERROR;
        }
        const gl::HostState state(functions, *arrays);
        action();
        gl::requireNoError("drawing shadow masks");
        return state.error();
    }

    PreparedMesh prepared(const MaskMesh& mesh) {
        Stopwatch watch;
        PreparedMesh made(mesh);
        buildMs += 1e3 * watch.lap();
        return made;
    }

    /// Compares a lookup's casters and its light with the present ones.
    LookupState compare(LookupId id, const Light& light, double restMs) {
        LookupState state = drawing->casters.compare(drawing->lookups.held(id), restMs);
        if (state.holds) held[id] = drawing->casters.casterState();
        state.holds = state.holds && drawing->lookups.isOf(id, light);
        if (state.holds && light.extent)
            state.holds = state.movers == 0 && drawing->lookups.reaches(id, drawing->shoneOn());
        return state;
    }

    /// Whether a lookup holds; compares casters of a light without an extent only if they have
    /// changed since compare().
    bool holds(LookupId id, const Light& light) {
        const auto found = held.find(id);
        const bool isKnown =
            !light.extent && found != held.end() && found->second == drawing->casters.casterState();
        return isKnown ? drawing->lookups.isOf(id, light)
                       : compare(id, light, ShadowMasks::longRestMs).holds;
    }

    /// Throws InputError unless there is a lookup or noLookup for each light, and all hold; or
    /// none.
    void requireHolding(std::span<const LookupId> all, const std::vector<Light>& lights) {
        if (!all.empty() && all.size() != lights.size())
            throw InputError(std::to_string(all.size()) + " lookups were passed for " +
                             std::to_string(lights.size()) + " lights.");
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (all[i] == noLookup) continue;
            const auto refuse = [&](const std::string& why) {
                throw InputError("Lookup " + std::to_string(all[i]) + " of light " +
                                 std::to_string(i) + why);
            };
            if (!drawing->lookups.told(all[i]).uploaded) refuse(" isn't uploaded.");
            if (!holds(all[i], lights[i]))
                refuse(" no longer holds: the light or a caster in it has moved.");
        }
    }

    gl::HostFunctions functions;
    std::optional<gl::OwnArrays> arrays; ///< empty: the host keeps its state itself
    std::optional<MaskDrawing> drawing;
    std::map<LookupId, std::size_t> held; ///< casterState() at which all casters of a lookup held
    double buildMs = 0.0;                 ///< since the last draw()
    MaskCost cost;
};

ShadowMasks::ShadowMasks(LookUp lookUp, StateKeeper keeper)
    : impl_(std::make_unique<Impl>(lookUp, keeper)) {}
ShadowMasks::~ShadowMasks() = default;
ShadowMasks::ShadowMasks(ShadowMasks&&) noexcept = default;
ShadowMasks& ShadowMasks::operator=(ShadowMasks&&) noexcept = default;

ShadowMasks::Id ShadowMasks::add(const PreparedMesh& mesh, const Matrix16& worldFromObject) {
    return impl_->drawing->casters.add(mesh, worldFromObject);
}

ShadowMasks::Id ShadowMasks::add(const MaskMesh& mesh, const Matrix16& worldFromObject) {
    return add(impl_->prepared(mesh), worldFromObject);
}

std::vector<ShadowMasks::Id> ShadowMasks::add(const MergedMeshes& meshes) {
    return impl_->drawing->casters.add(meshes);
}

void ShadowMasks::upload(const MergedMeshes& meshes) {
    upload(meshes.data()->merged.mesh);
}

void ShadowMasks::upload(const PreparedMesh& mesh) {
    while (!uploadStep(mesh)) {
    }
}

bool ShadowMasks::uploadStep(const MergedMeshes& meshes) {
    return uploadStep(meshes.data()->merged.mesh);
}

bool ShadowMasks::uploadStep(const PreparedMesh& mesh) {
    bool isDone = false;
    impl_->withStateKept([&] { isDone = impl_->drawing->casters.uploadStep(mesh); });
    return isDone;
}

void ShadowMasks::change(Id id, const PreparedMesh& mesh) {
    impl_->drawing->casters.change(id, mesh);
}

void ShadowMasks::change(Id id, const MaskMesh& mesh) {
    change(id, impl_->prepared(mesh));
}

void ShadowMasks::setAlpha(Id id, const MaskAlpha& alpha) {
    impl_->drawing->casters.setAlpha(id, alpha);
}

void ShadowMasks::setTint(Id id, const std::optional<std::array<float, 3>>& tint,
                          const MaskTintTexture& texture) {
    impl_->drawing->casters.setTint(id, tint, texture);
}

void ShadowMasks::move(Id id, const Matrix16& worldFromObject) {
    impl_->drawing->casters.move(id, worldFromObject);
}

void ShadowMasks::setClippings(Id id, std::span<const MaskClipping> clippings) {
    impl_->drawing->casters.setClippings(id, clippings);
}

void ShadowMasks::remove(Id id) {
    impl_->drawing->casters.remove(id);
}

void ShadowMasks::expect(const PreparedMesh& mesh) {
    const PlanePairShadow& shadow = *mesh.data()->shadow;
    impl_->drawing->open = impl_->drawing->open || !shadow.singles.empty();
}

bool ShadowMasks::isPrepared() const {
    return impl_->drawing->openPrepared || !impl_->drawing->open;
}

bool ShadowMasks::prepareToDraw(const MaskView& view, std::span<const MaskLight> lights) {
    requireDrawable(view, lights.size());
    const std::vector<Light> planned = lightsOf(lights);
    bool isReady = false;
    impl_->withStateKept([&] { isReady = impl_->drawing->prepare(view, planned); });
    return isReady;
}

bool ShadowMasks::planAhead(const MaskView& view, std::span<const MaskLight> lights,
                            std::span<const LookupId> lookups) {
    requireDrawable(view, lights.size());
    const std::vector<Light> planned = lightsOf(lights);
    impl_->requireHolding(lookups, planned);
    bool isDone = false;
    impl_->withStateKept([&] { isDone = impl_->drawing->planAhead(view, planned, lookups); });
    return isDone;
}

void ShadowMasks::draw(const MaskView& view, std::span<const MaskLight> lights,
                       std::span<const LookupId> lookups) {
    requireDrawable(view, lights.size());
    const std::vector<Light> planned = lightsOf(lights);
    impl_->requireHolding(lookups, planned);
    Stopwatch watch;
    MaskDrawing& drawing = *impl_->drawing;
    MaskCost cost;
    cost.hostError = impl_->withStateKept([&] { drawing.draw(view, planned, lookups); });
    cost.buildMs = std::exchange(impl_->buildMs, 0.0);
    cost.drawMs = 1e3 * watch.lap();
    cost.vertexRuns = drawing.vertexRuns;
    cost.batches = drawing.casters.drawnBatches();
    cost.bytes = drawing.casters.bytes() + drawing.renderer.bytes() + drawing.counter.bytes() +
                 drawing.lookups.bytes() +
                 drawing.masks.size() * channels * static_cast<std::size_t>(view.width) *
                     static_cast<std::size_t>(view.height) +
                 (drawing.nearness ? drawing.nearness->bytes() : 0);
    impl_->cost = cost;
}

std::span<const unsigned> ShadowMasks::textures() const {
    return impl_->drawing->names;
}

const MaskNearness& ShadowMasks::nearness() const {
    static constexpr MaskNearness none;
    return impl_->drawing->nearness ? impl_->drawing->nearness->told() : none;
}

const MaskRegion& ShadowMasks::region() const {
    return impl_->drawing->region;
}

const MaskCost& ShadowMasks::cost() const {
    return impl_->cost;
}

void ShadowMasks::setReceivers(const std::array<double, 3>& low,
                               const std::array<double, 3>& high) {
    Box box;
    for (const auto& corner : {low, high})
        box.add(glm::make_vec3(corner.data()));
    const bool isFinite = edgeshade::isFinite(box.low) && edgeshade::isFinite(box.high);
    impl_->drawing->receivers = isFinite ? box : Box();
}

LookupWork ShadowMasks::lookupWork(const MaskLight& light, const LookupSettings& settings) const {
    MaskDrawing& drawing = *impl_->drawing;
    if (settings.size < 4 || !std::has_single_bit(static_cast<unsigned>(settings.size)))
        throw InputError(
            "A map of " + std::to_string(settings.size) +
            " texels along its edge can't be made: the size must be a power of 2, at least 4.");
    if (!(settings.restMs >= 0.0))
        throw InputError("Casters can't rest for " + std::to_string(settings.restMs) +
                         " milliseconds: restMs must be 0 or more.");
    requireSamples(settings.lightSamples);
    CasterScene::Casters resting = settings.cutoutsAlone
                                       ? drawing.casters.cutouts(settings.casters)
                                       : drawing.casters.resting(settings.restMs, settings.casters);
    LookupTask task{lightsOf({&light, 1}).front(), settings, std::move(resting.casters), {}};
    task.why = drawing.lookups.obstacle();
    if (task.why.empty() && task.casters.empty() && drawing.casters.hasCasters())
        task.why = settings.cutoutsAlone ? "no cutouts or tints cast" : "all casters move";
    if (const std::size_t triangles = trianglesOf(task);
        task.why.empty() && triangles > settings.mostTriangles)
        task.why = "its casters have " + std::to_string(triangles) + " triangles, more than " +
                   std::to_string(settings.mostTriangles);
    if (task.light.extent) {
        if (task.why.empty())
            task.why = obstacleOfExtent(
                task, drawing.casters.compare(resting.held, settings.restMs).movers);
        task.receivers = withRoom(drawing.shoneOn());
        task.light.cone.reset(); // the host's own
        task.light.range = std::numeric_limits<double>::infinity();
    }
    return workOn(std::move(task), std::move(resting.held));
}

ShadowMasks::LookupId ShadowMasks::addLookup(const LookupWork& work) {
    LookupId id = 0;
    impl_->withStateKept([&] { id = impl_->drawing->lookups.add(work); });
    return id;
}

bool ShadowMasks::uploadLookup(LookupId id, std::size_t mostBytes) {
    bool whole = false;
    impl_->withStateKept([&] { whole = impl_->drawing->lookups.upload(id, mostBytes); });
    return whole;
}

const LightLookup& ShadowMasks::lookup(LookupId id) const {
    return impl_->drawing->lookups.told(id);
}

std::size_t ShadowMasks::casterState() const {
    return impl_->drawing->casters.casterState();
}

std::size_t ShadowMasks::restingState() const {
    return impl_->drawing->casters.restingState();
}

LookupState ShadowMasks::state(LookupId id, const MaskLight& light, double restMs) const {
    return impl_->compare(id, lightsOf({&light, 1}).front(), restMs);
}

void ShadowMasks::removeLookup(LookupId id) {
    impl_->withStateKept([&] { impl_->drawing->lookups.remove(id); });
    impl_->held.erase(id);
}

} // namespace edgeshade

#include "edgeshade/shadow_masks.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/base/stopwatch.hpp"
#include "shaders_es2.hpp"
#include "src/engine/caster_scene.hpp"
#include "src/engine/host_lights.hpp"
#include "src/engine/light_lookups.hpp"
#include "src/engine/nearness_picture.hpp"
#include "src/gl/host_state.hpp"
#include "src/render/accumulation/lit_counter.hpp"

#include <bit>
#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

constexpr std::size_t channels = 4;

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

} // namespace

/// Everything needed to draw; created and destroyed with the host's state kept.
struct MaskDrawing {
    explicit MaskDrawing(const gl::Capabilities& of)
        : capabilities(of), renderer(settingsFor(of), of), casters(renderer.settings().layout, of),
          counter(of), channel(shaders::mask_channel_frag), lookups(of) {}

    void draw(const MaskView& view, const std::vector<Light>& lights);
    void drawLight(const FrameView& view, std::size_t light);
    void fit(int width, int height, std::size_t lights);

    gl::Capabilities capabilities;
    Renderer renderer;
    CasterScene casters;
    LitCounter counter;
    WholePicture channel;
    LightLookups lookups;
    std::vector<gl::ColorTarget> masks;
    std::vector<unsigned> names;
    std::optional<NearnessPicture> nearness;
    int width = 0, height = 0;
    std::size_t vertexRuns = 0;
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

void MaskDrawing::draw(const MaskView& of, const std::vector<Light>& lights) {
    FrameRequest request{.frustum =
                             frustumOf(matrixOf(of.viewFromWorld), matrixOf(of.clipFromView)),
                         .width = of.width,
                         .height = of.height,
                         .lights = lights};
    request.lightSamples = of.lightSamples;
    casters.mergeResting();
    casters.upload();
    request.nearestDepths = false; // volumes are drawn from plane-pair records
    FrameView view =
        makeFrameView(casters.loaded().scene, request, casters.bounds(), casters.tree());
    casters.fillLayers(view);
    view.mask = view.sumsMasks = true;
    fit(of.width, of.height, lights.size());
    vertexRuns = 0;
    for (std::size_t i = 0; i < lights.size(); ++i)
        drawLight(view, i);
    if (!of.nearness) {
        nearness.reset();
        return;
    }
    if (!nearness) nearness.emplace(capabilities);
    nearness->draw(renderer, casters.gpu(), view, request.frustum);
}

void MaskDrawing::drawLight(const FrameView& view, std::size_t light) {
    counter.begin(width, height);
    const std::size_t points = view.lights[light].points.size();
    if (points == 0) {
        FrameView alone = view;
        alone.lights = {view.lights[light]};
        counter.add(renderer, casters.gpu(), casters.loaded(), alone, view.lights);
    } else {
        counter.addPoints(renderer, casters.gpu(), casters.loaded(), view, light, 0, points,
                          view.lights);
    }
    vertexRuns += renderer.vertexRuns();
    const VisibilityLookup seen = counter.visibility();
    glBindFramebuffer(GL_FRAMEBUFFER, masks[light / channels].framebuffer.name());
    glViewport(0, 0, width, height);
    for (const GLenum off : {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_SCISSOR_TEST, GL_BLEND, GL_DITHER})
        glDisable(off);
    const auto writes = [&](std::size_t c) -> GLboolean { return light % channels == c; };
    glColorMask(writes(0), writes(1), writes(2), writes(3));
    const gl::Program& program = channel.use();
    program.setTexture("u_visibility", 0, seen.texture);
    program.set("u_texel", 1.0f / seen.size);
    channel.draw();
    glBindTexture(GL_TEXTURE_2D, 0);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
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

    gl::HostFunctions functions;
    std::optional<gl::OwnArrays> arrays; ///< empty: the host keeps its state itself
    std::optional<MaskDrawing> drawing;
    double buildMs = 0.0; ///< since the last draw()
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
    impl_->withStateKept([&] { impl_->drawing->casters.upload(mesh); });
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

void ShadowMasks::move(Id id, const Matrix16& worldFromObject) {
    impl_->drawing->casters.move(id, worldFromObject);
}

void ShadowMasks::setClippings(Id id, std::span<const MaskClipping> clippings) {
    impl_->drawing->casters.setClippings(id, clippings);
}

void ShadowMasks::remove(Id id) {
    impl_->drawing->casters.remove(id);
}

void ShadowMasks::draw(const MaskView& view, std::span<const MaskLight> lights) {
    const std::vector<Light> planned = lightsOf(lights);
    if (planned.size() > mostLights)
        throw InputError(std::to_string(planned.size()) + " lights are more than the " +
                         std::to_string(mostLights) + " that can have masks.");
    if (view.width < 1 || view.height < 1)
        throw InputError("A picture of " + std::to_string(view.width) + "x" +
                         std::to_string(view.height) + " pixels can't be drawn.");
    if (view.lightSamples < 1 || view.lightSamples > mostLightPoints)
        throw InputError("Lights have 1 to " + std::to_string(mostLightPoints) + " samples, not " +
                         std::to_string(view.lightSamples) + ".");
    Stopwatch watch;
    MaskDrawing& drawing = *impl_->drawing;
    MaskCost cost;
    cost.hostError = impl_->withStateKept([&] { drawing.draw(view, planned); });
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

const MaskCost& ShadowMasks::cost() const {
    return impl_->cost;
}

LookupWork ShadowMasks::lookupWork(const MaskLight& light, const LookupSettings& settings) const {
    const MaskDrawing& drawing = *impl_->drawing;
    if (settings.size < 4 || !std::has_single_bit(static_cast<unsigned>(settings.size)))
        throw InputError(
            "A map of " + std::to_string(settings.size) +
            " texels along its edge can't be made: the size must be a power of 2, at least 4.");
    LookupTask task{lightsOf({&light, 1}).front(), settings, drawing.casters.casters(), {}};
    task.why = drawing.lookups.obstacle(task.light);
    return workOn(std::move(task), drawing.casters.casterState());
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

bool ShadowMasks::isCurrent(LookupId id, const MaskLight& light) const {
    const MaskDrawing& drawing = *impl_->drawing;
    return drawing.lookups.isCurrent(id, lightsOf({&light, 1}).front(),
                                     drawing.casters.casterState());
}

void ShadowMasks::removeLookup(LookupId id) {
    impl_->withStateKept([&] { impl_->drawing->lookups.remove(id); });
}

} // namespace edgeshade

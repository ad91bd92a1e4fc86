// The program's interface to JavaScript. Messages are sentences, "" for success; state and figures
// are JSON.

#include "src/gl/capabilities.hpp"
#include "src/viewer/viewer.hpp"
#include "web/commands.hpp"
#include "web/map_maker.hpp"
#include "web/page_bytes.hpp"
#include "web/page_map_worker.hpp"
#include "web/scene_reader.hpp"
#include "web/scene_transfer.hpp"
#include "web/sentence.hpp"

#include <emscripten/bind.h>
#define GL_GLEXT_PROTOTYPES // declares the entry points
#include <GLES2/gl2.h>
#include <GLES2/gl2ext.h>
#include <memory>
#include <string_view>

namespace edgeshade::web {
namespace {

/// The only two entry points beyond WebGL 1 that the program queries.
void* entryPoint(const char* name) {
    const std::string_view wanted = name;
    if (wanted == "glVertexAttribDivisorANGLE")
        return reinterpret_cast<void*>(glVertexAttribDivisorANGLE);
    if (wanted == "glDrawArraysInstancedANGLE")
        return reinterpret_cast<void*>(glDrawArraysInstancedANGLE);
    return nullptr;
}

/// Capabilities of the current context.
gl::Capabilities usableCapabilities() {
    gl::Capabilities capabilities = gl::queryCapabilities(entryPoint);
    if (capabilities.stencilBits < 8)
        throw Error(ExitStatus::unavailable,
                    "This browser gave a WebGL context with a stencil of " +
                        std::to_string(capabilities.stencilBits) + " bits; shadow volumes need 8.");
    return capabilities;
}

/// The viewer of one element; it uses the context that is current at each call.
class PageViewer {
  public:
    /// `maps`: see PageMapWorker.
    std::string start(emscripten::val maps) {
        return sentenceOfFailure([&] {
            maps_ = std::make_shared<PageMapWorker>(std::move(maps));
            viewer_ = std::make_unique<viewer::Viewer>(usableCapabilities(),
                                                       viewer::ViewerSettings{{}, {}, {}, maps_});
        });
    }

    /// Takes over a scene from the worker: `size` bytes from malloc(), which it frees.
    std::string show(std::uintptr_t address, std::size_t size) {
        return sentenceOfFailure([&] {
            std::optional<PageBytes> bytes(std::in_place, address, size);
            LoadedScene loaded = fromTransfer(bytes->view());
            bytes.reset();
            viewer_->show(std::move(loaded));
        });
    }

    /// Takes over a primitive map from the worker, in the same way.
    std::string takeMap(std::uintptr_t address, std::size_t size) {
        return sentenceOfFailure([&] {
            const PageBytes bytes(address, size);
            maps_->done(bytes.view());
        });
    }
    /// Called when no worker will ever answer.
    void buildMapsHere() { maps_->fail(); }

    bool hasScene() const { return viewer_->hasScene(); }
    void resize(int width, int height, double pixelRatio) {
        viewer_->resize(width, height, pixelRatio);
    }
    std::string state() const { return viewer::toJson(viewer_->state()).dump(); }
    std::string stats() const { return viewer::toJson(viewer_->stats()).dump(); }

    std::string change(const std::string& changes) {
        return sentenceOfFailure([&] { viewer_->change(nlohmann::ordered_json::parse(changes)); });
    }

    std::string run(const std::string& command) {
        return sentenceOfFailure([&] { viewer_->run(commandOf(command)); });
    }

    /// `button`: as in a PointerEvent; -1 if none changed.
    void pointer(int phase, int id, double x, double y, int button, bool shift, bool control) {
        using viewer::PointerButton;
        viewer::Pointer pointer{id, x, y, PointerButton::primary, shift, control};
        if (button == 1) pointer.button = PointerButton::middle;
        if (button == 2) pointer.button = PointerButton::secondary;
        if (phase == 0) viewer_->pointerDown(pointer);
        if (phase == 1) viewer_->pointerMove(pointer);
        if (phase == 2) viewer_->pointerUp(pointer);
    }
    void wheel(double x, double y, double notches) { viewer_->wheel(x, y, notches); }

    std::string animations() const { return nlohmann::ordered_json(viewer_->animations()).dump(); }
    std::string lightPoints() const { return viewer::toJson(viewer_->lightPoints()).dump(); }
    std::string smoothing() const { return viewer::toJson(viewer_->smoothing()).dump(); }
    double sceneSize() const { return viewer_->sceneSize(); }
    std::string sun() const { return viewer_->sun().dump(); }
    /// Number of sun positions counted for hours of sunlight; -1: the state doesn't show them.
    double sunHoursCounted() const {
        const auto hours = viewer_->sunHours();
        return hours ? static_cast<double>(hours->counted) : -1.0;
    }
    double sunHoursOf() const { return static_cast<double>(viewer_->sunHours()->of); }
    /// -1: no hours are shown there.
    double sunHoursAt(double x, double y) const {
        const auto lit = viewer_->sunHoursAt(x, y);
        return lit ? static_cast<double>(*lit) : -1.0;
    }
    double animationSeconds() const { return viewer_->animationSeconds(); }
    bool wantsFrame() const { return viewer_->wantsFrame(); }
    void invalidate() { viewer_->invalidate(); }

    /// Draws if anything has changed. lastProblem() then holds the sentence of a failure.
    bool frame(double now) {
        bool drew = false;
        problem_ = sentenceOfFailure([&] { drew = viewer_->frame(now); });
        return drew;
    }
    std::string lastProblem() const { return problem_; }

    void forgetGpu() { viewer_->forgetGpu(); }
    std::string restoreGpu() {
        return sentenceOfFailure([&] { viewer_->restoreGpu(usableCapabilities()); });
    }

  private:
    std::shared_ptr<PageMapWorker> maps_;
    std::unique_ptr<viewer::Viewer> viewer_;
    std::string problem_;
};

EMSCRIPTEN_BINDINGS(edgeshade) {
    emscripten::class_<PageViewer>("Viewer")
        .constructor<>()
        .function("start", &PageViewer::start)
        .function("show", &PageViewer::show)
        .function("takeMap", &PageViewer::takeMap)
        .function("buildMapsHere", &PageViewer::buildMapsHere)
        .function("hasScene", &PageViewer::hasScene)
        .function("resize", &PageViewer::resize)
        .function("state", &PageViewer::state)
        .function("stats", &PageViewer::stats)
        .function("change", &PageViewer::change)
        .function("run", &PageViewer::run)
        .function("pointer", &PageViewer::pointer)
        .function("wheel", &PageViewer::wheel)
        .function("animations", &PageViewer::animations)
        .function("lightPoints", &PageViewer::lightPoints)
        .function("smoothing", &PageViewer::smoothing)
        .function("sceneSize", &PageViewer::sceneSize)
        .function("sun", &PageViewer::sun)
        .function("sunHoursCounted", &PageViewer::sunHoursCounted)
        .function("sunHoursOf", &PageViewer::sunHoursOf)
        .function("sunHoursAt", &PageViewer::sunHoursAt)
        .function("animationSeconds", &PageViewer::animationSeconds)
        .function("wantsFrame", &PageViewer::wantsFrame)
        .function("invalidate", &PageViewer::invalidate)
        .function("frame", &PageViewer::frame)
        .function("lastProblem", &PageViewer::lastProblem)
        .function("forgetGpu", &PageViewer::forgetGpu)
        .function("restoreGpu", &PageViewer::restoreGpu);
    emscripten::class_<MapMaker>("MapMaker")
        .constructor<>()
        .function("show", &MapMaker::show)
        .function("begin", &MapMaker::begin)
        .function("advance", &MapMaker::advance)
        .function("result", &MapMaker::result);
    emscripten::class_<SceneReader>("SceneReader")
        .constructor<>()
        .function("read", &SceneReader::read)
        .function("wantedImages", &SceneReader::wantedImages)
        .function("webpOf", &SceneReader::webpOf)
        .function("roomFor", &SceneReader::roomFor)
        .function("room", &SceneReader::room)
        .function("decideImage", &SceneReader::decideImage)
        .function("finish", &SceneReader::finish)
        .function("bytes", &SceneReader::bytes)
        .function("warnings", &SceneReader::warnings)
        .function("variants", &SceneReader::variants)
        .function("cameras", &SceneReader::cameras)
        .function("triangles", &SceneReader::triangles);
}

} // namespace
} // namespace edgeshade::web

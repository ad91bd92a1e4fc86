#include "src/desktop/app.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/reading/variants.hpp"
#include "src/desktop/hours_legend.hpp"
#include "src/desktop/keys.hpp"
#include "src/desktop/screenshot.hpp"
#include "src/desktop/text.hpp"

#include <algorithm>
#include <cmath>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace edgeshade::desktop {
namespace {

using viewer::PointerButton;

App& appOf(GLFWwindow* window) {
    return *static_cast<App*>(glfwGetWindowUserPointer(window));
}

PointerButton buttonFrom(int button) {
    if (button == GLFW_MOUSE_BUTTON_RIGHT) return PointerButton::secondary;
    if (button == GLFW_MOUSE_BUTTON_MIDDLE) return PointerButton::middle;
    return PointerButton::primary;
}

} // namespace

App::App(const WindowRequest& request, const viewer::ViewerSettings& settings, Load load)
    : window_(request), viewer_(window_.capabilities(), settings), load_(std::move(load)) {
    connect();
    fitToWindow();
}

void App::connect() {
    GLFWwindow* window = window_.handle();
    glfwSetWindowUserPointer(window, this);
    glfwGetCursorPos(window, &cursor_.x, &cursor_.y);
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int modifiers) {
        appOf(w).onKey(key, action, modifiers);
    });
    glfwSetCharCallback(window,
                        [](GLFWwindow* w, unsigned character) { appOf(w).onCharacter(character); });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int modifiers) {
        appOf(w).onButton(button, action, modifiers);
    });
    glfwSetCursorPosCallback(window,
                             [](GLFWwindow* w, double x, double y) { appOf(w).onMove(x, y); });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double, double notches) {
        App& app = appOf(w);
        const viewer::Pointer at = app.pointer();
        app.guarded([&] { app.viewer_.wheel(at.x, at.y, notches); });
    });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        if (count > 0) appOf(w).onDrop(paths[0]);
    });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { appOf(w).fitToWindow(); });
    glfwSetWindowContentScaleCallback(window,
                                      [](GLFWwindow* w, float, float) { appOf(w).fitToWindow(); });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { appOf(w).viewer_.invalidate(); });
}

void App::fitToWindow() {
    glfwGetFramebufferSize(window_.handle(), &width_, &height_);
    float scaleY = 1.0f;
    glfwGetWindowContentScale(window_.handle(), &scale_, &scaleY);
    viewer_.resize(width_, height_, scale_);
}

void App::show(const std::filesystem::path& path, LoadedScene loaded) {
    std::vector<std::string> variants = variantNames(*loaded.document);
    variants.insert(variants.begin(), "");
    const auto shown = std::find(variants.begin(), variants.end(), loaded.looks.variant);
    const auto index =
        shown == variants.end() ? 0 : static_cast<std::size_t>(shown - variants.begin());
    viewer_.show(std::move(loaded));
    path_ = path;
    variants_ = std::move(variants);
    variant_ = index;
    nextCamera_ = 0;
}

void App::showNextVariant() {
    if (variants_.size() == 1) return say("The scene has no variants");
    const std::string next = variants_[(variant_ + 1) % variants_.size()];
    const auto state = viewer::toJson(viewer_.state());
    show(path_, load_(path_, next));
    viewer_.change(state);
    say(next.empty() ? "The scene's own materials" : "Variant " + next);
}

void App::showNextCamera() {
    const std::vector<FileCamera> cameras = viewer_.cameras();
    if (cameras.empty()) return say("The scene has no perspective cameras");
    const std::size_t index = nextCamera_ % cameras.size();
    viewer_.change({{"camera", viewer::toJson(cameras[index].camera)}});
    nextCamera_ = index + 1;
    say("Camera " + std::to_string(index + 1) + " of " + std::to_string(cameras.size()) + ": " +
        cameras[index].title);
}

void App::run() {
    constexpr double pause = 0.01; // seconds, while something is built and nothing is drawn
    while (!glfwWindowShouldClose(window_.handle())) {
        bool drawn = false;
        if (viewer_.wantsFrame()) {
            guarded([&] { drawn = draw(); });
            window_.requireContext();
        }
        if (!viewer_.wantsFrame())
            glfwWaitEvents();
        else if (drawn)
            glfwPollEvents();
        else
            glfwWaitEventsTimeout(pause);
    }
}

bool App::draw() {
    if (width_ == 0 || height_ == 0) { // the window is minimised
        glfwWaitEvents();
        return false;
    }
    if (!viewer_.frame(glfwGetTime())) return false;
    const float size = std::max(1.0f, std::round(1.6f * scale_));
    const float gap = 8.0f * size;
    viewer::OverlayTriangles text;
    const auto add = [&](const std::string& lines, float y) {
        const auto more = textTriangles(lines, gap, y, size);
        text.insert(text.end(), more.begin(), more.end());
    };
    const std::string figuresNow = showsFigures_ ? figures() : "";
    if (showsFigures_) add(figuresNow, gap);
    if (showsHelp_)
        add(helpText(), gap + (showsFigures_ ? textHeight(figuresNow, size) + gap : 0.0f));
    const std::string line = message_.empty() && !viewer_.hasScene()
                                 ? "Drop a .gltf or .glb file here. H: help"
                                 : message_;
    float bottom = static_cast<float>(height_) - gap;
    if (!line.empty()) {
        bottom -= textHeight(line, size);
        add(line, bottom);
        bottom -= gap;
    }
    if (const auto hours = viewer_.sunHours()) {
        const viewer::Pointer at = pointer();
        const auto legend = hoursLegend(*hours, viewer_.showsSunHours(),
                                        viewer_.sunHoursAt(at.x, at.y), gap, bottom, size);
        text.insert(text.end(), legend.begin(), legend.end());
    }
    overlay_.draw(text, width_, height_);
    glfwSwapBuffers(window_.handle());
    return true;
}

void App::say(const std::string& message) {
    message_ = message;
    viewer_.invalidate();
}

/// Shows an error inside the loop as a line of text; the scene on show stays.
template <class Action>
void App::guarded(Action action) {
    try {
        action();
    } catch (const Error& error) {
        std::cerr << "edgeshade: " << error.what() << std::endl;
        say(error.what());
    }
}

void App::settle() {
    const auto isCounting = [&] {
        const auto hours = viewer_.sunHours();
        const viewer::LightPoints points = viewer_.lightPoints();
        const viewer::LightPoints pictures = viewer_.smoothing();
        return points.shown < points.of || pictures.shown < pictures.of ||
               (hours && hours->counted < hours->of);
    };
    do
        viewer_.frame(glfwGetTime());
    while (isCounting());
}

void App::saveScreenshot(const std::filesystem::path& path) {
    const bool hadHandles = viewer_.state().showLights;
    viewer_.change({{"show_lights", false}});
    viewer_.frame(glfwGetTime());
    const Bytes png = screenshotPng(width_, height_);
    viewer_.change({{"show_lights", hadHandles}});
    writeFile(path, png);
}

void App::onKey(int key, int action, int modifiers) {
    if (action == GLFW_RELEASE) return;
    guarded([&] {
        if (key == GLFW_KEY_ESCAPE && showsHelp_) {
            showsHelp_ = false;
            viewer_.invalidate();
        } else if (key == GLFW_KEY_ESCAPE) {
            glfwSetWindowShouldClose(window_.handle(), GLFW_TRUE);
        } else if (key == GLFW_KEY_F12 && action == GLFW_PRESS) {
            onCharacter('p');
        } else if (const auto command = commandForKey(key, modifiers)) {
            viewer_.run(*command);
        }
    });
}

void App::onCharacter(unsigned character) {
    if (character >= 'A' && character <= 'Z') character += 'a' - 'A';
    message_.clear();
    guarded([&] {
        if (character == 'h' || character == '?') {
            showsHelp_ = !showsHelp_;
        } else if (character == 'i') {
            showsFigures_ = !showsFigures_;
        } else if (character == 'p') {
            const std::filesystem::path path = freeScreenshotName();
            saveScreenshot(path);
            std::cerr << path.string() << std::endl;
            say("Saved as " + path.string());
        } else if (character == 'k') {
            showNextVariant();
        } else if (character == 'c') {
            showNextCamera();
        } else if (const auto command = commandForCharacter(character)) {
            viewer_.run(*command);
        }
        viewer_.invalidate();
    });
}

viewer::Pointer App::pointer() const {
    int windowWidth = 1, windowHeight = 1;
    glfwGetWindowSize(window_.handle(), &windowWidth, &windowHeight);
    viewer::Pointer result = pressed_;
    result.x = cursor_.x * width_ / std::max(1, windowWidth);
    result.y = cursor_.y * height_ / std::max(1, windowHeight);
    return result;
}

void App::onButton(int button, int action, int modifiers) {
    // A mouse is one pointer: the gesture of its first button lasts until all buttons are up.
    if (action == GLFW_PRESS && buttonsDown_++ > 0) return;
    if (action == GLFW_RELEASE && (buttonsDown_ == 0 || --buttonsDown_ > 0)) return;
    if (action == GLFW_PRESS) {
        pressed_ = {};
        pressed_.button = buttonFrom(button);
        pressed_.shift = (modifiers & GLFW_MOD_SHIFT) != 0;
        pressed_.control = (modifiers & GLFW_MOD_CONTROL) != 0;
    }
    guarded([&] {
        if (action == GLFW_PRESS)
            viewer_.pointerDown(pointer());
        else
            viewer_.pointerUp(pointer());
    });
}

void App::onMove(double x, double y) {
    cursor_ = {x, y};
    guarded([&] { viewer_.pointerMove(pointer()); });
    if (viewer_.showsSunHours()) viewer_.invalidate(); // the legend reads the cursor
}

void App::onDrop(const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    guarded([&] {
        say("Loading " + name);
        draw();
        show(path, load_(path, ""));
        glfwSetWindowTitle(window_.handle(), (name + " - edgeshade").c_str());
        say("");
    });
}

std::string App::figures() const {
    const viewer::FrameStats stats = viewer_.stats();
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << stats.frameMs << " ms per frame, " << stats.planMs
         << " of which planning\n";
    if (const auto& stages = stats.stageMs)
        text << stages->ambient << " ambient, " << stages->map << " map, " << stages->silhouette
             << " silhouette, " << stages->rasterise << " rasterising, " << stages->lit << " lit\n";
    text << stats.triangles << " triangles, " << stats.edges << " edges, " << stats.silhouettes
         << " of them silhouettes\n"
         << static_cast<double>(stats.shadowBytes) / (1 << 20) << " MB of shadow data, "
         << static_cast<double>(stats.mapBytes) / (1 << 20) << " MB of shadow maps, "
         << static_cast<double>(stats.primitiveMapBytes) / (1 << 20) << " MB of primitive maps\n"
         << window_.capabilities().renderer;
    return text.str();
}

} // namespace edgeshade::desktop

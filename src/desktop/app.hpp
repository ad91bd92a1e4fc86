#pragma once

#include "src/desktop/window.hpp"
#include "src/viewer/overlay_pass.hpp"
#include "src/viewer/viewer.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace edgeshade::desktop {

/// The viewer in a window: events in, pictures out, text over them.
class App {
  public:
    /// Reads a file in one of its variants of materials; an empty name selects its own materials.
    using Load =
        std::function<LoadedScene(const std::filesystem::path&, const std::string& variant)>;

    /// `load` reads files dropped onto the window, and other variants. Throws Error(unavailable).
    App(const WindowRequest& request, const viewer::ViewerSettings& settings, Load load);
    App(const App&) = delete;
    App& operator=(const App&) = delete;

    viewer::Viewer& viewer() { return viewer_; }
    const gl::Capabilities& capabilities() const { return window_.capabilities(); }

    /// Shows a scene loaded from `path`, and frames it. Throws Error; the previous scene then
    /// stays.
    void show(const std::filesystem::path& path, LoadedScene loaded);

    /// Runs until the window is closed. Waits for events while there is nothing to draw.
    void run();

    /// Draws until soft shadows and smoothing have converged and hours of sunlight are counted.
    /// Throws Error.
    void settle();

    /// Draws the picture without handles and text, and writes it as a PNG. Throws Error.
    void saveScreenshot(const std::filesystem::path& path);

  private:
    void connect();
    void fitToWindow();
    /// Returns whether there was something to draw.
    bool draw();
    void say(const std::string& message);
    template <class Action>
    void guarded(Action action);

    void onKey(int key, int action, int modifiers);
    void onCharacter(unsigned character);
    void onButton(int button, int action, int modifiers);
    void onMove(double x, double y);
    void onDrop(const std::filesystem::path& path);
    void showNextVariant();
    void showNextCamera();
    viewer::Pointer pointer() const; ///< at the cursor, with the buttons of pressed_
    std::string figures() const;

    Window window_;
    viewer::Viewer viewer_;
    viewer::OverlayPass overlay_;
    Load load_;
    std::filesystem::path path_; ///< the scene on show
    /// The scene's variants of materials, after an empty name for its own materials; variant_
    /// selects one.
    std::vector<std::string> variants_ = {""};
    std::size_t variant_ = 0;
    std::size_t nextCamera_ = 0; ///< index of the file's next camera
    int width_ = 1;              ///< the picture's size in pixels
    int height_ = 1;
    float scale_ = 1.0f; ///< the display's content scale
    /// In window units, at the time of the current event. GLFW itself would report the cursor's
    /// present place, which differs after a slow frame.
    glm::dvec2 cursor_{0.0};
    int buttonsDown_ = 0;
    viewer::Pointer pressed_; ///< state when the first button went down
    bool showsHelp_ = false;
    bool showsFigures_ = false;
    std::string message_; ///< a line at the bottom; empty: no line
};

} // namespace edgeshade::desktop

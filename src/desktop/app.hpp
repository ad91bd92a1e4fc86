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
    /// Reads a file in one of its variants of materials; an empty name: its own materials.
    using Load =
        std::function<LoadedScene(const std::filesystem::path&, const std::string& variant)>;

    /// `load` is for what is dropped onto the window and for other variants. Throws
    /// Error(unavailable).
    App(const WindowRequest& request, const viewer::ViewerSettings& settings, Load load);
    App(const App&) = delete;
    App& operator=(const App&) = delete;

    viewer::Viewer& viewer() { return viewer_; }
    const gl::Capabilities& capabilities() const { return window_.capabilities(); }

    /// Shows what was loaded from there, and frames it. Throws Error; what was on show stays then.
    void show(const std::filesystem::path& path, LoadedScene loaded);

    /// Until the window is closed. Waits for events where nothing is to be drawn.
    void run();

    /// Draws until soft shadows are as soft as they get, the picture as smooth, and hours of sun
    /// are counted. Throws Error.
    void settle();

    /// Draws the picture without handles and text and writes it as a PNG. Throws Error.
    void saveScreenshot(const std::filesystem::path& path);

  private:
    void connect();
    void fitToWindow();
    /// Whether there was something to draw.
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
    viewer::Pointer pointer() const; ///< where the cursor is, with what pressed_ says
    std::string figures() const;

    Window window_;
    viewer::Viewer viewer_;
    viewer::OverlayPass overlay_;
    Load load_;
    std::filesystem::path path_; ///< of the scene on show
    /// Its variants of materials behind an empty name, which is its own materials; which is shown.
    std::vector<std::string> variants_ = {""};
    std::size_t variant_ = 0;
    std::size_t nextCamera_ = 0; ///< of the file's
    int width_ = 1;              ///< of the picture, pixels
    int height_ = 1;
    float scale_ = 1.0f; ///< of the display's contents
    /// In window units, as of the event that is looked at: asked for, GLFW says where it is by now,
    /// which during a slow frame is elsewhere.
    glm::dvec2 cursor_{0.0};
    int buttonsDown_ = 0;
    viewer::Pointer pressed_; ///< as the first button went down
    bool showsHelp_ = false;
    bool showsFigures_ = false;
    std::string message_; ///< a line at the bottom; empty: none
};

} // namespace edgeshade::desktop

#pragma once

#include <memory>

namespace edgeshade::gl {

/// Opens a display of EGL and keeps it open. A display belongs to the whole process, so it closes
/// with its last user; one that the application had opened itself stays open. Null if it can't be
/// opened.
///
/// `display`: an EGLDisplay. From any thread.
std::shared_ptr<void> openDisplay(void* display);

/// A thread's current context with its display and surfaces.
class CurrentContext {
  public:
    /// Notes the one that is current now, if any.
    CurrentContext();
    /// Makes it current again, or nothing if there was nothing or it no longer exists. `display`:
    /// of the context that is current now.
    void restore(void* display) const;
    void* context() const { return context_; } ///< an EGLContext; null: none

  private:
    void* display_;
    void* draw_;
    void* read_;
    void* context_;
};

} // namespace edgeshade::gl

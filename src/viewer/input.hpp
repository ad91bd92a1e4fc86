#pragma once

namespace edgeshade::viewer {

enum class PointerButton { primary, middle, secondary };

/// A finger, pen or mouse; x and y in picture pixels, rows down. Fingers have ids of their own, so
/// that two of them pinch.
struct Pointer {
    int id = 0;
    double x = 0.0;
    double y = 0.0;
    PointerButton button = PointerButton::primary;
    bool shift = false;
    bool control = false;
};

/// What keys do, whatever keys a platform gives them.
enum class Command {
    orbitLeft,
    orbitRight,
    orbitUp,
    orbitDown,
    panLeft,
    panRight,
    panUp,
    panDown,
    zoomIn,
    zoomOut,
    fit,
    reset,
    lightLeft,
    lightRight,
    lightUp,
    lightDown,
    lightNearer,
    lightFarther,
    nextLight,
    addLight,
    removeLight,
    toggleSun,
    nextShadows, ///< of the whole picture, or of the right side of a split
    toggleSplit,
    splitLeft,
    splitRight,
    toggleDebug,
    toggleGround, ///< one that catches shadow
    toggleLights,
    nextAnimation, ///< of the file
    togglePlaying,
    slower,
    faster,
    toggleDay,   ///< of a sun by place and time; so are the next five
    toggleHours, ///< of sun
    earlier,
    later,
    dayEarlier,
    dayLater,
};

} // namespace edgeshade::viewer

#pragma once

#include <glm/glm.hpp>

namespace edgeshade::viewer {

enum class PointerButton { primary, middle, secondary };

/// A finger, pen or mouse; x and y in picture pixels, y down. Each finger has its own id, so that
/// two of them can pinch.
struct Pointer {
    int id = 0;
    double x = 0.0;
    double y = 0.0;
    PointerButton button = PointerButton::primary;
    bool shift = false;
    bool control = false;

    glm::dvec2 place() const { return {x, y}; }
};

/// Actions of keys, whichever keys a platform assigns to them.
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
    nextShadows, ///< for the whole picture, or for the right side of a split
    toggleSplit,
    splitLeft,
    splitRight,
    toggleDebug,
    toggleGround, ///< a ground that catches shadow
    toggleLights,
    nextAnimation, ///< of the file
    togglePlaying,
    slower,
    faster,
    toggleDay,   ///< for a sun by place and time, as are the next five
    toggleHours, ///< hours of sunlight
    earlier,
    later,
    dayEarlier,
    dayLater,
    sectionX, ///< cut open along an axis through the middle, or whole again; as the next four
    sectionY,
    sectionZ,
    sectionFree,    ///< a plane that faces the eye
    sectionBox,     ///< six planes around the middle
    sectionFlip,    ///< keep the other side of a single plane
    sectionShadows, ///< what is cut away casts, or not
    sectionOff,
};

} // namespace edgeshade::viewer

// The interface to JavaScript of counting hours of sun.

#include "web/hours/hours_counter.hpp"

#include <emscripten/bind.h>

EMSCRIPTEN_BINDINGS(hours) {
    using edgeshade::web::HoursCounter;
    emscripten::class_<HoursCounter>("HoursCounter")
        .constructor<>()
        .function("setDays", &HoursCounter::setDays)
        .function("setTimes", &HoursCounter::setTimes)
        .function("addTexels", &HoursCounter::addTexels)
        .function("addMesh", &HoursCounter::addMesh)
        .function("setAlpha", &HoursCounter::setAlpha)
        .function("addClipping", &HoursCounter::addClipping)
        .function("place", &HoursCounter::place)
        .function("measureVertices", &HoursCounter::measureVertices)
        .function("measureCells", &HoursCounter::measureCells)
        .function("advance", &HoursCounter::advance)
        .function("share", &HoursCounter::share)
        .function("problem", &HoursCounter::problem)
        .function("positions", &HoursCounter::positions)
        .function("counts", &HoursCounter::counts)
        .function("points", &HoursCounter::points)
        .function("normals", &HoursCounter::normals)
        .function("areas", &HoursCounter::areas)
        .function("states", &HoursCounter::states)
        .function("faceCounts", &HoursCounter::faceCounts)
        .function("cornerCounts", &HoursCounter::cornerCounts)
        .function("corners", &HoursCounter::corners);
}

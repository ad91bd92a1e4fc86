#include "web/commands.hpp"

#include "preprocess/base/error.hpp"

#include <string>
#include <utility>

namespace edgeshade::web {
namespace {

using viewer::Command;

constexpr std::pair<std::string_view, Command> commands[] = {
    {"orbitLeft", Command::orbitLeft},
    {"orbitRight", Command::orbitRight},
    {"orbitUp", Command::orbitUp},
    {"orbitDown", Command::orbitDown},
    {"panLeft", Command::panLeft},
    {"panRight", Command::panRight},
    {"panUp", Command::panUp},
    {"panDown", Command::panDown},
    {"zoomIn", Command::zoomIn},
    {"zoomOut", Command::zoomOut},
    {"fit", Command::fit},
    {"reset", Command::reset},
    {"lightLeft", Command::lightLeft},
    {"lightRight", Command::lightRight},
    {"lightUp", Command::lightUp},
    {"lightDown", Command::lightDown},
    {"lightNearer", Command::lightNearer},
    {"lightFarther", Command::lightFarther},
    {"nextLight", Command::nextLight},
    {"addLight", Command::addLight},
    {"removeLight", Command::removeLight},
    {"toggleSun", Command::toggleSun},
    {"nextShadows", Command::nextShadows},
    {"toggleSplit", Command::toggleSplit},
    {"splitLeft", Command::splitLeft},
    {"splitRight", Command::splitRight},
    {"toggleDebug", Command::toggleDebug},
    {"toggleGround", Command::toggleGround},
    {"toggleLights", Command::toggleLights},
    {"nextAnimation", Command::nextAnimation},
    {"togglePlaying", Command::togglePlaying},
    {"slower", Command::slower},
    {"faster", Command::faster},
    {"toggleDay", Command::toggleDay},
    {"toggleHours", Command::toggleHours},
    {"earlier", Command::earlier},
    {"later", Command::later},
    {"dayEarlier", Command::dayEarlier},
    {"dayLater", Command::dayLater},
    {"sectionX", Command::sectionX},
    {"sectionY", Command::sectionY},
    {"sectionZ", Command::sectionZ},
    {"sectionFree", Command::sectionFree},
    {"sectionBox", Command::sectionBox},
    {"sectionFlip", Command::sectionFlip},
    {"sectionShadows", Command::sectionShadows},
    {"sectionOff", Command::sectionOff},
};

} // namespace

Command commandOf(std::string_view name) {
    for (const auto& [known, command] : commands)
        if (known == name) return command;
    throw Error(ExitStatus::usage, "There is no command '" + std::string(name) + "'.");
}

} // namespace edgeshade::web

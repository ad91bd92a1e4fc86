#include "src/desktop/keys.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace edgeshade::desktop {

using viewer::Command;

std::optional<Command> commandForCharacter(unsigned character) {
    switch (character) {
    case '+':
    case '=':
        return Command::zoomIn;
    case '-':
        return Command::zoomOut;
    case 'f':
        return Command::fit;
    case 'r':
        return Command::reset;
    case 'l':
        return Command::nextLight;
    case 'n':
        return Command::addLight;
    case 'u':
        return Command::toggleSun;
    case 't':
        return Command::toggleLights;
    case 'm':
        return Command::nextShadows;
    case 's':
        return Command::toggleSplit;
    case ',':
        return Command::splitLeft;
    case '.':
        return Command::splitRight;
    case 'v':
        return Command::toggleDebug;
    case ' ':
        return Command::togglePlaying;
    case '[':
        return Command::slower;
    case ']':
        return Command::faster;
    default:
        return std::nullopt;
    }
}

std::optional<Command> commandForKey(int key, int modifiers) {
    const bool light = (modifiers & GLFW_MOD_CONTROL) != 0;
    const bool pan = (modifiers & GLFW_MOD_SHIFT) != 0;
    switch (key) {
    case GLFW_KEY_LEFT:
        return light ? Command::lightLeft : pan ? Command::panLeft : Command::orbitLeft;
    case GLFW_KEY_RIGHT:
        return light ? Command::lightRight : pan ? Command::panRight : Command::orbitRight;
    case GLFW_KEY_UP:
        return light ? Command::lightUp : pan ? Command::panUp : Command::orbitUp;
    case GLFW_KEY_DOWN:
        return light ? Command::lightDown : pan ? Command::panDown : Command::orbitDown;
    case GLFW_KEY_PAGE_UP:
        return light ? Command::lightFarther : Command::zoomIn;
    case GLFW_KEY_PAGE_DOWN:
        return light ? Command::lightNearer : Command::zoomOut;
    case GLFW_KEY_HOME:
        return Command::fit;
    case GLFW_KEY_DELETE:
    case GLFW_KEY_BACKSPACE:
        return Command::removeLight;
    default:
        return std::nullopt;
    }
}

std::string helpText() {
    return "drag            orbit            arrows\n"
           "right drag      pan              Shift+arrows\n"
           "wheel           zoom             + -, Page Up, Page Down\n"
           "drag a handle   move a light     Ctrl+arrows, Ctrl+Page Up, Page Down\n"
           "Ctrl+drag       move the chosen light from anywhere\n"
           "\n"
           "F, Home   see the whole scene    R   camera and lights as at first\n"
           "L  next light     N  new light     Delete  remove it     U  point or sun\n"
           "T  hide or show the handles of lights\n"
           "M  next kind of shadows            V  show the volumes\n"
           "S  two kinds side by side; drag the line between them, or , and .\n"
           "Space  play or stop     [ ]  slower, faster\n"
           "I  figures     P, F12  save the picture     H, ?  this help     Esc  end\n"
           "Drop a .gltf or .glb file here to see it.";
}

} // namespace edgeshade::desktop

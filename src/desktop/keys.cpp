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
    case 'g':
        return Command::toggleGround;
    case ' ':
        return Command::togglePlaying;
    case 'x':
        return Command::nextAnimation;
    case '[':
        return Command::slower;
    case ']':
        return Command::faster;
    case 'j':
        return Command::toggleDay;
    case 'y':
        return Command::toggleHours;
    case '9':
        return Command::earlier;
    case '0':
        return Command::later;
    case '7':
        return Command::dayEarlier;
    case '8':
        return Command::dayLater;
    case '1':
        return Command::sectionX;
    case '2':
        return Command::sectionY;
    case '3':
        return Command::sectionZ;
    case '4':
        return Command::sectionFree;
    case '5':
        return Command::sectionBox;
    case '6':
        return Command::sectionFlip;
    case 'o':
        return Command::sectionShadows;
    case 'z':
        return Command::sectionOff;
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
    return "drag, arrows\torbit\n"
           "right drag, Shift+arrows\tpan\n"
           "wheel, + -, Page Up, Page Down\tzoom\n"
           "drag a handle, Ctrl+drag, Ctrl+arrows\tmove a light\n"
           "Ctrl+Page Up, Page Down\tmove it farther, nearer\n"
           "L / N / Delete\tnext / new / remove light\n"
           "U\tswitch between point light and sun\n"
           "T\tshow or hide the lights' handles\n"
           "F, Home / R\tfit the scene / reset the view\n"
           "M\tshadows: auto, volumes, primitive map, map, none\n"
           "S / , .\tcompare two methods / move the divider\n"
           "V\tshow the shadow volumes\n"
           "G\tshow or hide the ground\n"
           "Space / [ ] / X\tplay / slower, faster / next animation\n"
           "J\tplay the sun's day (--place)\n"
           "Y\tshow the hours of sun of that day\n"
           "9 0 / 7 8\tten minutes / a day earlier, later\n"
           "1 2 3 / 4 / 5\tcut open along X, Y, Z / facing you / a box\n"
           "6 / O / Z\tflip the cut / what is cut away casts or not / whole\n"
           "K\tnext variant of the materials\n"
           "C\tnext of the file's cameras\n"
           "I\tstatistics\n"
           "P, F12\tsave the picture\n"
           "H, ? / Esc\tthis help / quit\n"
           "drop a .gltf or .glb file\topen it";
}

} // namespace edgeshade::desktop

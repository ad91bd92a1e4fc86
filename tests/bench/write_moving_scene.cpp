// Writes a scene that deforms, authored in code: a walking figure or a morphing ball.
//
//     write_moving_scene figure|ball FILE.glb SIDES RINGS
//
// The figure has 12 x SIDES x RINGS triangles, the ball 2 x SIDES x RINGS.
#include "tests/support/moving_scenes.hpp"

#include <cstdio>
#include <cstdlib>

int main(int count, char** words) {
    using namespace edgeshade;
    const std::string kind = count == 5 ? words[1] : "";
    const int sides = count == 5 ? std::atoi(words[3]) : 0;
    const int rings = count == 5 ? std::atoi(words[4]) : 0;
    if ((kind != "figure" && kind != "ball") || sides < 3 || rings < 2) {
        std::fputs("write_moving_scene figure|ball FILE.glb SIDES RINGS\n", stderr);
        return 1;
    }
    const test::GltfBuilder gltf =
        kind == "figure" ? test::walkingFigure(sides, rings) : test::morphingBall(sides, rings);
    writeFile(words[2], gltf.glb());
    return 0;
}

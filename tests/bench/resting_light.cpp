// resting_light SCENE: frames of a viewer whose light is dragged for a second and then left alone,
// printed as JSON: {"frames": [{"at": s, "ms": .., "method": ".."}, ...]}. The clock advances by
// each frame's own time; each frame is redrawn, as if the user were orbiting.
#include "src/gl/headless_context.hpp"
#include "src/viewer/viewer.hpp"

#include "preprocess/base/stopwatch.hpp"

#include <iostream>

using namespace edgeshade;
using Json = nlohmann::ordered_json;

namespace {

constexpr double dragged = 1.0, watched = 6.0; // seconds

} // namespace

int main(int count, char** words) {
    if (count != 2) {
        std::cerr << "resting_light SCENE\n";
        return 2;
    }
    const gl::HeadlessContext context({960, 540, 0, gl::Limits::device});
    viewer::Viewer viewer(context.capabilities());
    viewer.resize(960, 540, 1.0);
    viewer.show(loadScene(words[1], std::nullopt));
    viewer.change({{"show_lights", false}});
    static_cast<void>(viewer.stats()); // from now on frames are timed until they are finished
    Json frames = Json::array();
    double now = 0.0;
    while (now < watched) {
        if (now < dragged) viewer.change({{"lights", {{0.6 + 0.2 * now, 1.0, 0.35, 0.0}}}});
        viewer.invalidate();
        Stopwatch watch;
        viewer.frame(now);
        const double seconds = watch.lap();
        frames.push_back(
            {{"at", now}, {"ms", 1e3 * seconds}, {"method", viewer.stats().lights[0].method}});
        now += seconds;
    }
    std::cout << Json{{"frames", frames}}.dump(1) << std::endl;
}

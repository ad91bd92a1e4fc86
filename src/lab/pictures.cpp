#include "src/lab/pictures.hpp"

#include <utility>

namespace edgeshade::lab {

void Pictures::drawUnshadowed(
    FrameView frame, const std::function<std::vector<std::uint8_t>(const FrameView&)>& draw) {
    for (FrameLight& of : frame.lights)
        of.drawn = false;
    ambient = draw(frame);
    unshadowed.clear();
    frame.lights.front().drawn = true;
    for (std::size_t i = 0; i < frame.lights.size(); ++i) {
        frame.lights[i].drawn = true;
        unshadowed.push_back(draw(frame));
        frame.lights[i].drawn = i == 0;
    }
}

} // namespace edgeshade::lab

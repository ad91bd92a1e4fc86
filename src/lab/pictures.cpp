#include "src/lab/pictures.hpp"

#include <utility>

namespace edgeshade::lab {

void Pictures::drawUnshadowed(
    FrameView frame, const std::function<std::vector<std::uint8_t>(const FrameView&)>& draw) {
    frame.drawnLights = 0;
    ambient = draw(frame);
    unshadowed.clear();
    for (std::size_t i = 0; i < frame.lights.size(); ++i) {
        frame.drawnLights = 1u | 1u << i;
        unshadowed.push_back(draw(frame));
    }
}

} // namespace edgeshade::lab

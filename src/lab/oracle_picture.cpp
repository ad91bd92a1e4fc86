#include "src/lab/oracle_picture.hpp"

#include <map>

namespace edgeshade::lab {

void OraclePicture::follow(const std::vector<Answer>& answers) {
    const bool first = colors_.empty();
    colors_.resize(answers.size());
    lit_.resize(answers.size());
    std::map<LightSet, std::vector<std::size_t>> wanted; // pixels by the lights they have
    for (std::size_t i = 0; i < answers.size(); ++i)
        if (first || lit_[i] != answers[i].lit) wanted[answers[i].lit].push_back(i);
    std::vector<std::uint8_t> all;
    if (litAs_ && !wanted.empty()) all = litAs_(answers);
    for (const auto& [lights, pixels] : wanted) {
        const std::vector<std::uint8_t> own =
            litAs_ ? std::vector<std::uint8_t>() : unshadowed_(lights);
        const std::vector<std::uint8_t>& picture = litAs_ ? all : own;
        for (const std::size_t i : pixels) {
            for (std::size_t c = 0; c < 3; ++c)
                colors_[i][c] = picture[4 * i + c];
            lit_[i] = lights;
        }
    }
}

} // namespace edgeshade::lab

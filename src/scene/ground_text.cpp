#include "src/scene/ground_text.hpp"

#include "src/scene/color_text.hpp"

namespace edgeshade {

std::optional<GroundChoice> groundFromText(const std::string& text) {
    if (text == "off") return GroundChoice();
    if (text == "catcher") return GroundChoice(Ground{});
    if (const auto color = linearFromText(text))
        return GroundChoice(Ground{GroundMaterial::surface, *color});
    return std::nullopt;
}

std::string textOf(const GroundChoice& ground) {
    if (!ground) return "off";
    return ground->material == GroundMaterial::catcher ? "catcher" : textFromLinear(ground->color);
}

} // namespace edgeshade

#include "preprocess/reading/node_parts.hpp"

#include "preprocess/scene/node_transform.hpp"

namespace edgeshade {

std::string nameOf(const JsonField& object) {
    const auto name = object.find("name");
    return name && name->value().is_string() ? name->text() : "";
}

double numberIn(const JsonField& number, double least, double most) {
    const double value = number.number();
    if (!(least <= value && value <= most))
        number.fail(" is " + number.value().dump() + ", but must be from " +
                    JsonField::Json(least).dump() + " to " + JsonField::Json(most).dump());
    return value;
}

glm::dvec3 placeOf(const JsonField& reference, const glm::dmat4& worldFromNode) {
    const auto place = originOf(worldFromNode);
    if (!place) reference.fail(" is placed farther than 1e12 from the origin");
    return *place;
}

glm::dmat4 rigidPlaceOf(const JsonField& reference, const glm::dmat4& worldFromNode,
                        const glm::dmat4& unflattened) {
    const auto turn = turnOf(worldFromNode, unflattened);
    if (!turn) reference.fail(" is placed by a node whose transform is degenerate");
    glm::dmat4 rigid(*turn);
    rigid[3] = glm::dvec4(placeOf(reference, worldFromNode), 1.0);
    return rigid;
}

} // namespace edgeshade

#include "src/rivals/published/volume_program.hpp"

#include "shaders_es2.hpp"

namespace edgeshade {
namespace {

std::vector<std::string> commonDefines(MultiplicityMethod method, SidesLayout layout,
                                       const std::vector<std::string>& extra) {
    std::vector<std::string> defines = extra;
    if (method == MultiplicityMethod::threeEdge) defines.push_back("MULTIPLICITY_THREE_EDGE");
    if (method == MultiplicityMethod::singleEdge) defines.push_back("MULTIPLICITY_SINGLE_EDGE");
    if (layout != SidesLayout::notInstanced) defines.push_back("INSTANCED");
    return defines;
}

std::vector<std::string> withCorner(SidesLayout layout, std::vector<std::string> attributes,
                                    const std::vector<std::string>& extra) {
    if (layout != SidesLayout::notInstanced) attributes.insert(attributes.begin(), "a_corner");
    attributes.insert(attributes.end(), extra.begin(), extra.end());
    return attributes;
}

} // namespace

gl::Program makeSidesProgram(MultiplicityMethod method, int maxMultiplicity, SidesLayout layout,
                             const std::vector<std::string>& extraDefines,
                             const std::vector<std::string>& extraAttributes) {
    std::vector<std::string> defines = commonDefines(method, layout, extraDefines);
    defines.push_back("MAX_MULTIPLICITY " + std::to_string(maxMultiplicity));
    if (layout == SidesLayout::multiDraw) defines.push_back("SIDE_IS_UNIFORM");
    std::vector<std::string> attributes = {"a_edgeA", "a_edgeB"};
    for (int i = 0; i < maxMultiplicity; ++i)
        attributes.push_back("a_opposite" + std::to_string(i));
    return {shaders::sides_vert, shaders::sides_frag, defines,
            withCorner(layout, std::move(attributes), extraAttributes)};
}

gl::Program makeCapsProgram(MultiplicityMethod method, SidesLayout layout,
                            const CapsVariant& variant,
                            const std::vector<std::string>& extraDefines,
                            const std::vector<std::string>& extraAttributes) {
    std::vector<std::string> defines = commonDefines(method, layout, extraDefines);
    if (variant.nearDiscard) defines.push_back("NEAR_DISCARD");
    if (variant.alphaTest) defines.push_back("ALPHA_TEST");
    std::vector<std::string> attributes = {"a_capA", "a_capB", "a_capC"};
    if (variant.alphaTest)
        attributes.insert(attributes.end(), {"a_alphaCornerA", "a_alphaCornerB", "a_alphaCornerC"});
    return {shaders::caps_vert, shaders::caps_frag, defines,
            withCorner(layout, std::move(attributes), extraAttributes)};
}

} // namespace edgeshade

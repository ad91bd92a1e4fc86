#include "src/render/drawing/whole_picture.hpp"

#include "shaders_es2.hpp"
#include "src/render/drawing/attributes.hpp"

#include <array>

namespace edgeshade {

WholePicture::WholePicture() : WholePicture(shaders::fill_frag) {}

WholePicture::WholePicture(const char* fragmentSource, const std::vector<std::string>& defines)
    : program_(shaders::fill_vert, fragmentSource, defines, {"a_corner"}) {
    constexpr std::array<float, 6> corners = {-1.0f, -1.0f, 3.0f, -1.0f, -1.0f, 3.0f};
    triangle_ = gl::vertexBuffer<float>(corners);
}

const gl::Program& WholePicture::use() const {
    program_.use();
    return program_;
}

void WholePicture::draw() const {
    program_.use();
    AttributeBinding binding(nullptr);
    binding.add(triangle_, 2, GL_FLOAT, false, 2 * sizeof(float), 0, false);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace edgeshade

#include "tests/engine/masks_in_a_host.hpp"

#include <algorithm>
#include <EGL/egl.h>
#include <GLES2/gl2.h>
#include <string_view>

namespace edgeshade::test {

void* eglLookUp(const char* name) {
    return reinterpret_cast<void*>(eglGetProcAddress(name));
}

void* lookUpWithoutArrays(const char* name) {
    return std::string_view(name).find("VertexArrays") != std::string_view::npos ? nullptr
                                                                                 : eglLookUp(name);
}

Matrix16 numbersOf(const glm::dmat4& matrix) {
    Matrix16 numbers{};
    std::copy_n(&matrix[0][0], 16, numbers.begin());
    return numbers;
}

MaskMesh meshOf(const Geometry& geometry) {
    return {{&geometry.positions[0].x, 3 * geometry.positions.size()}, geometry.indices};
}

MaskView viewOf(const Camera& camera) {
    const Frustum frustum = frustumOf(camera, static_cast<double>(hostWidth) / hostHeight);
    return {.viewFromWorld = numbersOf(frustum.viewFromWorld),
            .clipFromView = numbersOf(clipFromView(frustum, 0.1)),
            .width = hostWidth,
            .height = hostHeight};
}

MaskLight hostLight(const Light& light) {
    const glm::dvec4& at = light.position;
    MaskLight host;
    host.range = light.range;
    if (light.extent) host.radius = light.extent->radius;
    if (at.w == 0.0) {
        host.direction = {-at.x, -at.y, -at.z};
        return host;
    }
    host.kind = MaskLight::Kind::point;
    host.position = {at.x, at.y, at.z};
    if (light.cone) {
        host.kind = MaskLight::Kind::spot;
        host.direction = {light.cone->axis.x, light.cone->axis.y, light.cone->axis.z};
        host.outerAngle = light.cone->outer;
    }
    return host;
}

Light spot() {
    Light light = pointLight({0.3, 4, 0.7});
    light.cone = Cone{glm::normalize(glm::dvec3(-0.1, -1, 0.1)), 0.0, 0.5};
    return light;
}

const Geometry& geometryOf(const Scene& scene) {
    return *scene.batches.front().geometry;
}

std::vector<std::uint8_t> readTexture(unsigned texture) {
    GLuint framebuffer = 0;
    GLint before = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &before);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    std::vector<std::uint8_t> rgba(std::size_t{4} * hostWidth * hostHeight);
    glReadPixels(0, 0, hostWidth, hostHeight, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(before));
    glDeleteFramebuffers(1, &framebuffer);
    return rgba;
}

std::vector<std::uint8_t> readMask(const ShadowMasks& masks, std::size_t light) {
    const std::vector<std::uint8_t> rgba = readTexture(masks.textures()[light / 4]);
    std::vector<std::uint8_t> mask;
    for (int y = hostHeight - 1; y >= 0; --y)
        for (int x = 0; x < hostWidth; ++x)
            mask.push_back(
                rgba[4 * (static_cast<std::size_t>(y) * hostWidth + static_cast<std::size_t>(x)) +
                     light % 4]);
    return mask;
}

std::vector<std::uint8_t> renderedMask(const Scene& scene, const Camera& camera, const Light& light,
                                       const SceneImages& images, bool castMasked) {
    TestView view{camera, {light}, hostWidth, hostHeight, true};
    view.images = images;
    const std::vector<std::uint8_t> rgba = drawScene(scene, view, {}, castMasked);
    std::vector<std::uint8_t> mask;
    for (std::size_t i = 0; i < rgba.size(); i += 4)
        mask.push_back(rgba[i + 3] == 0 ? 255 : rgba[i]);
    return mask;
}

} // namespace edgeshade::test

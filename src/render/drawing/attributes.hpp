#pragma once

#include "src/gl/instancing.hpp"
#include "src/gl/objects.hpp"

#include <cstddef>
#include <GLES2/gl2.h>

namespace edgeshade {

/// Enables vertex attributes for its lifetime, and then restores the GL's state.
class AttributeBinding {
  public:
    /// `instancing` may be null if nothing is instanced.
    explicit AttributeBinding(const gl::Instancing* instancing) : instancing_(instancing) {}
    ~AttributeBinding() {
        for (GLuint i = 0; i < count_; ++i) {
            if (instancing_) instancing_->divisor(i, 0);
            glDisableVertexAttribArray(i);
        }
        glBindBuffer(GL_ARRAY_BUFFER, 0);
    }
    AttributeBinding(const AttributeBinding&) = delete;
    AttributeBinding& operator=(const AttributeBinding&) = delete;

    /// Makes the next attribute location read `components` values of GL type `type`.
    void add(const gl::Buffer& buffer, int components, GLenum type, bool normalized,
             std::size_t stride, std::size_t offset, bool perInstance) {
        glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
        glEnableVertexAttribArray(count_);
        glVertexAttribPointer(count_, components, type, normalized ? GL_TRUE : GL_FALSE,
                              static_cast<GLsizei>(stride), reinterpret_cast<const void*>(offset));
        if (instancing_) instancing_->divisor(count_, perInstance ? 1 : 0);
        ++count_;
    }

    /// Makes the next `vectors` locations read consecutive vec4s of records from byte `offset` on.
    void addRecords(const gl::Buffer& buffer, std::size_t vectors, std::size_t offset,
                    bool perInstance) {
        const std::size_t size = 4 * sizeof(float);
        for (std::size_t i = 0; i < vectors; ++i)
            add(buffer, 4, GL_FLOAT, false, vectors * size, offset + i * size, perInstance);
    }

  private:
    const gl::Instancing* instancing_;
    GLuint count_ = 0;
};

/// Draws triangles by 16-bit indices. Returns vertex runs.
inline std::size_t drawIndexed(const gl::Buffer& indices, int count) {
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.name());
    glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_SHORT, nullptr);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    return static_cast<std::size_t>(count);
}

} // namespace edgeshade

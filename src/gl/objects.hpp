#pragma once

// Thin owners of GL objects: one C++ object owns one GL object and deletes it. They need a current
// context throughout their life, and know nothing of shadows.

#include "preprocess/scene/sampler.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace edgeshade::gl {

using Name = unsigned int; ///< name of a GL object; 0: none

/// Owns a name and deletes it once, by `Deleter`.
template <void (*Deleter)(Name)>
class Owned {
  public:
    Owned() = default;
    explicit Owned(Name name) : name_(name) {}
    ~Owned() { reset(); }
    Owned(Owned&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Owned& operator=(Owned&& other) noexcept {
        if (this != &other) {
            reset();
            name_ = std::exchange(other.name_, 0);
        }
        return *this;
    }
    Name name() const { return name_; }

  private:
    void reset() {
        if (name_ != 0) Deleter(name_);
    }
    Name name_ = 0;
};

void deleteBuffer(Name);
void deleteTexture(Name);
void deleteShader(Name);
void deleteProgram(Name);
void deleteFramebuffer(Name);
void deleteRenderbuffer(Name);

using Texture = Owned<deleteTexture>;
using Framebuffer = Owned<deleteFramebuffer>;
using Renderbuffer = Owned<deleteRenderbuffer>;
using ShaderObject = Owned<deleteShader>;
using ProgramObject = Owned<deleteProgram>;

/// An immutable vertex or index buffer.
class Buffer {
  public:
    enum class Kind { vertices, indices };

    Buffer() = default;
    /// Uploads `bytes`. Throws Error(unavailable) if the GL is out of memory.
    Buffer(Kind kind, std::span<const std::byte> bytes);

    Name name() const { return object_.name(); }
    std::size_t size() const { return size_; } ///< bytes

  private:
    Owned<deleteBuffer> object_;
    std::size_t size_ = 0;
};

template <class T>
Buffer vertexBuffer(std::span<const T> values) {
    return Buffer(Buffer::Kind::vertices, std::as_bytes(values));
}

/// The value of the GL's state of that name, which has one number.
int integerOf(unsigned name);

/// The framebuffer that is bound; 0: the window's.
Name boundFramebuffer();

/// A texture without an image yet, sampled without filtering and clamped at its edges; of any size.
/// Left bound to the active unit's GL_TEXTURE_2D.
Texture nearestTexture();

/// A texture of 8-bit RGBA texels, rows top to bottom, with mipmaps if its sampler uses them. Width
/// and height must be powers of two.
Texture makeTexture(std::span<const std::uint8_t> rgba, int width, int height,
                    const Sampler& sampler);

/// The error of a GL that notices the loss of its context (GL_KHR_robustness, ES 3.2).
inline constexpr unsigned contextLost = 0x0507;

/// Throws Error(unavailable) if the GL has recorded an error; `doing` says what it was doing.
void requireNoError(const char* doing);
/// As above for an error that was already read.
void requireNoError(unsigned error, const char* doing);

} // namespace edgeshade::gl

#pragma once

#include "preprocess/base/file_io.hpp"

#include <concepts>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace edgeshade::web {

/// Data passed as bytes between two instances of this same program: plain values in their memory
/// layout. Any other class has one function that lists its fields for both directions:
///
///     template <class Archive> void transfer(Archive& archive, Maybe<Class> auto& value)

/// T or const T, so that one list of fields serves both writing and reading.
template <class A, class T>
concept Maybe = std::same_as<std::remove_const_t<A>, T>;

/// Bytes from which on an array may lie apart from the others.
constexpr std::size_t leastApart = 1 << 16;

/// A vector of plain values that lies apart: it is empty until its bytes are to be filled.
struct VectorApart {
    void* vector = nullptr;
    std::size_t count = 0;
    std::span<std::uint8_t> (*sized)(void* vector, std::size_t count) = nullptr;

    /// Gives the vector its size. Returns the memory of its values.
    std::span<std::uint8_t> bytes() const { return sized(vector, count); }
};

/// Appends plain values and vectors of them. `split`: large arrays lie apart.
template <bool split>
class BasicWriter {
  public:
    explicit BasicWriter(Bytes& bytes) requires(!split) : bytes_(bytes) {}
    /// `apart` gets large arrays, in their order, in place of `bytes`.
    BasicWriter(Bytes& bytes, std::vector<std::span<const std::uint8_t>>& apart) requires(split)
        : bytes_(bytes), apart_(&apart) {}

    template <class... T>
    void operator()(const T&... values) {
        (put(values), ...);
    }

  private:
    template <class T>
    void put(const T& value) {
        if constexpr (std::is_trivially_copyable_v<T>)
            append(&value, sizeof value);
        else
            transfer(*this, value);
    }
    template <class T>
    void put(const std::vector<T>& values) {
        put(values.size());
        if constexpr (std::is_trivially_copyable_v<T>) {
            const std::size_t size = values.size() * sizeof(T);
            if (split && size >= leastApart)
                apart_->emplace_back(reinterpret_cast<const std::uint8_t*>(values.data()), size);
            else
                append(values.data(), size);
        } else {
            for (const T& value : values)
                put(value);
        }
    }
    void put(const std::string& text) {
        put(text.size());
        append(text.data(), text.size());
    }
    template <class T>
    void put(const std::optional<T>& value) {
        put(value.has_value());
        if (value) put(*value);
    }
    template <class T>
    void put(const std::shared_ptr<const T>& value) {
        put(value != nullptr);
        if (value) put(*value);
    }
    void append(const void* data, std::size_t size) {
        const std::size_t end = bytes_.size();
        bytes_.resize(end + size);
        if (size > 0) std::memcpy(bytes_.data() + end, data, size);
    }

    Bytes& bytes_;
    std::vector<std::span<const std::uint8_t>>* apart_ = nullptr;
};

using Writer = BasicWriter<false>;
using SplitWriter = BasicWriter<true>;

/// Reads them back.
template <bool split>
class BasicReader {
  public:
    explicit BasicReader(std::span<const std::uint8_t> bytes) requires(!split) : bytes_(bytes) {}
    /// `apart` gets the vectors that lie apart, still empty; they must stay where they are.
    BasicReader(std::span<const std::uint8_t> bytes,
                std::vector<VectorApart>& apart) requires(split)
        : bytes_(bytes), apart_(&apart) {}

    template <class... T>
    void operator()(T&... values) {
        (take(values), ...);
    }

  private:
    template <class T>
    void take(T& value) {
        if constexpr (std::is_trivially_copyable_v<T>)
            cut(&value, sizeof value);
        else
            transfer(*this, value);
    }
    template <class T>
    void take(std::vector<T>& values) {
        std::size_t count = 0;
        take(count);
        if constexpr (std::is_trivially_copyable_v<T>) {
            const std::size_t size = count * sizeof(T);
            if constexpr (split)
                if (size >= leastApart) {
                    apart_->push_back({&values, count, sized<T>});
                    return;
                }
            values.resize(count);
            cut(values.data(), size);
        } else {
            values.resize(count);
            for (T& value : values)
                take(value);
        }
    }
    template <class T>
    static std::span<std::uint8_t> sized(void* vector, std::size_t count) {
        auto& values = *static_cast<std::vector<T>*>(vector);
        values.resize(count);
        return {reinterpret_cast<std::uint8_t*>(values.data()), count * sizeof(T)};
    }
    void take(std::string& text) {
        std::size_t size = 0;
        take(size);
        text.resize(size);
        cut(text.data(), size);
    }
    template <class T>
    void take(std::optional<T>& value) {
        bool present = false;
        take(present);
        if (present) take(value.emplace());
    }
    template <class T>
    void take(std::shared_ptr<const T>& value) {
        bool present = false;
        take(present);
        if (!present) return;
        const auto taken = std::make_shared<T>();
        take(*taken);
        value = taken;
    }
    void cut(void* data, std::size_t size) {
        const auto part = bytes_.first(size);
        if (size > 0) std::memcpy(data, part.data(), size);
        bytes_ = bytes_.subspan(size);
    }

    std::span<const std::uint8_t> bytes_;
    std::vector<VectorApart>* apart_ = nullptr;
};

using Reader = BasicReader<false>;
using SplitReader = BasicReader<true>;

} // namespace edgeshade::web

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

/// Appends plain values and vectors of them.
class Writer {
  public:
    explicit Writer(Bytes& bytes) : bytes_(bytes) {}

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
        if constexpr (std::is_trivially_copyable_v<T>)
            append(values.data(), values.size() * sizeof(T));
        else
            for (const T& value : values)
                put(value);
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
};

/// Reads them back.
class Reader {
  public:
    explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

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
        values.resize(count);
        if constexpr (std::is_trivially_copyable_v<T>)
            cut(values.data(), count * sizeof(T));
        else
            for (T& value : values)
                take(value);
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
};

} // namespace edgeshade::web

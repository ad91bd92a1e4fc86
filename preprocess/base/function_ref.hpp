#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace edgeshade {

template <class Signature>
class FunctionRef;

/// A function that its caller keeps: a std::function without memory of its own.
template <class Result, class... Arguments>
class FunctionRef<Result(Arguments...)> {
  public:
    FunctionRef() = default; ///< null
    FunctionRef(std::nullptr_t) {}

    /// `function` must outlive it.
    template <class Function>
    requires(!std::is_same_v<std::remove_cvref_t<Function>, FunctionRef> &&
             std::is_invocable_r_v<Result, Function&, Arguments...>)
        FunctionRef(Function&& function)
        : function_(const_cast<void*>(static_cast<const void*>(std::addressof(function)))),
          call_([](void* of, Arguments... arguments) -> Result {
              return (*static_cast<std::remove_reference_t<Function>*>(of))(
                  std::forward<Arguments>(arguments)...);
          }) {}

    explicit operator bool() const { return call_ != nullptr; }
    Result operator()(Arguments... arguments) const {
        return call_(function_, std::forward<Arguments>(arguments)...);
    }

  private:
    void* function_ = nullptr;
    Result (*call_)(void*, Arguments...) = nullptr;
};

} // namespace edgeshade

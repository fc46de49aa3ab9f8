#pragma once
/// Passing a callable without owning it.

#include <concepts>
#include <memory>
#include <type_traits>
#include <utility>

namespace tyndall {

template <class Signature>
class FunctionRef;

/// Refers to any callable of the signature, as std::function does, but neither copies nor allocates. For parameters
/// only: the callable must outlive the reference.
template <class R, class... A>
class FunctionRef<R(A...)> {
 public:
    template <class F>
    requires(!std::same_as<std::remove_cvref_t<F>, FunctionRef> && std::is_object_v<std::remove_reference_t<F>> &&
             std::is_invocable_r_v<R, F&, A...>) FunctionRef(F&& callable)
        : object_(const_cast<void*>(static_cast<const void*>(std::addressof(callable)))),
          call_([](void* object, A... arguments) -> R {
              return (*static_cast<std::remove_reference_t<F>*>(object))(std::forward<A>(arguments)...);
          }) {}

    R operator()(A... arguments) const { return call_(object_, std::forward<A>(arguments)...); }

 private:
    void* object_;
    R (*call_)(void* object, A... arguments);
};

}  // namespace tyndall

// A value, or the one sentence that says why there is none. What can fail returns this; nothing throws.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "base/check.h"

namespace enfilade {

/// Why something failed, ready to be printed as "where: what".
struct Error {
    std::string where;  ///< "file:line:column", a file name, an argument's name; may be empty
    std::string what;   ///< one sentence: what was expected, what was found and, where known, what to do

    /// "where: what", or just what when there is no place.
    std::string text() const { return where.empty() ? what : where + ": " + what; }
};

/// Either a T or an Error. Reading the wrong one is a broken contract.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

    bool ok() const { return state_.index() == 0; }
    explicit operator bool() const { return ok(); }

    T& value() & { return *checked<0>(); }
    const T& value() const& { return *checked<0>(); }
    T&& value() && { return std::move(*checked<0>()); }
    const Error& error() const { return *checked<1>(); }

private:
    template <std::size_t I>
    auto* checked() {
        auto* p = std::get_if<I>(&state_);
        ENFILADE_CHECK(p != nullptr);
        return p;
    }
    template <std::size_t I>
    const auto* checked() const {
        auto* p = std::get_if<I>(&state_);
        ENFILADE_CHECK(p != nullptr);
        return p;
    }

    std::variant<T, Error> state_;
};

/// For what has nothing to return: empty when it went well.
using Status = std::optional<Error>;

}  // namespace enfilade

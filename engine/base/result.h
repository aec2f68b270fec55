// What may go wrong: a value or the one sentence that says why there is none, and contracts that are broken.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace enfilade {

// Checks for broken contracts: a programmer's mistake stops the program, a bad file never does.

/// Where an attempt is under way in this thread (base/attempt.h), ends that attempt. Else removes unfinished files,
/// prints "file:line: broken contract: text" to stderr and aborts.
[[noreturn]] void contract_broken(const char* file, int line, const char* text);

/// Always on. For cheap checks at the doors of a module.
#define ENFILADE_CHECK(condition) \
    ((condition) ? static_cast<void>(0) : ::enfilade::contract_broken(__FILE__, __LINE__, #condition))

/// On where NDEBUG is not defined. For checks inside loops.
#ifdef NDEBUG
#define ENFILADE_DCHECK(condition) static_cast<void>(sizeof(condition))
#else
#define ENFILADE_DCHECK(condition) ENFILADE_CHECK(condition)
#endif

// A value, or the one sentence that says why there is none. What can fail returns this; nothing throws.

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

/// For what has nothing to return: nothing, or why it failed.
template <>
class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : error_(std::move(error)) {}

    bool ok() const { return !error_; }

    const Error& error() const {
        ENFILADE_CHECK(error_.has_value());
        return *error_;
    }

    /// The error, or the other one where there is none.
    Error error_or(const Error& other) const { return error_.value_or(other); }

private:
    std::optional<Error> error_;
};

}  // namespace enfilade

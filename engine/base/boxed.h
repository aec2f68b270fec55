// An optional value that takes the room of a pointer where it is absent: for large parts that few records have.
#pragma once
#include <memory>

#include "base/result.h"

namespace enfilade {

/// A value, copied and compared as such, or none. Costs an allocation where there is one.
template <class T>
class Boxed {
public:
    using value_type = T;

    Boxed() = default;
    Boxed(const T& value) : value_(std::make_unique<T>(value)) {}
    Boxed(const Boxed& other) : value_(other ? std::make_unique<T>(*other) : nullptr) {}
    Boxed(Boxed&&) noexcept = default;
    Boxed& operator=(Boxed other) noexcept {
        value_ = std::move(other.value_);
        return *this;
    }
    ~Boxed() = default;

    T& emplace() {
        value_ = std::make_unique<T>();
        return *value_;
    }
    void reset() { value_.reset(); }

    explicit operator bool() const { return value_ != nullptr; }
    T& operator*() const {
        ENFILADE_CHECK(value_ != nullptr);
        return *value_;
    }
    T* operator->() const { return &**this; }

    friend bool operator==(const Boxed& a, const Boxed& b) { return a && b ? *a == *b : !a && !b; }

private:
    std::unique_ptr<T> value_;
};

}  // namespace enfilade

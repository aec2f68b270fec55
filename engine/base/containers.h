// Containers that take little room for what is usual: a value that is mostly absent, a list that is mostly short.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <type_traits>
#include <vector>

#include "base/result.h"

namespace enfilade {

// An optional value that takes the room of a pointer where it is absent: for large parts that few records have.

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

    /// A value as T() makes it, in place of the one there was.
    T& emplace() {
        value_ = std::make_unique<T>();
        return *value_;
    }
    void reset() { value_.reset(); }

    explicit operator bool() const { return value_ != nullptr; }
    /// The value, which goes with its box. Where there is none, a broken contract.
    T& operator*() const {
        ENFILADE_CHECK(value_ != nullptr);
        return *value_;
    }
    T* operator->() const { return &**this; }

    friend bool operator==(const Boxed& a, const Boxed& b) { return a && b ? *a == *b : !a && !b; }

private:
    std::unique_ptr<T> value_;
};

// A list that is nearly always short: its first elements lie in the list itself, so that asking a question whose answer
// is such a list takes nothing from the heap.

/// A vector of plain values of which up to kFew take no memory of their own; more of them move to the heap, all
/// together. Pointers and iterators are good until the next change of the list, or its move.
template <class T, std::size_t kFew>
class ShortList {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    using value_type = T;
    using iterator = T*;
    using const_iterator = const T*;

    ShortList() = default;
    ShortList(const ShortList& other) : many_(other.many_), size_(other.size_) { copy_few(other); }
    ShortList(ShortList&& other) noexcept : many_(std::move(other.many_)), size_(other.size_) {
        copy_few(other);
        other.clear();
    }
    ShortList& operator=(const ShortList& other) {
        if (this == &other) return *this;
        many_ = other.many_;
        size_ = other.size_;
        copy_few(other);
        return *this;
    }
    ShortList& operator=(ShortList&& other) noexcept {
        if (this == &other) return *this;
        many_ = std::move(other.many_);
        size_ = other.size_;
        copy_few(other);
        other.clear();
        return *this;
    }
    ~ShortList() = default;

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    T* data() { return is_on_heap() ? many_.data() : few(); }
    const T* data() const { return is_on_heap() ? many_.data() : few(); }
    iterator begin() { return data(); }
    iterator end() { return data() + size_; }
    const_iterator begin() const { return data(); }
    const_iterator end() const { return data() + size_; }
    /// i < size(), and front() and back() of a list that is not empty: none of it is checked.
    T& operator[](std::size_t i) { return data()[i]; }
    const T& operator[](std::size_t i) const { return data()[i]; }
    T& front() { return data()[0]; }
    const T& front() const { return data()[0]; }
    T& back() { return data()[size_ - 1]; }
    const T& back() const { return data()[size_ - 1]; }

    /// Keeps the heap's memory, if it had some, for when it is long again.
    void clear() {
        many_.clear();
        size_ = 0;
    }

    /// value may be an element of the list.
    void push_back(const T& value) {
        if (size_ < kFew && !is_on_heap()) {
            std::construct_at(few() + size_, value);
        } else {
            const T kept = value;
            if (!is_on_heap()) many_.assign(few(), few() + size_);
            many_.push_back(kept);
        }
        ++size_;
    }

    /// Not empty.
    void pop_back() { drop_to(size_ - 1); }

    /// Adds all elements of another list.
    template <class List>
    void append(const List& list) {
        for (const T& value : list) push_back(value);
    }

    /// Takes out the elements for which test(element) is true; the others stay in order.
    template <class Test>
    void erase_if(Test test) {
        erase_from(std::remove_if(begin(), end(), test));
    }

    /// Takes out all elements from a place in the list on.
    void erase_from(const_iterator first) { drop_to(static_cast<std::size_t>(first - data())); }

    friend bool operator==(const ShortList& a, const ShortList& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end());
    }

private:
    /// Once on the heap, a list stays there until it is cleared.
    bool is_on_heap() const { return !many_.empty(); }
    T* few() { return reinterpret_cast<T*>(few_); }
    const T* few() const { return reinterpret_cast<const T*>(few_); }

    void copy_few(const ShortList& other) {
        if (!is_on_heap()) std::memcpy(few_, other.few_, size_ * sizeof(T));
    }

    void drop_to(std::size_t count) {
        if (is_on_heap() && count > 0) many_.erase(many_.begin() + static_cast<std::ptrdiff_t>(count), many_.end());
        if (count == 0) many_.clear();
        size_ = count;
    }

    alignas(T) std::byte few_[kFew * sizeof(T)];
    std::vector<T> many_;  ///< all elements, or none
    std::size_t size_ = 0;
};

}  // namespace enfilade

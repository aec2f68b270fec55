// An oracle for exact geometry: whole numbers of any size by schoolbook arithmetic, sharing nothing with the engine's
// predicates. The tie rule is not derived here but carried out: e is a real number, 2^-256 grid steps.
#pragma once
#include <cmath>
#include <compare>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/result.h"
#include "math/vec.h"

namespace enfilade::test {

/// A whole number: sign and magnitude, 32-bit digits from the lowest up, no leading zeros.
class Integer {
public:
    Integer(std::int64_t value) : negative_(value < 0) {
        for (auto m = negative_ ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value); m;
             m >>= 32)
            digits_.push_back(static_cast<std::uint32_t>(m));
    }

    /// x * 2^power, which must be a whole number.
    static Integer scaled(double x, int power) {
        int exponent = 0;
        auto mantissa = static_cast<std::int64_t>(std::frexp(x, &exponent) * 0x1p53);
        if (mantissa == 0) return 0;
        int shift = exponent - 53 + power;
        for (; shift < 0; ++shift, mantissa /= 2) ENFILADE_CHECK(mantissa % 2 == 0);
        return Integer(mantissa) << shift;
    }

    int sign() const { return digits_.empty() ? 0 : negative_ ? -1 : 1; }

    Integer operator-() const {
        Integer opposite = *this;
        opposite.negative_ = !negative_ && !digits_.empty();
        return opposite;
    }

    friend Integer operator+(const Integer& a, const Integer& b) {
        if (a.negative_ == b.negative_) return Integer(sum(a.digits_, b.digits_), a.negative_);
        const bool a_larger = compare(a.digits_, b.digits_) >= 0;
        return a_larger ? Integer(difference(a.digits_, b.digits_), a.negative_)
                        : Integer(difference(b.digits_, a.digits_), b.negative_);
    }
    friend Integer operator-(const Integer& a, const Integer& b) { return a + -b; }

    friend Integer operator*(const Integer& a, const Integer& b) {
        Digits product(a.digits_.size() + b.digits_.size(), 0);
        for (std::size_t i = 0; i < a.digits_.size(); ++i) {
            std::uint64_t carry = 0;
            for (std::size_t j = 0; j < b.digits_.size() || carry; ++j) {
                const std::uint64_t digit = j < b.digits_.size() ? b.digits_[j] : 0;
                carry += product[i + j] + std::uint64_t{a.digits_[i]} * digit;
                product[i + j] = static_cast<std::uint32_t>(carry);
                carry >>= 32;
            }
        }
        return Integer(std::move(product), a.negative_ != b.negative_);
    }

    Integer operator<<(int bits) const {
        Integer shifted = *this * Integer(std::int64_t{1} << (bits % 32));
        if (sign() != 0) shifted.digits_.insert(shifted.digits_.begin(), static_cast<std::size_t>(bits / 32), 0);
        return shifted;
    }

    bool operator==(const Integer&) const = default;
    std::strong_ordering operator<=>(const Integer& other) const { return (*this - other).sign() <=> 0; }

private:
    using Digits = std::vector<std::uint32_t>;

    Integer(Digits digits, bool negative) : digits_(std::move(digits)), negative_(negative) {
        while (!digits_.empty() && digits_.back() == 0) digits_.pop_back();
        negative_ = negative_ && !digits_.empty();
    }

    static int compare(const Digits& a, const Digits& b) {
        if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
        for (std::size_t i = a.size(); i-- > 0;)
            if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
        return 0;
    }

    static Digits sum(const Digits& a, const Digits& b) {
        Digits digits;
        std::uint64_t carry = 0;
        for (std::size_t i = 0; i < a.size() || i < b.size() || carry; ++i) {
            carry += (i < a.size() ? a[i] : std::uint64_t{0}) + (i < b.size() ? b[i] : std::uint64_t{0});
            digits.push_back(static_cast<std::uint32_t>(carry));
            carry >>= 32;
        }
        return digits;
    }

    /// a - b for a >= b.
    static Digits difference(const Digits& a, const Digits& b) {
        Digits digits;
        std::int64_t carry = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            carry += std::int64_t{a[i]} - (i < b.size() ? std::int64_t{b[i]} : 0);
            digits.push_back(static_cast<std::uint32_t>(carry));
            carry >>= 32;
        }
        return digits;
    }

    Digits digits_;
    bool negative_ = false;
};

/// A point in units of 2^-544 m: 2^-32 m for the grid, times e^2 for e = 2^-256.
struct ExactPoint {
    Integer x;
    Integer y;
};

inline ExactPoint operator-(const ExactPoint& a, const ExactPoint& b) { return {a.x - b.x, a.y - b.y}; }
inline Integer cross(const ExactPoint& a, const ExactPoint& b) { return a.x * b.y - a.y * b.x; }

inline constexpr int kExactUnits = 32 + 512;  ///< [bits]

inline ExactPoint exact(Vec2 p) { return {Integer::scaled(p.x, kExactUnits), Integer::scaled(p.y, kExactUnits)}; }

/// Where the tie rule says that the moving point p is: p + (e, e^2).
inline ExactPoint exact_moved(Vec2 p) {
    const ExactPoint at = exact(p);
    return {at.x + (Integer(1) << 256), at.y + Integer(1)};
}

/// A fraction with a positive denominator.
struct ExactFraction {
    Integer numerator;
    Integer denominator;
};

inline int compare(const ExactFraction& a, const ExactFraction& b) {
    return (a.numerator * b.denominator - b.numerator * a.denominator).sign();
}

}  // namespace enfilade::test

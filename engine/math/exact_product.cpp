#include "math/exact_product.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/result.h"

namespace enfilade {
namespace {

__extension__ using UInt128 = unsigned __int128;

constexpr int kDigitBits = 64;
constexpr int kDoubleBits = 53;

int sign(Int128 x) { return (x > 0) - (x < 0); }

}  // namespace

ExactProduct::ExactProduct(Int128 factor) : sign_(1), digits_{1} { times(factor); }

ExactProduct& ExactProduct::times(double factor) {
    int power = 0;
    const double fraction = std::frexp(factor, &power);  // exact, also of subnormal numbers
    times(Int128{static_cast<std::int64_t>(std::ldexp(fraction, kDoubleBits))});
    return scaled(power - kDoubleBits);
}

ExactProduct& ExactProduct::times(Int128 factor) {
    sign_ *= sign(factor);
    UInt128 magnitude = factor < 0 ? -static_cast<UInt128>(factor) : static_cast<UInt128>(factor);
    if (magnitude == 0) return *this;
    const Digits before = digits_;
    multiply(static_cast<std::uint64_t>(magnitude));
    ExactProduct upper = *this;
    upper.digits_ = before;
    upper.multiply(static_cast<std::uint64_t>(magnitude >> kDigitBits));
    UInt128 carry = 0;
    for (std::size_t i = 1; i < digits_.size(); ++i) {
        carry += UInt128{digits_[i]} + upper.digits_[i - 1];
        digits_[i] = static_cast<std::uint64_t>(carry);
        carry >>= kDigitBits;
    }
    ENFILADE_CHECK(carry == 0 && upper.digits_.back() == 0);
    return *this;
}

void ExactProduct::multiply(std::uint64_t factor) {
    UInt128 carry = 0;
    for (std::uint64_t& digit : digits_) {
        carry += UInt128{digit} * factor;
        digit = static_cast<std::uint64_t>(carry);
        carry >>= kDigitBits;
    }
    ENFILADE_CHECK(carry == 0);
}

ExactProduct& ExactProduct::scaled(int power) {
    exponent_ += power;
    return *this;
}

int ExactProduct::bit_count() const {
    for (std::size_t i = digits_.size(); i-- > 0;)
        if (digits_[i] != 0) return static_cast<int>(i) * kDigitBits + static_cast<int>(std::bit_width(digits_[i]));
    return 0;
}

/// With the highest bit at the top.
ExactProduct::Digits ExactProduct::aligned() const {
    const int shift = kMostBits - bit_count(), bits = shift % kDigitBits;
    const std::size_t whole = static_cast<std::size_t>(shift / kDigitBits);
    Digits moved{};
    for (std::size_t i = whole; i < moved.size(); ++i) {
        moved[i] = digits_[i - whole] << bits;
        if (bits != 0 && i > whole) moved[i] |= digits_[i - whole - 1] >> (kDigitBits - bits);
    }
    return moved;
}

int compare(const ExactProduct& a, const ExactProduct& b) {
    if (a.sign_ != b.sign_ || a.sign_ == 0) return (a.sign_ > b.sign_) - (a.sign_ < b.sign_);
    const std::int64_t a_top = a.exponent_ + a.bit_count(), b_top = b.exponent_ + b.bit_count();
    if (a_top != b_top) return a_top > b_top ? a.sign_ : -a.sign_;
    const ExactProduct::Digits x = a.aligned(), y = b.aligned();
    if (x == y) return 0;
    return std::lexicographical_compare(x.rbegin(), x.rend(), y.rbegin(), y.rend()) ? -a.sign_ : a.sign_;
}

}  // namespace enfilade

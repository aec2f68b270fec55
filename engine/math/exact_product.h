// Products of whole and floating-point numbers without any rounding, to be compared.
#pragma once
#include <array>
#include <cstdint>

#include "math/predicates.h"

namespace enfilade {

/// A product of at most kMostBits significant bits: sign, whole number, power of two. Made of factors, each a whole
/// number or a double; a double has at most 53 significant bits, whatever its size. Cost: some 20 ns a factor.
class ExactProduct {
public:
    static constexpr int kMostBits = 256;

    explicit ExactProduct(Int128 factor);

    /// factor: finite.
    ExactProduct& times(double factor);
    ExactProduct& times(Int128 factor);

    /// Times two to this power.
    ExactProduct& scaled(int power);

    /// -1, 0, 1 as a is less than, equal to or greater than b.
    friend int compare(const ExactProduct& a, const ExactProduct& b);

private:
    using Digits = std::array<std::uint64_t, kMostBits / 64>;  ///< the lowest first

    void multiply(std::uint64_t factor);
    int bit_count() const;
    Digits aligned() const;

    int sign_ = 0;
    Digits digits_{};
    std::int64_t exponent_ = 0;
};

}  // namespace enfilade

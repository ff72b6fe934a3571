#pragma once

#include "deadpoint/casefile/studies/design_section.hpp"
#include "deadpoint/twin/calibrate/parameter.hpp"

#include <string>
#include <vector>

/// Studies of sensitivity and design on a reduced press.
namespace deadpoint::twin {

/// The range of an unknown, over a share u of 0..1. Factors are spread evenly by their logarithm, shifts and values
/// evenly.
struct VariedRange {
    using Kind = casefile::VariedKeys::Kind;
    std::string name;
    Kind kind = Kind::factor;
    double low = 0, high = 0;  ///< factors, or shifts or values in SI units
    Dimension dimension = Dimension::none;
    double centre = 1;   ///< value at theta = 0, where the range is one of values
    bool scaled = true;  ///< whether theta acts as a factor exp(theta); else as a shift

    /// Factor, shift or value at a share.
    [[nodiscard]] double value_at(double share) const;
    [[nodiscard]] double share_of(double value) const;
    [[nodiscard]] double theta_of_value(double value) const;
    [[nodiscard]] double theta_at(double share) const { return theta_of_value(value_at(share)); }
    /// d theta / d value.
    [[nodiscard]] double theta_by_value(double value) const;
    /// d theta / d share.
    [[nodiscard]] double theta_slope(double share) const;
};

/// A case ready to be varied.
struct VariedCase {
    std::vector<CaseParameter> parameters;
    std::vector<VariedRange> ranges;  ///< of the parameters
};

/// Where a range is one of values, its keys get the centre of the range in the case: the geometric mean, or the
/// arithmetic one of temperatures and of ranges that reach zero.
/// @param list  as casefile::complete_varied() leaves it
VariedCase varied_case(casefile::Case& input, const std::vector<casefile::VariedKeys>& list);

/// Thetas of all ranges at shares.
std::vector<double> thetas_at(const std::vector<VariedRange>& ranges, const std::vector<double>& shares);

}  // namespace deadpoint::twin

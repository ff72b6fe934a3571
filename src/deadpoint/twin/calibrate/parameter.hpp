#pragma once

#include <string>
#include <vector>

namespace deadpoint::casefile {
struct Case;
}

/// Unknowns of a case, as calibration, sensitivity and design vary them.
namespace deadpoint::twin {

/// One unknown, which drives one key of a case or several.
struct CaseParameter {
    /// A factor exp(theta) on the values of its keys, or a shift theta [SI units] of temperatures and the like.
    enum class Kind { factor, shift };
    std::string name;
    std::vector<std::string> keys;  ///< paths as for --set, with item numbers; see keys_of()
    Kind kind = Kind::factor;
};

/// The keys that patterns name: "oil.*", "joints.*.interfaces.pin.oil". Items of lists may be given by number or name.
/// @param owner  of the patterns, for errors
/// @throws InputError for a pattern that names no number of the case, with the nearest key
std::vector<std::string> keys_of(const casefile::Case& input, const std::vector<std::string>& patterns,
                                 const std::string& owner);

/// The case with parameters at theta, in the order of the parameters; all zero: the case as it is.
/// @throws InputError if a value leaves the range of its key
casefile::Case with_parameters(const casefile::Case& input, const std::vector<CaseParameter>& parameters,
                               const std::vector<double>& theta);

/// Those values as "path=value", as for --set.
std::vector<std::string> settings_of(const casefile::Case& input, const std::vector<CaseParameter>& parameters,
                                     const std::vector<double>& theta);

}  // namespace deadpoint::twin

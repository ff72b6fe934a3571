#pragma once

#include "deadpoint/exchange/heat_causes.hpp"

#include <cstddef>
#include <optional>

namespace deadpoint::reduce {

/// Says when the basis of the causes (reduced_adjoint.hpp) has fields enough: when the last two changed each cause by
/// at most 1e-3 of it, or of 0.5 % of all causes together if that is more. Each two further fields leave about a tenth
/// of the error.
class CausesSearch {
public:
    [[nodiscard]] bool known() const { return causes_.has_value(); }
    /// @param fields  in the basis; there are never more than a hundred
    [[nodiscard]] bool wants_more(std::size_t fields) const;
    /// Takes the causes on the present basis.
    void add(HeatCauses causes);
    /// The last causes, with the larger of their last two changes: how far they may be off.
    [[nodiscard]] HeatCauses result(std::size_t fields) const;

private:
    std::optional<HeatCauses> causes_;
    double relative_ = 1;             ///< last change
    double change_ = 0, before_ = 0;  ///< last two changes
};

}  // namespace deadpoint::reduce

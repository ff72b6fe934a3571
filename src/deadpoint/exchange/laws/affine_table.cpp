#include "deadpoint/exchange/laws/affine_table.hpp"

namespace deadpoint {

LawTable affine(LawTable table, double factor, double offset)
{
    const auto all = members(static_cast<const LawTable*>(nullptr));
    for (auto& value : table.*std::get<1>(all))
        value = offset + factor * value;
    for (auto& slope : table.*std::get<2>(all))
        slope *= factor;
    return table;
}

}  // namespace deadpoint

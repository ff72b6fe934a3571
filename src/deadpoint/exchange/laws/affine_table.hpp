#pragma once

#include "deadpoint/exchange/laws/law_table.hpp"

namespace deadpoint {

/// The table of offset + factor times a law, at the points of the law's own table.
LawTable affine(LawTable table, double factor, double offset);

}  // namespace deadpoint

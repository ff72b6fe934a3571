#pragma once

#include "deadpoint/reduce/online/box.hpp"

#include <vector>

namespace deadpoint::reduce {

/// The problem with conduction coefficients that are, term by term, the smallest of all values of a box and of all
/// segments: its matrix K' is at most K(p) for every p of the box. Of an interface with sides a, b and oil g these are
///   a b / (a + b + g) at the smallest a and b and the largest g,
///   a g / (a + b + g) at the smallest a and g and the largest b, and the same of b,
/// and the law of the result has just these three (star of a triangle of conductances). Only its interfaces and
/// surfaces count; it has no segments of other laws.
HeatProblem lowest_conduction(const HeatProblem& base, const Box& box);
/// The largest coefficient of each term in the box, in the order of coefficients_of().
std::vector<double> highest_conduction(const HeatProblem& base, const Box& box);

}  // namespace deadpoint::reduce

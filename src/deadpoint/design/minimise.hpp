#pragma once

#include "deadpoint/design/points.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

/// Minima under bounds and limits.
namespace deadpoint::design {

/// An objective and its limits at a point, with derivatives if asked for.
struct Evaluation {
    double value = 0;
    std::vector<double> slope;                ///< of the value by each variable
    std::vector<double> limits;               ///< each at most zero where the limit is kept
    std::vector<std::vector<double>> slopes;  ///< [limit][variable]
};

/// What is minimised over the unit cube.
struct MinimiseProblem {
    std::size_t variables = 0;
    std::size_t limits = 0;
    /// @param derivatives  whether the slopes are needed
    std::function<Evaluation(const Point& at, bool derivatives)> evaluate;
    std::function<bool()> stopped;  ///< asked at every evaluation; may be empty
};

enum class MinimiseMethod {
    slsqp,  ///< sequential quadratic programming (Kraft 1994), with derivatives
    /// Conservative convex separable approximations (Svanberg, SIAM J. Optim. 12 (2002) 555), with derivatives. NLopt
    /// 2.7.1's MMA, of the same paper, stays in a corner if it starts where a limit is exceeded.
    ccsa,
    cobyla  ///< linear approximations (Powell 1994), without derivatives
};

struct MinimiseOptions {
    MinimiseMethod method = MinimiseMethod::slsqp;
    int most_evaluations = 100;
    double tolerance = 1e-4;    ///< of the value, relative, and of the variables, absolute
    double kept_within = 1e-4;  ///< a limit that is exceeded by no more counts as kept
};

/// A step on the way.
struct MinimiseStep {
    Point at;
    double value = 0;
    double exceeded = 0;  ///< largest limit above zero
};

struct Minimum {
    Point at;
    double value = 0;
    bool feasible = false;  ///< all limits are kept
    std::string end;        ///< why it stopped, in words
    std::vector<MinimiseStep> steps;
};

/// The best point that was evaluated: the smallest value of those that keep all limits; if none does, the one that
/// exceeds them least. A limit is any quantity divided by its size, so that one tolerance serves all.
Minimum minimise(const MinimiseProblem& problem, const Point& start, const MinimiseOptions& options);

/// "slsqp", "ccsa", "cobyla".
const char* name_of(MinimiseMethod method);

}  // namespace deadpoint::design

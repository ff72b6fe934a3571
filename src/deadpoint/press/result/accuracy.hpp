#pragma once

#include "deadpoint/casefile/describe/accuracy.hpp"

#include <optional>
#include <string>
#include <vector>

/// Report of a run to a stated accuracy.
namespace deadpoint::press {

/// One mesh of the refinement.
struct AccuracyRound {
    long long cells = 0;
    double value = 0;              ///< the gap at the end [m], or the largest final rise of a probe [K]
    std::optional<double> change;  ///< largest change from the previous mesh over the run [m] or [K]
    double estimate = 0;           ///< estimated change by finer parts, from the adjoint solutions [m] or [K]
    int refined = 0;               ///< parts that are finer than in the mesh before
    std::string worst_part;        ///< of the largest share of the estimate
    double seconds = 0;            ///< wall time
};

/// One part at the end.
struct AccuracyPart {
    std::string name;
    double first_size = 0;  ///< cell size asked for at the start [m]
    double size = 0;        ///< at the end [m]
    long long cells = 0;    ///< at the end
    double share = 0;       ///< of the estimate at the end [m] or [K]
    bool fixed = false;     ///< its mesh comes from a file
};

struct AccuracyReport {
    casefile::Accuracy wanted;
    bool reached = false;
    std::string why_not;  ///< reason if it was not reached
    std::vector<AccuracyRound> rounds;
    std::vector<AccuracyPart> parts;
    double time_tolerance = 0;  ///< used [K]
    double max_step = 0;        ///< used [s]
    double time_change = 0;     ///< by steps half as long, on the first mesh [m] or [K]
    double time_seconds = 0;    ///< spent on that
    double seconds = 0;         ///< wall time of all
};

}  // namespace deadpoint::press

#pragma once

#include "deadpoint/exchange/laws/law_table.hpp"
#include "deadpoint/study/laws/kept_values.hpp"
#include "deadpoint/study/laws/loads_key.hpp"
#include "deadpoint/study/result/friction_summary.hpp"

#include <memory>
#include <string>
#include <utility>

/// Friction laws that many cases of one machine share.
namespace deadpoint::study {

struct LoadsResult;

/// Duty of the joints of a calibrated law, to which its load part is proportional.
struct LoadDuty {
    double sum = 0;         ///< of mean(F^1.33 |w|) or mean(F |w|), by the kind of the law
    bool unloaded = false;  ///< the joints carry no load
};

/// Viscous shapes of calibrated laws as tables, by lubricant, exponent and, of rolling friction, speed.
using KeptShapes = KeptValues<std::string, LawTable>;

/// What follows from loads, for cases that agree in all that loads depend on. `loads` are others of the same cases.
struct KeptFriction {
    /// Inputs of a law (FrictionLaws) and the loads at which it is wanted.
    using Key = std::pair<std::string, LoadsKey>;
    KeptValues<LoadsKey, std::shared_ptr<const LoadsResult>> loads{16};  ///< at other points, and at references
    KeptValues<Key, LoadDuty> duties{1024};
    KeptValues<Key, FrictionHeat> heats{256};  ///< of physical laws, without their scale
    KeptValues<Key, LawTable> tables{256};     ///< of the same; one takes some tens of kilobytes
    /// Of any loads.
    std::shared_ptr<KeptShapes> shapes = std::make_shared<KeptShapes>(std::size_t{64});
};

}  // namespace deadpoint::study

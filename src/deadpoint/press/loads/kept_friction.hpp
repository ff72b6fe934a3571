#pragma once

#include "deadpoint/core/memo.hpp"
#include "deadpoint/exchange/laws/law_table.hpp"
#include "deadpoint/press/loads/loads_key.hpp"
#include "deadpoint/press/result/friction_summary.hpp"

#include <memory>
#include <string>
#include <utility>

/// Friction laws that many cases of one machine share.
namespace deadpoint::press {

struct LoadsResult;

/// Duty of the joints of a calibrated law, to which its load part is proportional.
struct LoadDuty {
    double sum = 0;         ///< of mean(F^1.33 |w|) or mean(F |w|), by the kind of the law
    bool unloaded = false;  ///< the joints carry no load
};

/// Viscous shapes of calibrated laws as tables, by lubricant, exponent and, of rolling friction, speed.
using KeptShapes = Memo<std::string, LawTable>;

/// What follows from loads, for cases that agree in all that loads depend on. `loads` are others of the same cases.
struct KeptFriction {
    /// Inputs of a law (FrictionLaws) and the loads at which it is wanted.
    using Key = std::pair<std::string, LoadsKey>;
    Memo<LoadsKey, std::shared_ptr<const LoadsResult>> loads{16};  ///< at other points, and at references
    Memo<Key, LoadDuty> duties{1024};
    Memo<Key, FrictionHeat> heats{256};  ///< of physical laws, without their scale
    Memo<Key, LawTable> tables{256};     ///< of the same; one takes some tens of kilobytes
    /// Viscous shapes, which are the same at any loads.
    std::shared_ptr<KeptShapes> shapes = std::make_shared<KeptShapes>(std::size_t{64});
};

}  // namespace deadpoint::press

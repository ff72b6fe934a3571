#pragma once

#include "deadpoint/exchange/deformation.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace deadpoint::fem {
struct Displacement;
struct Field;
}  // namespace deadpoint::fem

namespace deadpoint {
struct Machine;
}  // namespace deadpoint
namespace deadpoint::fem {
class Model;
struct HandedField;
}  // namespace deadpoint::fem
namespace deadpoint::press {
struct ViewData;
}

/// The temperature and deformation of a run on a decimated surface, for the page.
namespace deadpoint::full {

inline constexpr std::size_t view_triangles = 30000;
inline constexpr double view_tolerance = 0.005;  ///< of the largest rise: allowed error of leaving out modes
inline constexpr std::size_t view_modes = 12;    ///< at most
/// If the remaining modes change the rise by less than this (root mean square), they are not used
/// for the deformation. The deformation integrates the temperature over lengths, so its largest
/// error stays below about 1 % of its largest value.
inline constexpr double view_deformation_tolerance = 0.025;

/// Rigid motions of the parts that close the joints again after a deformation.
using CloseJoints = std::function<std::vector<RigidMotion>(const fem::Displacement&)>;

/// Keeps fields during the run and reduces them to light data at its end. The deformation is linear
/// in the temperature, or in the rise that represents its strain, so it is solved for the main
/// modes instead of at each time.
class ViewRecorder {
public:
    void add(double time, const fem::Field& field);
    [[nodiscard]] bool empty() const { return times_.empty(); }
    /// What was added.
    [[nodiscard]] std::vector<fem::HandedField> kept() const;

    /// Collective. Empties the recorder.
    /// @param reference  temperature without deformation [K]
    /// @param close      empty: no deformation
    press::ViewData finish(const Machine& machine, fem::Model& model, double reference, const CloseJoints& close);

private:
    std::vector<double> times_;
    std::vector<std::vector<float>> fields_;
};

}  // namespace deadpoint::full

#pragma once

#include "deadpoint/exchange/bare_machine.hpp"
#include "deadpoint/heat/functionals.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"

#include <tuple>

/// The members of a reduced press as its file has them (io/binary_file).
namespace deadpoint {
namespace heat {

constexpr auto members(const FunctionalLayout*)
{
    return std::tuple{&FunctionalLayout::interfaces, &FunctionalLayout::parts, &FunctionalLayout::surfaces,
                      &FunctionalLayout::bodies, &FunctionalLayout::probes};
}
constexpr auto members(const HeatGeometry*)
{
    return std::tuple{&HeatGeometry::layout, &HeatGeometry::interface_names, &HeatGeometry::interface_area,
                      &HeatGeometry::surface_area};
}

}  // namespace heat

namespace reduce {

constexpr auto last_value(const FreeCoefficient::Kind*) { return FreeCoefficient::Kind::ambient; }
constexpr auto members(const FreeCoefficient*)
{
    return std::tuple{&FreeCoefficient::name, &FreeCoefficient::kind, &FreeCoefficient::members,
                      &FreeCoefficient::base, &FreeCoefficient::from, &FreeCoefficient::to};
}

}  // namespace reduce

constexpr auto last_value(const ClearanceSeries::Kind*) { return ClearanceSeries::Kind::guide; }
constexpr auto members(const Series*) { return std::tuple{&Series::value, &Series::rate}; }
constexpr auto members(const CornerSeries*)
{
    return std::tuple{&CornerSeries::name, &CornerSeries::x, &CornerSeries::z};
}

namespace press {

constexpr auto members(const GapModel::Clearance*)
{
    return std::tuple{&GapModel::Clearance::name, &GapModel::Clearance::kind, &GapModel::Clearance::joint};
}
constexpr auto members(const GapModel*)
{
    return std::tuple{&GapModel::corners, &GapModel::clearances, &GapModel::left_out, &GapModel::mirrored};
}
constexpr auto members(const RodForce*)
{
    return std::tuple{&RodForce::part, &RodForce::preload, &RodForce::start, &RodForce::held_share};
}
constexpr auto members(const ClosedBond*)
{
    return std::tuple{&ClosedBond::name, &ClosedBond::preload, &ClosedBond::area, &ClosedBond::start};
}
constexpr auto members(const FrameResult*)
{
    return std::tuple{&FrameResult::rods, &FrameResult::bonds, &FrameResult::support_force};
}
constexpr auto members(const StatedError*)
{
    return std::tuple{&StatedError::of, &StatedError::temperature, &StatedError::gap};
}
constexpr auto members(const ErrorOfSize*)
{
    return std::tuple{&ErrorOfSize::states, &ErrorOfSize::temperature, &ErrorOfSize::gap};
}

}  // namespace press
namespace twin {

constexpr auto members(const ReducedChain*)
{
    return std::tuple{&ReducedChain::figures, &ReducedChain::gaps, &ReducedChain::first_gap};
}
/// All of a press that a small and a large model have in common, in the order of the file, without its terms.
constexpr auto common_members(const ReducedPress*)
{
    return std::tuple{&ReducedPress::machine,  &ReducedPress::size_scale, &ReducedPress::cells,
                      &ReducedPress::unknowns, &ReducedPress::adjoints,   &ReducedPress::reference,
                      &ReducedPress::chain,    &ReducedPress::frame,      &ReducedPress::first_frame,
                      &ReducedPress::box};
}
/// All but the terms.
constexpr auto head(const ReducedPress* press)
{
    return std::tuple_cat(std::tuple{&ReducedPress::version, &ReducedPress::name, &ReducedPress::case_hash,
                                     &ReducedPress::fixed_part, &ReducedPress::large_file},
                          common_members(press), std::tuple{&ReducedPress::errors, &ReducedPress::sizes});
}

}  // namespace twin
}  // namespace deadpoint

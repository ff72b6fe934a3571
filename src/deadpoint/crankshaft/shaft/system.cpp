#include "deadpoint/crankshaft/shaft/system.hpp"

#include "deadpoint/crankshaft/shaft/check.hpp"
#include "deadpoint/crankshaft/shaft/eigen_views.hpp"
#include "deadpoint/crankshaft/shaft/element.hpp"
#include "deadpoint/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::crankshaft {
namespace {

/// Unknowns x, y, ty, tz of a node among those of a beam element.
constexpr std::array<int, 8> lateral{1, 2, 3, 4, 6, 7, 8, 9};

std::vector<double> section_ends(const Shaft& shaft)
{
    std::vector<double> ends{shaft.start};
    for (const Section& section : shaft.sections)
        ends.push_back(ends.back() + section.length);
    return ends;
}

/// Ends of sections come first; a place that equals one of them within rounding is moved onto it.
std::vector<double> node_positions(const Shaft& shaft, std::span<const double> more)
{
    std::vector<double> nodes = section_ends(shaft);
    const double tolerance = same_place * (nodes.back() - nodes.front());
    const double first = nodes.front() - tolerance;
    const double last = nodes.back() + tolerance;
    const auto add = [&](double position) {
        if (!(position >= first && position <= last))
            throw InputError(fmt::format("crankshaft: {:g} mm is not on the shaft, which runs from {:g} to {:g} mm",
                                         1e3 * position, 1e3 * nodes.front(), 1e3 * shaft_end(shaft)));
        const bool known = std::any_of(nodes.begin(), nodes.end(),
                                       [&](double node) { return std::abs(node - position) <= tolerance; });
        if (!known)
            nodes.push_back(position);
    };
    for (const Disk& disk : shaft.disks)
        add(disk.position);
    for (const Bearing& bearing : shaft.bearings)
        add(bearing.position);
    for (const Unbalance& unbalance : shaft.unbalances)
        add(unbalance.position);
    for (const double position : more)
        add(position);
    std::sort(nodes.begin(), nodes.end());
    return nodes;
}

void add_beam(ShaftSystem& system, int node, const BeamElement& beam)
{
    const ElementMatrices element = beam_matrices(beam);
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j) {
            const int row = lateral[static_cast<std::size_t>(i)];
            const int col = lateral[static_cast<std::size_t>(j)];
            const int to_row = first_unknown(node) + i;
            const int to_col = first_unknown(node) + j;
            system.mass(to_row, to_col) += element.mass_translation(row, col) + element.mass_rotation(row, col);
            system.gyroscopic(to_row, to_col) += element.gyroscopic(row, col);
            system.bending(to_row, to_col) += element.stiffness(row, col);
            system.restoring(to_row, to_col) += element.axial_stiffness(row, col);
        }
}

void add_beams(ShaftSystem& system, const Shaft& shaft)
{
    const std::vector<double> ends = section_ends(shaft);
    std::size_t section = 0;
    for (int node = 0; node + 1 < static_cast<int>(system.nodes.size()); ++node) {
        const auto at = static_cast<std::size_t>(node);
        const double begin = system.nodes[at];
        const double end = system.nodes[at + 1];
        while (0.5 * (begin + end) > ends[section + 1])
            ++section;
        const Section& piece = shaft.sections[section];
        add_beam(system, node,
                 {end - begin, piece.diameter, piece.bore, piece.density, shaft.youngs_modulus, shaft.poissons_ratio,
                  piece.shear_factor, shaft.axial_load});
    }
}

void add_disk(ShaftSystem& system, const Disk& disk)
{
    const int first = first_unknown(node_at(system, disk.position));
    system.mass(first, first) += disk.mass;
    system.mass(first + 1, first + 1) += disk.mass;
    system.mass(first + 2, first + 2) += disk.diametral_inertia;
    system.mass(first + 3, first + 3) += disk.diametral_inertia;
    system.gyroscopic(first + 2, first + 3) -= disk.polar_inertia;
    system.gyroscopic(first + 3, first + 2) += disk.polar_inertia;
}

/// A spring or damper between two points; the second may be the ground (-1).
void add_link(Matrix& matrix, int a, int b, const Matrix2& link)
{
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) {
            const double value = link[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
            matrix(a + i, a + j) += value;
            if (b >= 0) {
                matrix(b + i, b + j) += value;
                matrix(a + i, b + j) -= value;
                matrix(b + i, a + j) -= value;
            }
        }
}

void add_bearing(ShaftSystem& system, const Bearing& bearing, int& next_housing)
{
    BearingSeat seat{bearing.name, node_at(system, bearing.position), -1, bearing.stiffness, bearing.damping};
    if (bearing.support_stiffness) {
        seat.housing = next_housing;
        next_housing += 2;
        for (int i = 0; i < 2; ++i)
            system.mass(seat.housing + i, seat.housing + i) += bearing.housing_mass;
        add_link(system.restoring, seat.housing, -1, *bearing.support_stiffness);
        add_link(system.damping, seat.housing, -1, bearing.support_damping);
    }
    add_link(system.restoring, first_unknown(seat.node), seat.housing, seat.stiffness);
    add_link(system.damping, first_unknown(seat.node), seat.housing, seat.damping);
    system.bearings.push_back(seat);
}

}  // namespace

int node_at(const ShaftSystem& system, double position)
{
    const double tolerance = 2 * same_place * (system.nodes.back() - system.nodes.front());
    for (int node = 0; node < static_cast<int>(system.nodes.size()); ++node)
        if (std::abs(system.nodes[static_cast<std::size_t>(node)] - position) <= tolerance)
            return node;
    throw InputError(
        fmt::format("crankshaft: no node at {:g} mm\n  help: name this position when assembling", 1e3 * position));
}

ShaftSystem assemble(const Shaft& shaft, std::span<const double> more_positions)
{
    check_shaft(shaft);
    ShaftSystem system;
    system.nodes = node_positions(shaft, more_positions);
    system.modal_damping = shaft.modal_damping;
    const int shaft_unknowns = first_unknown(static_cast<int>(system.nodes.size()));
    const auto housings = std::count_if(shaft.bearings.begin(), shaft.bearings.end(),
                                        [](const Bearing& bearing) { return bearing.support_stiffness.has_value(); });
    const int size = shaft_unknowns + 2 * static_cast<int>(housings);
    system.mass = system.gyroscopic = system.stiffness = system.damping = Matrix(size, size);
    system.bending = system.restoring = Matrix(size, size);
    add_beams(system, shaft);
    for (const Disk& disk : shaft.disks)
        add_disk(system, disk);
    int next_housing = shaft_unknowns;
    for (const Bearing& bearing : shaft.bearings)
        add_bearing(system, bearing, next_housing);
    view(system.stiffness) = view(system.bending) + view(system.restoring);
    return system;
}

Matrix force_pattern(const ShaftSystem& system, double position, double width)
{
    Matrix pattern(system.size(), 2);
    if (!(width > 0)) {
        const int first = first_unknown(node_at(system, position));
        pattern(first, 0) = pattern(first + 1, 1) = 1.0;
        return pattern;
    }
    const int last = node_at(system, position + 0.5 * width);
    for (int node = node_at(system, position - 0.5 * width); node < last; ++node) {
        const auto at = static_cast<std::size_t>(node);
        const double length = system.nodes[at + 1] - system.nodes[at];
        const double share = 0.5 * length / width;
        const double moment = length * length / (12 * width);
        const int a = first_unknown(node);
        const int b = first_unknown(node + 1);
        for (int direction = 0; direction < 2; ++direction) {
            pattern(a + direction, direction) += share;
            pattern(b + direction, direction) += share;
        }
        pattern(a + 3, 0) += moment;  // tz = dx/ds
        pattern(b + 3, 0) -= moment;
        pattern(a + 2, 1) -= moment;  // ty = -dy/ds
        pattern(b + 2, 1) += moment;
    }
    return pattern;
}

std::vector<double> weight_pattern(const ShaftSystem& system, const Vec2& acceleration)
{
    Eigen::VectorXd motion = Eigen::VectorXd::Zero(system.size());
    for (int node = 0; node < static_cast<int>(system.nodes.size()); ++node) {
        motion[first_unknown(node)] = acceleration[0];
        motion[first_unknown(node) + 1] = acceleration[1];
    }
    for (const BearingSeat& seat : system.bearings)
        for (int i = 0; seat.housing >= 0 && i < 2; ++i)
            motion[seat.housing + i] = acceleration[static_cast<std::size_t>(i)];
    const Eigen::VectorXd load = view(system.mass) * motion;
    return {load.begin(), load.end()};
}

std::vector<Vec2> bearing_forces(const ShaftSystem& system, std::span<const double> displacement)
{
    std::vector<Vec2> forces;
    for (const BearingSeat& seat : system.bearings) {
        const auto at = static_cast<std::size_t>(first_unknown(seat.node));
        Vec2 relative{displacement[at], displacement[at + 1]};
        if (seat.housing >= 0) {
            const auto housing = static_cast<std::size_t>(seat.housing);
            relative = relative - Vec2{displacement[housing], displacement[housing + 1]};
        }
        forces.push_back({dot(seat.stiffness[0], relative), dot(seat.stiffness[1], relative)});
    }
    return forces;
}

}  // namespace deadpoint::crankshaft

#include "deadpoint/crankshaft/response/harmonic_response.hpp"

#include "deadpoint/crankshaft/response/dynamic_stiffness.hpp"
#include "deadpoint/crankshaft/shaft/shaft.hpp"
#include "deadpoint/crankshaft/shaft/system.hpp"
#include "deadpoint/error.hpp"

#include <fmt/format.h>
#include <numbers>

namespace deadpoint::crankshaft {
namespace {

using Complex = std::complex<double>;

}  // namespace

std::vector<std::complex<double>> harmonic_response(const ShaftSystem& system, double speed, double omega,
                                                    std::span<const std::complex<double>> force)
{
    if (static_cast<int>(force.size()) != system.size())
        throw InputError(
            fmt::format("crankshaft: the load has {} entries for {} unknowns", force.size(), system.size()));
    const Eigen::Map<const Eigen::VectorXcd> f(force.data(), static_cast<Eigen::Index>(force.size()));
    const Eigen::VectorXcd q = dynamic_stiffness(system, velocity_matrix(system, speed), omega).partialPivLu().solve(f);
    if (!q.allFinite())
        throw DomainError(fmt::format("crankshaft: undamped resonance at {:.6g} Hz\n  help: give a modal damping ratio",
                                      omega / (2 * std::numbers::pi)));
    return {q.begin(), q.end()};
}

std::vector<UnbalanceResponse> unbalance_response(const Shaft& shaft, std::span<const double> speeds)
{
    const ShaftSystem system = assemble(shaft);
    std::vector<Unbalance> sources = shaft.unbalances;
    for (const Disk& disk : shaft.disks)
        sources.push_back({disk.position, disk.unbalance, disk.unbalance_angle});
    std::vector<UnbalanceResponse> responses;
    for (const double speed : speeds) {
        std::vector<Complex> force(static_cast<std::size_t>(system.size()));
        for (const Unbalance& source : sources) {
            const auto first = static_cast<std::size_t>(first_unknown(node_at(system, source.position)));
            const Complex f = std::polar(source.magnitude * speed * speed, source.angle);
            force[first] += f;
            force[first + 1] += Complex(0, -1) * f;
        }
        const std::vector<Complex> q = harmonic_response(system, speed, speed, force);
        const auto at = [&](int unknown) { return q[static_cast<std::size_t>(unknown)]; };
        UnbalanceResponse response;
        response.speed = speed;
        for (int node = 0; node < static_cast<int>(system.nodes.size()); ++node) {
            response.x.push_back(at(first_unknown(node)));
            response.y.push_back(at(first_unknown(node) + 1));
        }
        for (const BearingSeat& seat : system.bearings) {
            Complex x = at(first_unknown(seat.node));
            Complex y = at(first_unknown(seat.node) + 1);
            if (seat.housing >= 0) {
                x -= at(seat.housing);
                y -= at(seat.housing + 1);
            }
            const auto row = [&](std::size_t i) {
                return (seat.stiffness[i][0] + Complex(0, speed) * seat.damping[i][0]) * x +
                       (seat.stiffness[i][1] + Complex(0, speed) * seat.damping[i][1]) * y;
            };
            response.bearing_x.push_back(row(0));
            response.bearing_y.push_back(row(1));
        }
        responses.push_back(std::move(response));
    }
    return responses;
}

}  // namespace deadpoint::crankshaft

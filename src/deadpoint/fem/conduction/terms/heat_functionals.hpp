#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/fem/space/discretisation.hpp"
#include "deadpoint/heat/functionals.hpp"

#include <functional>
#include <span>
#include <vector>

namespace deadpoint {
struct HeatProblem;
struct InterfaceLaw;
}  // namespace deadpoint

/// Internal to fem/: the functionals of a heat problem by unknowns.
namespace deadpoint::fem {

/// Value at a point, from all ranks' `values` by unknown.
double value_at(const PointShape& shape, const double* values);
/// The shape functions that do not vanish; on a face, those of nodes off the face vanish.
PointShape without_zeros(const PointShape& shape);

class HeatFunctionals {
public:
    HeatFunctionals(const Discretisation& space, const HeatProblem& problem);

    /// Adopts the probes of another problem on the same surfaces.
    void adopt(const HeatProblem& problem);
    /// Builds the load zones of interfaces with these laws.
    /// @throws DomainError if a load zone covers nothing of its interface
    void set_zones(const std::vector<InterfaceLaw>& laws);

    [[nodiscard]] const heat::HeatGeometry& geometry() const { return geometry_; }
    [[nodiscard]] const std::vector<double>& part_volume() const { return part_volume_; }  ///< [m3]
    [[nodiscard]] const SparseFunctional& operator[](std::size_t functional) const { return all_[functional]; }
    /// Values at a vector, of all ranks.
    [[nodiscard]] std::vector<double> evaluate(std::span<const std::size_t> which, Vec vector) const;
    /// Adds watts by functional to a vector of watts by unknown.
    void add_loads(const std::vector<double>& watts, Vec vector) const;

private:
    void prepare_parts();
    void prepare_interfaces();
    void prepare_surfaces(const HeatProblem& problem);
    void prepare_bodies(const HeatProblem& problem);
    void prepare_probes(const HeatProblem& problem);
    void prepare_zone(std::size_t interface, const InterfaceLaw& law);
    void prepare_volume_zone(std::size_t interface, const InterfaceLaw& law);
    void prepare_film_zone(std::size_t interface, const InterfaceLaw& law);
    void require_zone(std::size_t interface, double whole) const;
    /// Visits the integration points of a part's cells with their weights [m3].
    void for_each_point(int part, const std::function<void(const Vec3&, double, const PointShape&)>& visit) const;

    const Discretisation& space_;
    heat::HeatGeometry geometry_;
    std::vector<double> part_volume_;
    std::vector<SparseFunctional> all_;  ///< in the order of the layout
};

}  // namespace deadpoint::fem

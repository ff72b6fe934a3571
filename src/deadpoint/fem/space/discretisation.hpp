#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/fem/algebra/couplings.hpp"
#include "deadpoint/fem/algebra/petsc.hpp"
#include "deadpoint/fem/reference/quadrature.hpp"
#include "deadpoint/fem/space/cell_maps.hpp"
#include "deadpoint/fem/space/unknowns.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace deadpoint {
struct ContactPoint;
struct Machine;
}  // namespace deadpoint

/// Internal to fem/: the scalar finite-element space on all parts, shared by heat and (three times) deformation.
namespace deadpoint::fem {

inline constexpr int max_cell_dofs = 27;

/// The shape functions of one cell at one point.
struct PointShape {
    int count = 0;
    std::array<PetscInt, max_cell_dofs> dof{};
    std::array<double, max_cell_dofs> value{};
    std::array<std::array<double, 3>, max_cell_dofs> gradient{};
};

/// A linear functional by this rank's unknowns.
struct SparseFunctional {
    std::vector<PetscInt> local;  ///< counted from the first owned unknown
    std::vector<double> weight;
};

class Discretisation {
public:
    /// @param orders  of the elements, 1 or 2, per part
    Discretisation(const Machine& machine, std::vector<int> orders);

    Discretisation(const Discretisation&) = delete;

    const Machine& machine;
    std::vector<int> orders;                 ///< per part
    std::vector<ReferenceElement> elements;  ///< by CellMaps::element_index()
    std::vector<Quadrature> quadratures;     ///< the same
    CellMaps maps;
    std::uint32_t first_cell = 0;  ///< owned cells: first_cell <= i < end_cell
    std::uint32_t end_cell = 0;
    PetscInt first = 0;  ///< owned unknowns: first <= i < last
    PetscInt last = 0;
    PetscInt total = 0;

    [[nodiscard]] bool owns_cell(std::uint32_t cell) const { return cell >= first_cell && cell < end_cell; }
    [[nodiscard]] bool owns(PetscInt dof) const { return dof >= first && dof < last; }
    /// Shape functions (and gradients, if asked) of the cell behind an exterior face, at a point of it.
    void evaluate(std::uint32_t face, const Vec3& position, bool gradients, PointShape& shape) const;
    /// The same for the cell of `part` that holds `position` (the nearest one if none does).
    void evaluate_in_part(int part, const Vec3& position, PointShape& shape) const;
    /// Shape functions of a cell extrapolated to a point that may lie outside; returns the distance
    /// as a share of the cell's size.
    double continue_cell(std::uint32_t cell, const Vec3& position, PointShape& shape) const;
    /// Couplings of this rank's unknowns within cells.
    [[nodiscard]] Couplings cell_couplings() const;
    void add_bond_couplings(Couplings& couplings) const;
    /// Couples the cells on both sides of each point.
    void add_couplings_across(const std::vector<ContactPoint>& points, Couplings& couplings) const;
    /// In the order of the element's shape functions.
    void unknowns_of(std::uint32_t cell, std::vector<PetscInt>& unknowns) const { unknowns_.of(cell, unknowns); }
    [[nodiscard]] std::vector<PetscInt> unknowns_of(std::uint32_t cell) const;
    [[nodiscard]] int part_of(std::uint32_t cell) const;
    [[nodiscard]] const ReferenceElement& element(std::uint32_t cell) const
    {
        return elements[maps.element_index(cell)];
    }
    /// Positions of the owned unknowns.
    [[nodiscard]] std::vector<Vec3> support_points() const;
    /// Part of each owned unknown.
    [[nodiscard]] std::vector<std::uint32_t> part_of_unknown() const;
    /// Unknowns of a cell, and their positions (written into `position` by unknown).
    void cell_nodes(std::uint32_t cell, std::vector<std::size_t>& unknowns, std::vector<Vec3>& position) const;
    /// Position of the i-th unknown of a cell.
    [[nodiscard]] Vec3 node_position(std::uint32_t cell, unsigned i) const;
    /// Unknown at a node of a cell (node numbered as in Cell::nodes).
    [[nodiscard]] std::size_t vertex_unknown(std::uint32_t cell, unsigned node) const;
    /// Turns (unknown, weight) pairs of any rank into this rank's functional.
    [[nodiscard]] SparseFunctional functional(const std::vector<std::pair<PetscInt, double>>& entries) const;
    /// Cell size normal to a face: volume over area [m].
    [[nodiscard]] double depth(std::uint32_t face) const { return depth_[face]; }
    /// Shape functions of a cell at a point of its reference cell, or beside it.
    void evaluate_at(std::uint32_t cell, const Vec3& unit, bool gradients, PointShape& shape) const;
    /// How far beside its reference cell a point lies.
    [[nodiscard]] double distance_outside(std::uint32_t cell, const Vec3& unit) const
    {
        return norm(unit - maps.nearest_inside(cell, unit));
    }

private:
    void number_neighbours_alike();

    Unknowns unknowns_;
    std::vector<double> depth_;
};

/// Sums over the ranks, in place.
void sum_over_ranks(std::vector<double>& values);
/// Inner products of functionals with a vector, summed over the ranks.
std::vector<double> evaluate(const std::vector<const SparseFunctional*>& functionals, Vec vector);
void add_to(Vec vector, const SparseFunctional& functional, double factor);

/// A matrix of zeros at the given places.
/// @param rows  this rank's, by row counted from its first
OwnedMat create_matrix(const SparseRows& rows);
OwnedVec create_vector(const Discretisation& space, int block);

/// All ranks' entries of a field with `block` values per unknown, on every rank.
std::vector<double> gather_all(const Discretisation& space, const std::vector<double>& owned, int block);

/// One integration point of a bond between two cells.
struct BondPoint {
    PointShape a;
    PointShape b;
    Vec3 normal{};
    double weight = 0;
};
/// The points that two cells share, with the data of both sides for Nitsche's method.
struct BondPair {
    std::vector<BondPoint> points;
    int part_a = 0;
    int part_b = 0;
    double depth_a = 0;  ///< cell size normal to the face [m]
    double depth_b = 0;
};
/// Calls visit for each pair of bonded cells of which this rank owns cell a.
void for_each_bond_pair(const Discretisation& space, const std::function<void(const BondPair&)>& visit);

/// A gathered vector: the entries of all ranks, on every rank.
class Gathered {
public:
    explicit Gathered(Vec pattern) { DEADPOINT_PETSC(VecScatterCreateToAll(pattern, scatter_.out(), all_.out())); }
    const double* gather(Vec vector);
    ~Gathered();

private:
    OwnedScatter scatter_;
    OwnedVec all_;
    const double* values_ = nullptr;
};

}  // namespace deadpoint::fem

#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/laws/material.hpp"
#include "deadpoint/exchange/stress.hpp"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// Internal to fem/: stress at nodes from a displacement field.
namespace deadpoint::fem {

class Discretisation;

/// Fields of all ranks, by unknown.
struct StrainedState {
    const double* displacement = nullptr;  ///< three per unknown [m]
    const double* rise = nullptr;          ///< as Model::expansion_rise() [K]; null: no thermal strain
    std::vector<Tensor6> initial;          ///< initial strain per part; empty: none
};

/// Stress of one part by superconvergent patch recovery (Zienkiewicz and Zhu, Int. J. Numer. Meth.
/// Engng 33, 1992): around each node a polynomial of the elements' degree is fitted to the stress
/// at the most accurate points of the cells (the centres of first-order cells, the Gauss points of
/// second-order cells), and evaluated at the node. If the cells of a node do not determine the
/// polynomial (at faces and edges of the part), the fit includes their neighbours.
///
/// Where the part is a single layer of first-order cells, the slope through that layer is the mean
/// of the slopes within the cells. The same on all ranks.
class StressRecovery {
public:
    StressRecovery(const Discretisation& space, const Material& material, int part, const StrainedState& state);

    /// Nodes of the part, as indices into Machine::nodes.
    [[nodiscard]] const std::vector<std::uint32_t>& nodes() const { return nodes_; }
    /// At one of them, by its place in nodes().
    [[nodiscard]] Tensor6 at_node(std::size_t node) const;
    /// At a point of the part: the polynomial of the nearest node.
    [[nodiscard]] Tensor6 at(const Vec3& position) const;

private:
    using Six = Eigen::Matrix<double, 6, 1>;
    using Moment = Eigen::Matrix3d;
    using Slope = Eigen::Matrix<double, 6, 3>;
    struct Sample {
        Eigen::Vector3d position;
        Six stress;
    };
    struct CellData {
        std::size_t first = 0, count = 0;  ///< of its samples
        Moment spread = Moment::Zero();    ///< mean of dx dx^T within the cell [m2]
        Slope slope = Slope::Zero();       ///< of the stress within the cell [Pa/m]
        bool quadratic = false;
        std::array<std::uint32_t, 8> nodes{};  ///< places in nodes()
        unsigned node_count = 0;
    };
    void number_nodes();
    void sample(const Material& material, const StrainedState& state);
    void find_slope(CellData& cell, std::span<const Sample> points) const;
    [[nodiscard]] std::vector<std::uint32_t> with_neighbours(const std::vector<std::uint32_t>& patch) const;
    /// Moments of the sample positions of a patch.
    struct Spread {
        Eigen::Vector3d centre = Eigen::Vector3d::Zero();
        Six mean = Six::Zero();
        Moment within = Moment::Zero();  ///< sum of the cells' own [m2]
        /// Directions e with  between e = ratio within e,  e . within e = 1, "between" being the moment of the samples.
        Moment direction = Moment::Zero();
        Eigen::Vector3d ratio = Eigen::Vector3d::Zero();
        Eigen::Array<bool, 3, 1> told_apart{};  ///< several cells lie along that direction
    };
    [[nodiscard]] Spread spread_of(const std::vector<std::uint32_t>& patch) const;
    /// Linear fit in directions in which several cells determine the slope; in the others, the
    /// slopes within the cells.
    [[nodiscard]] Six fit_linear(const std::vector<std::uint32_t>& patch, const Spread& spread,
                                 const Eigen::Vector3d& where) const;
    [[nodiscard]] bool fit_quadratic(const std::vector<std::uint32_t>& patch, const Spread& spread,
                                     const Eigen::Vector3d& where, Six& value) const;
    [[nodiscard]] Tensor6 recover(std::size_t node, const Vec3& where) const;

    const Discretisation& space_;
    int part_;
    std::vector<std::uint32_t> nodes_;
    std::vector<std::vector<std::uint32_t>> cells_of_node_;
    std::vector<CellData> cells_;
    std::vector<Sample> samples_;
};

}  // namespace deadpoint::fem

#include "deadpoint/fem/elastic/tie_conditions.hpp"

#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/elastic/dual_functions.hpp"
#include "deadpoint/fem/elastic/tie.hpp"
#include "deadpoint/fem/space/discretisation.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <set>

namespace deadpoint::fem {
namespace {

constexpr double largest_tie_continuation = 0.1;
constexpr double negligible = 1e-12;

using Weights = std::map<PetscInt, double>;

/// A face of the finer part and the area that bonds cover.
struct BondedFace {
    const std::vector<BondedPoint>* points = nullptr;
    std::uint32_t geometry = 0;
    std::vector<PetscInt> nodes;
    CoveredFace covered;
    std::vector<int> chosen;  ///< indices into `nodes` of the nodes with a dual function
    Eigen::MatrixXd dual;     ///< values of the dual functions at the points
};

/// A node on bonds: its masters point by point, and the surface of its dual function.
struct Candidate {
    std::optional<Tie> at_its_place;
    std::uint32_t geometry = 0;
    bool by_mean = true;
};

class PartTies {
public:
    PartTies(const Discretisation& space, const BondedFaces& faces) : space_(space)
    {
        for (const auto& [face, points] : faces)
            add_face(face, points);
        find_candidates();
        find_dual_functions();
    }

    std::vector<Tie> ties()
    {
        std::vector<Tie> result;
        for (auto& [node, candidate] : candidates_)
            if (candidate.at_its_place && !candidate.by_mean)
                result.push_back(std::move(*candidate.at_its_place));
        add_means(result);
        return result;
    }

private:
    void add_face(std::uint32_t face, const std::vector<BondedPoint>& points)
    {
        BondedFace added;
        added.points = &points;
        added.geometry = space_.machine.faces[face].geometry;
        std::vector<PointShape> shapes(points.size());
        for (std::size_t q = 0; q < points.size(); ++q) {
            space_.evaluate(face, points[q].position(), false, shapes[q]);
            for (int i = 0; i < shapes[q].count; ++i)
                if (std::abs(shapes[q].value[i]) > 1e-9 && !std::ranges::count(added.nodes, shapes[q].dof[i]))
                    added.nodes.push_back(shapes[q].dof[i]);
        }
        const auto rows = static_cast<Eigen::Index>(points.size());
        added.covered.shape.setZero(rows, static_cast<Eigen::Index>(added.nodes.size()));
        added.covered.weight.resize(rows);
        for (Eigen::Index q = 0; q < rows; ++q) {
            const auto& shape = shapes[static_cast<std::size_t>(q)];
            added.covered.weight[q] = points[static_cast<std::size_t>(q)].point->weight;
            for (int i = 0; i < shape.count; ++i)
                if (const auto at = std::ranges::find(added.nodes, shape.dof[i]); at != added.nodes.end())
                    added.covered.shape(q, at - added.nodes.begin()) = shape.value[i];
        }
        space_.cell_nodes(space_.machine.faces[face].cell, unknowns_, positions_);
        faces_.push_back(std::move(added));
    }

    /// Surfaces on bonds, largest first. A node on two of them belongs to the first, so conditions on the
    /// first contain no other node that a condition on the second defines.
    [[nodiscard]] std::vector<std::uint32_t> by_area() const
    {
        std::map<std::uint32_t, double> area;
        for (const auto& face : faces_)
            area[face.geometry] += face.covered.weight.sum();
        std::vector<std::uint32_t> geometries;
        for (const auto& [geometry, covered] : area)
            geometries.push_back(geometry);
        std::ranges::stable_sort(geometries, std::greater<>(), [&](auto g) { return area.at(g); });
        return geometries;
    }

    void find_candidates()
    {
        struct Met {
            std::map<std::uint32_t, int> cells;  // with the bond
            std::map<int, Vec3> normals;         // by bond, not of unit length
            std::set<std::uint32_t> surfaces;
        };
        std::map<PetscInt, Met> met;
        for (const auto& face : faces_)
            for (std::size_t i = 0; i < face.nodes.size(); ++i) {
                auto& node = met[face.nodes[i]];
                const auto shape = face.covered.shape.col(static_cast<Eigen::Index>(i));
                node.surfaces.insert(face.geometry);
                for (std::size_t q = 0; q < face.points->size(); ++q) {
                    if (std::abs(shape[static_cast<Eigen::Index>(q)]) <= 1e-9)
                        continue;
                    const auto& at = (*face.points)[q];
                    node.cells.emplace(space_.machine.faces[at.other_face()].cell, at.bond);
                    auto& normal = node.normals[at.bond];
                    normal = normal + at.normal();
                }
            }
        const auto geometries = by_area();
        for (const auto& [node, found] : met) {
            Candidate candidate;
            candidate.geometry = *std::ranges::find_if(
                geometries, [&surfaces = found.surfaces](auto g) { return surfaces.contains(g); });
            candidate.at_its_place = follow_at_its_place(node, found.cells);
            if (candidate.at_its_place) {
                auto& opening = candidate.at_its_place->openings[0];
                opening.normal = normalised(found.normals.at(opening.bond));
            }
            candidates_.emplace(node, std::move(candidate));
        }
    }

    std::optional<Tie> follow_at_its_place(PetscInt node, const std::map<std::uint32_t, int>& cells) const
    {
        double least = largest_tie_continuation;
        PointShape shape, best;
        int followed = -1;
        for (const auto& [cell, bond] : cells) {
            const double outside = space_.continue_cell(cell, positions_[static_cast<std::size_t>(node)], shape);
            if (outside < least) {
                least = outside;
                best = shape;
                followed = bond;
            }
        }
        if (followed < 0)
            return std::nullopt;
        Tie tie{node, {}, {{followed, {}}}};
        for (int i = 0; i < best.count; ++i)
            if (std::abs(best.value[i]) >= negligible)
                tie.masters.emplace_back(best.dof[i], best.value[i]);
        return tie;
    }

    // If a face defines no dual functions, its node with the smallest integral is tied at its own position instead.
    void find_dual_functions()
    {
        std::vector<std::size_t> open(faces_.size());
        for (std::size_t f = 0; f < open.size(); ++f)
            open[f] = f;
        while (!open.empty()) {
            std::set<PetscInt> given_up;
            for (const auto f : open)
                if (const auto node = define_duals(faces_[f]))
                    given_up.insert(*node);
            for (const auto node : given_up)
                candidates_.at(node).by_mean = false;
            open.clear();
            for (std::size_t f = 0; f < faces_.size(); ++f)
                if (std::ranges::any_of(faces_[f].chosen, [&](int i) {
                        return given_up.contains(faces_[f].nodes[static_cast<std::size_t>(i)]);
                    }))
                    open.push_back(f);
        }
    }

    std::optional<PetscInt> define_duals(BondedFace& face)
    {
        face.chosen.clear();
        double least = std::numeric_limits<double>::max();
        PetscInt weakest = -1;
        for (std::size_t i = 0; i < face.nodes.size(); ++i) {
            const auto& candidate = candidates_.at(face.nodes[i]);
            if (!candidate.at_its_place || !candidate.by_mean || candidate.geometry != face.geometry)
                continue;
            face.chosen.push_back(static_cast<int>(i));
            const double integral = face.covered.shape.col(static_cast<Eigen::Index>(i)).dot(face.covered.weight);
            if (integral < least) {
                least = integral;
                weakest = face.nodes[i];
            }
        }
        if (face.chosen.empty())
            return std::nullopt;
        if (auto dual = dual_functions(face.covered, face.chosen)) {
            face.dual = std::move(*dual);
            return std::nullopt;
        }
        return weakest;
    }

    /// Sums of one node's condition.
    struct Mean {
        double integral = 0;
        Weights weights;
        std::map<int, Vec3> openings;
    };

    void add_to_means(const BondedFace& face, std::map<PetscInt, Mean>& means) const
    {
        PointShape other;
        const std::set<int> chosen(face.chosen.begin(), face.chosen.end());
        for (std::size_t q = 0; q < face.points->size(); ++q) {
            const auto& at = (*face.points)[q];
            const auto row = static_cast<Eigen::Index>(q);
            const auto cell = space_.machine.faces[at.other_face()].cell;
            if (space_.continue_cell(cell, at.position(), other) > 1)
                space_.evaluate(at.other_face(), at.other_position(), false, other);
            for (std::size_t k = 0; k < face.chosen.size(); ++k) {
                const auto i = static_cast<std::size_t>(face.chosen[k]);
                auto& mean = means[face.nodes[i]];
                const double weight = face.covered.weight[row];
                const double dual = weight * face.dual(row, static_cast<Eigen::Index>(k));
                mean.integral += weight * face.covered.shape(row, face.chosen[k]);
                auto& opening = mean.openings[at.bond];
                opening = opening + dual * at.normal();
                for (int m = 0; m < other.count; ++m)
                    if (std::abs(other.value[m]) >= negligible)
                        mean.weights[other.dof[m]] += dual * other.value[m];
                for (std::size_t n = 0; n < face.nodes.size(); ++n)
                    if (!chosen.contains(static_cast<int>(n)))
                        mean.weights[face.nodes[n]] -= dual * face.covered.shape(row, static_cast<Eigen::Index>(n));
            }
        }
    }

    void add_means(std::vector<Tie>& result) const
    {
        for (const auto geometry : by_area()) {
            std::map<PetscInt, Mean> means;
            for (const auto& face : faces_)
                if (face.geometry == geometry && !face.chosen.empty())
                    add_to_means(face, means);
            for (const auto& [node, mean] : means) {
                Tie tie{node, {}, {}};
                for (const auto& [master, weight] : mean.weights)
                    if (std::abs(weight) >= negligible * mean.integral)
                        tie.masters.emplace_back(master, weight / mean.integral);
                for (const auto& [bond, normal] : mean.openings)
                    tie.openings.push_back({bond, (1 / mean.integral) * normal});
                result.push_back(std::move(tie));
            }
        }
    }

    const Discretisation& space_;
    std::vector<BondedFace> faces_;
    std::map<PetscInt, Candidate> candidates_;
    std::vector<std::size_t> unknowns_;
    std::vector<Vec3> positions_{static_cast<std::size_t>(space_.total)};  ///< positions of the nodes found so far
};

}  // namespace

std::vector<Tie> ties_of_part(const Discretisation& space, const BondedFaces& faces)
{
    return PartTies(space, faces).ties();
}

}  // namespace deadpoint::fem

#include "deadpoint/drift/tilt.hpp"

#include "deadpoint/drift/chain.hpp"
#include "deadpoint/drift/contact_side.hpp"
#include "deadpoint/exchange/linkage.hpp"

#include <Eigen/Dense>
#include <algorithm>

namespace deadpoint::drift {
namespace {

constexpr double rank_cutoff = 1e-9;

Vec3 centroid(const std::vector<std::vector<SurfacePoint>>& surfaces)
{
    Vec3 sum{};
    double area = 0;
    for (const auto& points : surfaces)
        for (const auto& p : points) {
            sum = sum + p.weight * p.position;
            area += p.weight;
        }
    return (1 / area) * sum;
}

// Values of all shapes of the fit at a point: shifts along x, y, z; rotations about x, y, z, times the length unit;
// growth and taper of each surface.
class Shapes {
public:
    Shapes(const Machine& machine, const std::vector<ContactSide>& sides, bool symmetric) : symmetric_(symmetric)
    {
        for (const auto& side : sides) {
            surfaces.push_back(points_of(machine, side));
            cylinders_.push_back(std::get_if<CylinderGeometry>(&machine.interfaces[side.contact].geometry));
        }
        centre_ = centroid(surfaces);
        double square = 0, area = 0;
        for (std::size_t s = 0; s < surfaces.size(); ++s) {
            centres_.push_back(centroid({surfaces[s]}));
            for (const auto& p : surfaces[s]) {
                const auto arm = p.position - centre_;
                square += p.weight * dot(arm, arm);
                area += p.weight;
            }
        }
        length = std::sqrt(square / area);
    }

    [[nodiscard]] Eigen::Index count() const { return 6 + 2 * static_cast<Eigen::Index>(surfaces.size()); }
    [[nodiscard]] Eigen::VectorXd at(std::size_t surface, const SurfacePoint& p) const
    {
        Eigen::VectorXd values = Eigen::VectorXd::Zero(count());
        const Vec3 moment = (1 / length) * cross(p.position - centre_, p.normal);
        for (int c = 0; c < 3; ++c) {
            const bool kept_shift = !symmetric_ || c != 0, kept_turn = !symmetric_ || c == 0;
            values[c] = kept_shift ? p.normal[c] : 0;
            values[3 + c] = kept_turn ? moment[c] : 0;
        }
        const auto first = 6 + 2 * static_cast<Eigen::Index>(surface);
        values[first] = 1;
        if (const auto* cylinder = cylinders_[surface])
            values[first + 1] = dot(cylinder->axis, p.position - centres_[surface]) / length;
        return values;
    }

    std::vector<std::vector<SurfacePoint>> surfaces;
    double length = 0;

private:
    bool symmetric_;
    Vec3 centre_{};
    std::vector<Vec3> centres_;
    std::vector<const CylinderGeometry*> cylinders_;
};

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& symmetric)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
    const double cutoff = rank_cutoff * solver.eigenvalues().maxCoeff();
    const Eigen::VectorXd inverse =
        solver.eigenvalues().unaryExpr([&](double value) { return value > cutoff ? 1 / value : 0.0; });
    return solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
}

}  // namespace

std::optional<TiltFit> fit_tilt(const Machine& machine, const std::vector<ContactSide>& sides, const Vec3& axis,
                                bool symmetric)
{
    if (sides.empty())
        return std::nullopt;
    const Shapes shapes(machine, sides, symmetric);
    Eigen::MatrixXd normal_matrix = Eigen::MatrixXd::Zero(shapes.count(), shapes.count());
    for (std::size_t s = 0; s < sides.size(); ++s)
        for (const auto& p : shapes.surfaces[s]) {
            const auto values = shapes.at(s, p);
            normal_matrix += p.weight * values * values.transpose();
        }
    const Eigen::MatrixXd inverse = pseudo_inverse(normal_matrix);
    Eigen::VectorXd wanted = Eigen::VectorXd::Zero(shapes.count());
    for (Eigen::Index c = 0; c < 3; ++c)
        wanted[3 + c] = axis[static_cast<std::size_t>(c)];
    const Eigen::VectorXd solved = inverse * wanted;
    if ((normal_matrix * solved - wanted).norm() > 1e-6)
        return std::nullopt;
    TiltFit fit;
    fit.information = shapes.length * shapes.length / wanted.dot(solved);
    for (std::size_t s = 0; s < sides.size(); ++s)
        for (const auto& p : shapes.surfaces[s]) {
            const double coefficient = p.weight * solved.dot(shapes.at(s, p)) / shapes.length;
            fit.angle.points.push_back({p.face, p.position, coefficient * p.normal});
        }
    return fit;
}

TiltClosure::TiltClosure(const Machine& machine, const Linkage& linkage, const BottomDeadPointSensitivity& sensitivity,
                         const ChainDescription& chain)
    : ground_(linkage.ground), held_(linkage.bodies.size(), false)
{
    for (std::size_t j = 0; j < linkage.joints.size(); ++j) {
        const auto& surfaces = chain.joints[j];
        if (!surfaces.passes_tilt)
            continue;
        const auto fit = [&](const std::vector<ContactSide>& sides) {
            const bool symmetric = std::ranges::all_of(sides, [&](const auto& side) {
                return on_symmetry_plane(machine, side, sensitivity.joint_centres[j]);
            });
            return fit_tilt(machine, sides, right_of(linkage), symmetric);
        };
        const auto in_a = fit(surfaces.in_a), in_b = fit(surfaces.in_b);
        if (!in_a || !in_b)
            continue;
        Link link{
            linkage.joints[j].body_a, linkage.joints[j].body_b, std::min(in_a->information, in_b->information), {}};
        add(link.mismatch, 1, in_b->angle);
        add(link.mismatch, -1, in_a->angle);
        links_.push_back(std::move(link));
    }
    held_[static_cast<std::size_t>(ground_)] = true;
    for (bool found = true; found;) {
        found = false;
        for (const auto& link : links_)
            if (held_[link.body_a] != held_[link.body_b])
                held_[link.body_a] = held_[link.body_b] = found = true;
    }
}

bool TiltClosure::holds(int body) const { return held_[static_cast<std::size_t>(body)]; }

// L x = load with the matrix of the least squares, symmetric; rows of the ground and of bodies not held are left out.
std::vector<double> TiltClosure::solve(std::vector<double> load) const
{
    const auto size = static_cast<Eigen::Index>(held_.size());
    const auto moves = [&](int body) { return body != ground_ && holds(body); };
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(size, size);
    for (int body = 0; body < size; ++body)
        if (moves(body))
            matrix(body, body) = 0;
        else
            load[static_cast<std::size_t>(body)] = 0;
    for (const auto& link : links_) {
        const int a = link.body_a, b = link.body_b;
        if (moves(a))
            matrix(a, a) += link.information;
        if (moves(b))
            matrix(b, b) += link.information;
        if (moves(a) && moves(b)) {
            matrix(a, b) -= link.information;
            matrix(b, a) -= link.information;
        }
    }
    const Eigen::VectorXd x = matrix.ldlt().solve(Eigen::Map<const Eigen::VectorXd>(load.data(), size));
    return {x.begin(), x.end()};
}

Functional TiltClosure::combine(const std::vector<double>& factors) const
{
    const auto weight = solve(factors);
    Functional result;
    for (const auto& link : links_)
        if (held_[link.body_a])
            add(result, -link.information * (weight[link.body_b] - weight[link.body_a]), link.mismatch);
    return result;
}

}  // namespace deadpoint::drift

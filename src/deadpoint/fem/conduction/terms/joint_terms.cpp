#include "deadpoint/fem/conduction/terms/joint_terms.hpp"

#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/conduction/terms/heat_functionals.hpp"
#include "deadpoint/heat/films.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace deadpoint::fem {
namespace {

double axial(const FaceGeometry& geometry, const Vec3& position)
{
    const auto* cylinder = std::get_if<CylinderGeometry>(&geometry);
    return cylinder ? dot(cylinder->axis, position - cylinder->point) : 0.0;
}

// The integrated side's layers along the axis: one strip each.
class AxialStrips {
public:
    AxialStrips(const Machine& machine, const Contact& contact) : geometry_(contact.geometry)
    {
        std::set<std::uint32_t> nodes;
        for (const auto& point : contact.points) {
            const auto& face = machine.faces[point.face_a];
            nodes.insert(face.nodes.begin(), face.nodes.begin() + face.node_count);
        }
        for (const auto node : nodes)
            edges_.push_back(axial(geometry_, machine.nodes[node]));
        std::sort(edges_.begin(), edges_.end());
        edges_.erase(std::unique(edges_.begin(), edges_.end(), [](double a, double b) { return b - a < 1e-7; }),
                     edges_.end());
        std::vector<double> weight(count(), 0.0);
        middle_.assign(count(), 0.0);
        for (const auto& point : contact.points) {
            const auto strip = find(point);
            weight[strip] += point.weight;
            middle_[strip] += point.weight * axial(geometry_, point.position_a);
        }
        for (std::size_t s = 0; s < count(); ++s)
            middle_[s] /= std::max(weight[s], 1e-300);
    }

    [[nodiscard]] std::size_t count() const { return edges_.size() > 1 ? edges_.size() - 1 : 1; }
    [[nodiscard]] std::size_t find(const ContactPoint& point) const
    {
        const double z = axial(geometry_, point.position_a);
        const auto above = std::upper_bound(edges_.begin(), edges_.end(), z) - edges_.begin();
        return static_cast<std::size_t>(
            std::clamp<std::ptrdiff_t>(above - 1, 0, static_cast<std::ptrdiff_t>(count()) - 1));
    }
    // z is relative to the centroid of the contact in the strip. So the modes 1 and z are orthogonal there, even where
    // the other side covers the strip only in part.
    [[nodiscard]] double from_middle(std::size_t strip, const ContactPoint& point) const
    {
        return axial(geometry_, point.position_a) - middle_[strip];
    }

private:
    const FaceGeometry& geometry_;
    std::vector<double> edges_;
    std::vector<double> middle_;
};

// Calls visit(interface, law) for the laws of all segments.
template <class Visit>
void for_each_law(const HeatProblem& problem, const Visit& visit)
{
    for (const auto& segment : problem.segments) {
        const auto& laws = segment.interfaces.empty() ? problem.interfaces : segment.interfaces;
        for (std::size_t i = 0; i < laws.size(); ++i)
            visit(i, laws[i]);
    }
}

}  // namespace

JointCoefficients coefficients_of(const InterfaceLaw& law)
{
    const double sum = law.film_a + law.film_b + law.oil;
    const double between = -law.film_a * law.film_b / sum;
    return {law.film_a * (sum - law.film_a) / sum, law.film_b * (sum - law.film_b) / sum, law.turns_fully ? 0 : between,
            law.turns_fully ? between : 0};
}

JointTerms::JointTerms(const Discretisation& space, const HeatProblem& problem) : space_(space)
{
    const std::size_t count = space.machine.interfaces.size();
    terms_.resize(count);
    strips_.resize(count);
    across_.assign(count, false);
    std::vector<bool> turning(count, false);
    for_each_law(problem, [&](std::size_t i, const InterfaceLaw& law) {
        if (law.turns_fully)
            turning[i] = true;
        else
            across_[i] = true;
    });
    for (std::size_t i = 0; i < count; ++i) {
        integrate(i, across_[i]);
        if (turning[i])
            integrate_turning(i);
    }
}

void JointTerms::integrate(std::size_t i, bool across)
{
    auto& term = terms_[i];
    PointShape a, b;
    for (const auto& point : space_.machine.interfaces[i].points) {
        if (!space_.owns_cell(space_.machine.faces[point.face_a].cell))
            continue;
        space_.evaluate(point.face_a, point.position_a, false, a);
        space_.evaluate(point.face_b, point.position_b, false, b);
        const auto on_a = without_zeros(a), on_b = without_zeros(b);
        term.aa.add(on_a, on_a, point.weight);
        term.bb.add(on_b, on_b, point.weight);
        if (across) {
            term.across.add(on_a, on_b, point.weight);
            term.across.add(on_b, on_a, point.weight);
        }
    }
    term.aa.finish();
    term.bb.finish();
    term.across.finish();
}

std::vector<JointTerms::Strip> JointTerms::strips_of(const Contact& contact) const
{
    const AxialStrips layers(space_.machine, contact);
    std::vector<Strip> strips(layers.count());
    std::vector<std::map<PetscInt, std::array<double, 2>>> moments_a(strips.size()), moments_b(strips.size());
    PointShape a, b;
    for (const auto& point : contact.points) {
        space_.evaluate(point.face_a, point.position_a, false, a);
        space_.evaluate(point.face_b, point.position_b, false, b);
        const auto s = layers.find(point);
        const std::array<double, 2> mode{1, layers.from_middle(s, point)};
        for (int m = 0; m < 2; ++m) {
            strips[s].norm[m] += point.weight * mode[m] * mode[m];
            for (int k = 0; k < a.count; ++k)
                moments_a[s][a.dof[k]][m] += point.weight * mode[m] * a.value[k];
            for (int k = 0; k < b.count; ++k)
                moments_b[s][b.dof[k]][m] += point.weight * mode[m] * b.value[k];
        }
    }
    for (std::size_t s = 0; s < strips.size(); ++s) {
        strips[s].a.assign(moments_a[s].begin(), moments_a[s].end());
        strips[s].b.assign(moments_b[s].begin(), moments_b[s].end());
    }
    return strips;
}

void JointTerms::integrate_turning(std::size_t i)
{
    strips_[i] = strips_of(space_.machine.interfaces[i]);
    auto& term = terms_[i].turning;
    for (const auto& strip : strips_[i])
        for (const auto& [dof_a, moment_a] : strip.a)
            for (const auto& [dof_b, moment_b] : strip.b) {
                double value = 0;
                for (int m = 0; m < 2; ++m)
                    if (strip.norm[m] > 1e-14 * strip.norm[0])
                        value += moment_a[m] * moment_b[m] / strip.norm[m];
                if (space_.owns(dof_a))
                    term.add(dof_a, dof_b, value);
                if (space_.owns(dof_b))
                    term.add(dof_b, dof_a, value);
            }
    term.finish();
}

void JointTerms::add_couplings(Couplings& couplings) const
{
    const auto unknowns = [](const auto& moments) {
        std::vector<PetscInt> result;
        for (const auto& entry : moments)
            result.push_back(entry.first);
        return result;
    };
    for (std::size_t i = 0; i < terms_.size(); ++i) {
        for (const auto& strip : strips_[i]) {
            const auto a = unknowns(strip.a), b = unknowns(strip.b);
            couplings.add(a, b);
            couplings.add(b, a);
        }
        if (across_[i])
            space_.add_couplings_across(space_.machine.interfaces[i].points, couplings);
    }
}

bool JointTerms::serve(const std::vector<InterfaceLaw>& laws) const
{
    for (std::size_t i = 0; i < laws.size(); ++i)
        if (laws[i].turns_fully ? strips_[i].empty() : !across_[i])
            return false;
    return true;
}

void JointTerms::add_to(Mat stiffness, const std::vector<JointCoefficients>& coefficients) const
{
    for (std::size_t i = 0; i < terms_.size(); ++i) {
        terms_[i].aa.add_to(stiffness, coefficients[i].aa);
        terms_[i].bb.add_to(stiffness, coefficients[i].bb);
        terms_[i].across.add_to(stiffness, coefficients[i].across);
        terms_[i].turning.add_to(stiffness, coefficients[i].turning);
    }
}

std::vector<SparseTerm> film_terms(const Discretisation& space, const HeatProblem& problem)
{
    std::vector<SparseTerm> terms(problem.surfaces.size());
    PointShape shape;
    for (std::size_t s = 0; s < terms.size(); ++s) {
        const auto& condition = problem.surfaces[s];
        if (condition.kind == SurfaceCondition::Kind::film && !heat::follows_temperature(condition))
            for (const auto& [index, fraction, central] : faces_of(space.machine, condition)) {
                if (!space.owns_cell(space.machine.faces[index].cell))
                    continue;
                for (const auto& point : face_points(space.machine, space.machine.faces[index])) {
                    space.evaluate(index, point.position, false, shape);
                    const auto on_face = without_zeros(shape);
                    terms[s].add(on_face, on_face, fraction * point.weight);
                }
            }
        terms[s].finish();
    }
    return terms;
}

}  // namespace deadpoint::fem

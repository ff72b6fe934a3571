#include "deadpoint/study/reduce/reduced_press.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/core/hash.hpp"
#include "deadpoint/drift/chain.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/bare_machine.hpp"
#include "deadpoint/io/binary_file.hpp"
#include "deadpoint/io/read_file.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/reduce/online/dense_terms.hpp"
#include "deadpoint/reduce/online/terms_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <tuple>

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

constexpr auto members(const FreeCoefficient*)
{
    return std::tuple{&FreeCoefficient::name, &FreeCoefficient::kind, &FreeCoefficient::members,
                      &FreeCoefficient::base, &FreeCoefficient::from, &FreeCoefficient::to};
}

}  // namespace reduce

constexpr auto members(const Series*) { return std::tuple{&Series::value, &Series::rate}; }
constexpr auto members(const CornerSeries*)
{
    return std::tuple{&CornerSeries::name, &CornerSeries::x, &CornerSeries::z};
}

namespace study {

constexpr auto members(const GapModel::Clearance*)
{
    return std::tuple{&GapModel::Clearance::name, &GapModel::Clearance::kind, &GapModel::Clearance::joint};
}
constexpr auto members(const GapModel*)
{
    return std::tuple{&GapModel::corners, &GapModel::clearances, &GapModel::left_out, &GapModel::mirrored};
}
constexpr auto members(const ReducedChain*)
{
    return std::tuple{&ReducedChain::figures, &ReducedChain::gaps, &ReducedChain::first_gap};
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

namespace {

constexpr std::string_view kind = "deadpoint reduced press 3\n";
constexpr const char* help = "make it again with 'deadpoint reduce CASE -o FILE'";

// All but the terms, in the order of the file.
constexpr auto head(const ReducedPress*)
{
    return std::tuple{&ReducedPress::version,    &ReducedPress::name,        &ReducedPress::case_hash,
                      &ReducedPress::fixed_part, &ReducedPress::large_file,  &ReducedPress::machine,
                      &ReducedPress::size_scale, &ReducedPress::cells,       &ReducedPress::unknowns,
                      &ReducedPress::adjoints,   &ReducedPress::reference,   &ReducedPress::chain,
                      &ReducedPress::frame,      &ReducedPress::first_frame, &ReducedPress::box,
                      &ReducedPress::errors,     &ReducedPress::sizes};
}

bool contacts_fit(const std::vector<Contact>& contacts, std::size_t parts)
{
    return std::ranges::all_of(contacts, [&](const Contact& c) { return c.part_a < parts && c.part_b < parts; });
}

bool machine_fits(const Machine& machine, const heat::FunctionalLayout& layout)
{
    const auto parts = machine.parts.size();
    const auto share_fits = [&](const SurfaceShare& share) { return share.part < parts; };
    return parts == layout.parts && machine.interfaces.size() == layout.interfaces &&
           contacts_fit(machine.interfaces, parts) && contacts_fit(machine.bonds, parts) &&
           std::ranges::all_of(machine.surfaces, [&](const MeshSurface& surface) {
               return std::ranges::all_of(surface.figures.parts, share_fits);
           });
}

// Corners are none, or four of which two may be mirror images.
bool chain_fits(const ReducedChain& chain, std::size_t adjoints, std::size_t split, std::size_t parts)
{
    const auto& gaps = chain.gaps;
    const auto bearings = static_cast<std::size_t>(std::max(chain.figures.bearings, 0));
    return chain.figures.bearings >= 0 && chain.first_gap == drift::dimension_count + bearings &&
           chain.first_gap + gaps.corners.size() + gaps.clearances.size() <= adjoints &&
           (gaps.corners.empty() || gaps.corners.size() == (gaps.mirrored ? 2U : 4U)) &&
           split == (1 + bearings) * parts;
}

bool coefficient_fits(const reduce::FreeCoefficient& one, const heat::FunctionalLayout& layout)
{
    using enum reduce::FreeCoefficient::Kind;
    const auto below = [&](std::size_t limit) {
        return std::ranges::all_of(one.members, [&](std::size_t member) { return member < limit; });
    };
    return one.base.size() == one.members.size() && !one.base.empty() && one.kind >= film && one.kind <= ambient &&
           (one.kind != film || below(layout.surfaces)) && (one.kind != side || below(2 * layout.interfaces)) &&
           (one.kind != oil || below(layout.interfaces));
}

// Its name and a hash of its bytes: a copy of the case in another folder has the same form, a changed drawing has not.
std::string form_in_file(const std::string& file)
{
    if (file.empty())
        return file;
    StableHash hash;
    read_pieces(file, [&](std::string_view bytes) { hash.add(bytes); });
    return fmt::format("{} with content {:016x}", std::filesystem::path(file).filename().string(), hash.value());
}

// A file with a right checksum may still not be what this program writes.
bool is_sound(const ReducedPress& press)
{
    const auto& terms = press.terms->terms;
    const auto& layout = terms.geometry.layout;
    const auto observed = static_cast<std::size_t>(terms.observed.rows());
    if (press.adjoints > observed || terms.parts.cols() != static_cast<Eigen::Index>(layout.parts))
        return false;
    const auto split = observed - press.adjoints;
    const auto forces = press.frame ? press.frame->rods.size() + press.frame->bonds.size() : 0;
    return machine_fits(press.machine, layout) &&
           (press.chain ? chain_fits(*press.chain, press.adjoints, split, layout.parts) : split == 0) &&
           (!press.frame || press.first_frame + forces <= press.adjoints) &&
           std::ranges::all_of(press.box, [&](const auto& one) { return coefficient_fits(one, layout); });
}

ReducedPress read(const std::filesystem::path& file, reduce::Sums sums)
{
    BinaryReader reader(file, kind, help);
    ReducedPress press;
    std::apply([&](auto... member) { reader(press.*member...); }, head(&press));
    reduce::StoredTerms kept;
    reduce::DenseTerms terms;
    reader(terms.geometry, kept);
    try {
        reduce::restore(kept, terms);
        press.terms = std::make_shared<const reduce::PreparedTerms>(std::move(terms), sums);
    } catch (const InputError& error) {
        reader.refuse(error.what());
    }
    if (!is_sound(press))
        reader.refuse("its numbers do not fit each other");
    press.states = static_cast<std::size_t>(press.terms->terms.uniform.size());
    return press;
}

}  // namespace

std::filesystem::path fields_file(const std::filesystem::path& file)
{
    return file.parent_path() / (file.stem().string() + ".fields" + file.extension().string());
}

void write_reduced(const std::filesystem::path& file, const ReducedPress& press)
{
    write_file(file, [&](std::ostream& out) {
        BinaryWriter writer(out, kind);
        std::apply([&](auto... member) { writer(press.*member...); }, head(&press));
        writer(press.terms->terms.geometry, reduce::stored(press.terms->terms));
        writer.finish();
    });
}

ReducedPress read_reduced(const std::filesystem::path& file) { return read(file, reduce::Sums::of_matrices); }

ReducedPress read_reduced_for_few_runs(const std::filesystem::path& file)
{
    return read(file, reduce::Sums::of_factors);
}

casefile::Case fixed_case(const casefile::Case& input)
{
    auto fixed = input;
    fixed.operation = {};
    fixed.machine.name.clear();
    fixed.machine.description.clear();
    fixed.machine.ambient = fixed.machine.initial_temperature = casefile::MachineSection{}.ambient;
    for (auto& [name, joint] : fixed.joints) {
        joint.friction.clear();
        joint.oil_temperature = casefile::Joint{}.oil_temperature;
        joint.clearance.reset();
        joint.elements.clear();
        joint.preload = 0;
        for (auto& interface : joint.interfaces) {
            interface.conductance = {};
            interface.oil = 0;
            interface.heat_share = 1;
        }
    }
    for (auto& [name, bond] : fixed.bonds)
        if (!casefile::is_open(bond.conductance))
            bond.conductance = {};
    for (auto& [name, surface] : fixed.surfaces)
        if (surface.film)
            surface.film = casefile::Film{};
    if (fixed.chain) {
        fixed.chain->press_stiffness.reset();
        fixed.chain->bearing_play.reset();
    }
    fixed.friction.clear();
    fixed.oil.clear();
    fixed.oil_with_speed.clear();
    fixed.oil_circuits.clear();
    fixed.enclosures.clear();
    fixed.lubricants.clear();
    fixed.crankshaft.reset();
    fixed.process_force.reset();
    fixed.output = {};
    fixed.reduce.reset();
    fixed.reference.reset();
    const auto given = input.numerics;
    fixed.numerics = {};
    fixed.numerics.order = given.order;
    fixed.numerics.size = given.size;
    fixed.numerics.seam_tolerance = given.seam_tolerance;
    fixed.numerics.deformation_size = given.deformation_size;
    fixed.numerics.deformation_order = given.deformation_order;
    return fixed;
}

std::string fixed_part(const casefile::Case& input)
{
    auto fixed = fixed_case(input);
    for (auto& [name, part] : fixed.parts) {
        part.step = form_in_file(part.step);
        part.mesh = form_in_file(part.mesh);
    }
    return casefile::write_case(fixed);
}

}  // namespace study
}  // namespace deadpoint

#include "deadpoint/twin/model/reduced_press.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/core/hash.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/solid_print.hpp"
#include "deadpoint/io/read_file.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace deadpoint::twin {
namespace {

// Its name and a hash of its bytes: a copy of the case in another folder has the same form, a changed drawing has not.
std::string form_in_file(const std::string& file)
{
    if (file.empty())
        return file;
    StableHash hash;
    read_pieces(file, [&](std::string_view bytes) { hash.add(bytes); });
    return fmt::format("{} with content {:016x}", std::filesystem::path(file).filename().string(), hash.value());
}

}  // namespace

std::filesystem::path fields_file(const std::filesystem::path& file)
{
    return file.parent_path() / (file.stem().string() + ".fields" + file.extension().string());
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
        part.solid = solid_reference(part.solid).name;
        part.step = form_in_file(part.step);
        part.mesh = form_in_file(part.mesh);
    }
    return casefile::write_case(fixed);
}

}  // namespace deadpoint::twin

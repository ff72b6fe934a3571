#include "deadpoint/full/draft/draft.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace deadpoint::full {
namespace {

std::vector<std::string> bodies_of(const Draft& draft, Role role)
{
    std::vector<std::string> names;
    for (const DraftBody& body : draft.bodies) {
        if (body.role == role) {
            names.push_back(body.name);
        }
    }
    return names;
}

bool joined(const Draft& draft, Role one, Role other)
{
    return std::ranges::any_of(draft.joints, [&](const DraftJoint& joint) {
        const Role a = draft.bodies[joint.body_a].role;
        const Role b = draft.bodies[joint.body_b].role;
        return (a == one && b == other) || (a == other && b == one);
    });
}

void add_missing_roles(const Draft& draft, std::vector<std::string>& doubts)
{
    struct Wanted {
        Role role;
        const char* what;
        const char* name;
    };
    for (const Wanted& one : {Wanted{Role::crank, "crankshaft", "crank"}, Wanted{Role::rod, "connecting rod", "rod"},
                              Wanted{Role::slide, "slide", "slide"}}) {
        if (bodies_of(draft, one.role).empty()) {
            doubts.push_back(
                fmt::format("No solid is a {} by its name: say which with --body {}=SOLID", one.what, one.name));
        }
    }
    const auto cranks = bodies_of(draft, Role::crank);
    if (cranks.size() > 1) {
        doubts.push_back(
            fmt::format("These bodies are all crankshafts: {}. A case holds one press; leave the others out of "
                        "the drawing, or say which solids are one piece with --body",
                        fmt::join(cranks, ", ")));
    }
}

void add_missing_joints(const Draft& draft, std::vector<std::string>& doubts)
{
    const char* near = draft.near_misses.empty() ? "" : "; the case lists what nearly touches";
    struct Pair {
        Role one;
        Role other;
        const char* what;
    };
    for (const Pair& pair :
         {Pair{Role::crank, Role::frame, "crankshaft and frame"}, Pair{Role::rod, Role::crank, "rod and crankshaft"},
          Pair{Role::rod, Role::slide, "rod and slide"}, Pair{Role::slide, Role::frame, "slide and frame"}}) {
        const bool drawn = !bodies_of(draft, pair.one).empty() && !bodies_of(draft, pair.other).empty();
        if (drawn && !joined(draft, pair.one, pair.other)) {
            doubts.push_back(
                fmt::format("No joint of {} was found: nothing of theirs touches along the axes of the "
                            "press. Draw them in contact, at bottom dead point, or add the joint by hand{}",
                            pair.what, near));
        }
    }
}

bool same_place(const machine::CadSolid& one, const machine::CadSolid& other)
{
    constexpr double near = 1e-6;  // [m], and a share of the volume
    return norm(one.bounds.min - other.bounds.min) < near && norm(one.bounds.max - other.bounds.max) < near &&
           std::abs(one.volume - other.volume) < near * one.volume;
}

void add_doubles(const Draft& draft, std::vector<std::string>& doubts)
{
    const auto& solids = draft.model.solids;
    for (std::size_t i = 0; i < solids.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (same_place(solids[i], solids[k])) {
                doubts.push_back(fmt::format("'{}' lies where '{}' lies, in the same size: remove one of them from the "
                                             "drawing, or its part from the case",
                                             solids[i].name, solids[k].name));
            }
        }
    }
}

}  // namespace

std::vector<std::string> doubts_about(const Draft& draft)
{
    std::vector<std::string> doubts;
    for (const auto& name : draft.model.without_solid) {
        doubts.push_back(
            fmt::format("'{}' is left out, since it holds surfaces or curves, but no solid: export it as a "
                        "closed solid if it matters",
                        name));
    }
    add_doubles(draft, doubts);
    add_missing_roles(draft, doubts);
    add_missing_joints(draft, doubts);
    if (!draft.axes.found) {
        doubts.emplace_back(
            "The axes are those of the drawing, where nothing says which way crankshaft and stroke lie: z "
            "must lie along the crankshaft and y point up, else turn every part by `axes`, or the drawing");
    }
    return doubts;
}

}  // namespace deadpoint::full

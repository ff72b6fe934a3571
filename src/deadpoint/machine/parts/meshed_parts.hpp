#pragma once

#include "deadpoint/machine/geometry/part_mesh.hpp"

#include <exception>
#include <functional>
#include <map>
#include <string>

namespace deadpoint {

/// The meshes of the parts of one description, each made once: a sketch of a machine that was refused needs the same
/// ones. A part that failed fails again with the same error.
class MeshedParts {
public:
    machine::PartMesh once(const std::string& part, const std::function<machine::PartMesh()>& make)
    {
        const auto [entry, is_new] = parts_.try_emplace(part);
        auto& [mesh, failure] = entry->second;
        if (is_new) {
            try {
                mesh = make();
            } catch (...) {
                failure = std::current_exception();
            }
        }
        if (failure) {
            std::rethrow_exception(failure);
        }
        return mesh;
    }

private:
    struct Outcome {
        machine::PartMesh mesh;
        std::exception_ptr failure;
    };
    std::map<std::string, Outcome> parts_;
};

}  // namespace deadpoint

#pragma once

#include "command.hpp"

#include <fmt/format.h>
#include <string>

/// A case of one plate read from a file.
inline std::string plate_case(const ScratchFolder& folder, const std::string& key, const std::string& file)
{
    return folder
        .file("case.toml",
              fmt::format("format = 1\n[machine]\nname = \"plate\"\n[materials.steel]\nlibrary = \"C45\"\n"
                          "[bodies.frame]\nground = true\n[parts.plate]\nbody = \"frame\"\nmaterial = \"steel\"\n"
                          "{} = \"{}\"\n[[operation]]\nduration = \"1 min\"\nspeed = \"0 rpm\"\n",
                          key, file))
        .string();
}

/// [kg], as its plan says; 0 where it does not.
inline double plate_mass(const std::string& plan)
{
    const auto at = plan.find("  frame      1 ");
    return at == std::string::npos ? 0 : std::stod(plan.substr(at + 15));
}

inline std::string test_data(const std::string& name) { return content(fs::path(DEADPOINT_TEST_DATA) / name); }

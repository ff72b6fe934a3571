#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace surroundings_test {

inline constexpr double printed = 1e-9;  // the reference values carry ten digits
inline constexpr double zero_celsius = 273.15;

inline const nlohmann::json& oracle(const char* entry)
{
    static const nlohmann::json data = [] {
        std::ifstream file(std::string(DEADPOINT_TEST_DATA) + "/heat_oracle_contact_air.json");
        return nlohmann::json::parse(file);
    }();
    return data[entry];
}

inline double number(const nlohmann::json& row, const char* key) { return row[key].get<double>(); }

}  // namespace surroundings_test

#include "paper.hpp"

#include "deadpoint/casefile/files/read.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>

namespace paper {

const nlohmann::json& printed(const std::string& table)
{
    static const nlohmann::json tables = nlohmann::json::parse(std::ifstream(DEADPOINT_TEST_DATA "/paper_tables.json"));
    return tables.at(table);
}

const deadpoint::casefile::Case& press()
{
    static const auto input = deadpoint::casefile::read_case(DEADPOINT_SOURCE_DIR "/cases/jl75g-60/case.toml").value;
    return input;
}

Comparison::Comparison(std::string name, std::vector<std::string> head) : name_(std::move(name))
{
    row(head);
    text_ += "|";
    for (std::size_t i = 0; i < head.size(); ++i)
        text_ += "---|";
    text_ += "\n";
}

Comparison::~Comparison()
{
    if (const char* folder = std::getenv("DEADPOINT_PRINT_TABLES"))
        std::ofstream(std::filesystem::path(folder) / (name_ + ".md")) << text_;
}

void Comparison::row(const std::vector<std::string>& cells)
{
    text_ += fmt::format("| {} |\n", fmt::join(cells, " | "));
}

bool same(double printed, double own) { return std::abs(own - printed) <= 1e-12 * std::abs(printed); }

std::string figure(double value, int digits) { return fmt::format("{:.{}g}", value, digits); }

}  // namespace paper

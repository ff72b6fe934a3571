#pragma once

#include "deadpoint/casefile/describe/case.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

/// What the tests of the paper's tables share.
namespace paper {

/// A table of the paper as printed (tests/data/paper_tables.json).
const nlohmann::json& printed(const std::string& table);

/// The press of the paper, cases/jl75g-60.
const deadpoint::casefile::Case& press();

/// A table of printed and own figures with a verdict in each row. Written as <folder>/<name>.md at the end of its life
/// if DEADPOINT_PRINT_TABLES names a folder, else nowhere.
class Comparison {
public:
    Comparison(std::string name, std::vector<std::string> head);
    ~Comparison();
    Comparison(const Comparison&) = delete;
    Comparison& operator=(const Comparison&) = delete;

    void row(const std::vector<std::string>& cells);

private:
    std::string name_;
    std::string text_;
};

/// Whether two figures are the same but for rounding of their reading (no digit of the paper's is lost).
bool same(double printed, double own);

/// A figure with as many digits as the paper prints.
std::string figure(double value, int digits = 6);

}  // namespace paper

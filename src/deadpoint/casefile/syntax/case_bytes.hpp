#pragma once

#include <string>
#include <vector>

namespace deadpoint::casefile {

struct Case;

/// A table of a case by its path ("joints.crank_pin", "operation"), and its values as bytes.
struct CasePart {
    std::string path;
    std::string bytes;
};

/// The tables of a case in the order of its text, to compare cases within one call of the program: a table with the
/// same bytes has the same text (files/write.hpp), which takes many times as long.
std::vector<CasePart> case_parts(Case c);

/// All of them in one.
std::string case_bytes(Case c);

}  // namespace deadpoint::casefile

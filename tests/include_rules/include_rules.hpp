#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Checks the #include lines below `root`/src/deadpoint and `root`/app against the rules of docs/design.md:
///  - a folder includes only folders below it in the pipeline;
///  - a library is included only from the folder that wraps it;
///  - public headers include only std and own headers: one that shows a library's header, directly or through another
///    header, is internal and may be included only from its own folder;
///  - files below src/ spell own headers "deadpoint/<folder>/<file>";
///  - units (a header and its source together) form no cycle;
///  - no header reaches more than 19 own headers, directly or through others;
///  - no folder holds more than 25 files;
///  - tests compare numbers by near() (tests/near.hpp), not by doctest's Approx;
///  - no comment begins with "Of": it begins with the noun or verb that it is about.
///
/// @return one line per violation: "file:line: what is wrong"; empty if all is well
std::vector<std::string> include_violations(const std::filesystem::path& root);

#pragma once

#include <map>
#include <mutex>
#include <string>

namespace deadpoint::casefile {

struct Case;

/// The case as one TOML text: includes merged, library values filled in, defaults stated, everything with its unit.
/// Reading it back gives the same case bit by bit.
std::string write_case(const Case& c);

/// Hash of the resolved case, 16 hexadecimal digits: equal for equal cases in any notation. It
/// includes the paths of STEP and mesh files, not their contents.
std::string case_hash(const Case& c);

/// The same of many cases that are mostly alike: a table that the case before had too is not written again. Any number
/// of threads may use it.
class CaseTexts {
public:
    /// As write_case().
    std::string text(const Case& c);
    /// As case_hash().
    std::string hash(const Case& c);

private:
    struct Written {
        std::string bytes, text;
    };
    std::mutex mutex_;
    std::map<std::string, Written> tables_;  ///< by path, as they were last
};

}  // namespace deadpoint::casefile

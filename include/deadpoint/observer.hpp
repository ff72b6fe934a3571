#pragma once

#include <string>
#include <string_view>

namespace deadpoint {

/// Receives messages of the library, which never prints. The command line shows them on the
/// terminal; tests collect them.
class Observer {
public:
    virtual ~Observer() = default;
    /// A stage of the pipeline begins ("mesh", "heat", ...).
    virtual void stage(std::string_view name) { (void)name; }
    /// Progress of the running stage, `fraction` in 0..1, with a few words such as "t = 0.52 h".
    virtual void progress(double fraction, std::string_view detail)
    {
        (void)fraction;
        (void)detail;
    }
    /// A fact worth a line in the log.
    virtual void info(std::string_view text) { (void)text; }
    /// Something the user must know to judge the result; it is also written into every result file.
    virtual void warn(std::string_view text) { (void)text; }
    /// True after the user asked to stop. Long loops check it after each step and end cleanly.
    [[nodiscard]] virtual bool cancelled() const { return false; }
};

}  // namespace deadpoint

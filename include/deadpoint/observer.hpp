#pragma once

#include <string>
#include <string_view>

namespace deadpoint {

/// How the library talks: it never prints. The command line shows it on the terminal, tests collect it.
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
    /// True once the user asked to stop; long loops ask after each step and end cleanly.
    [[nodiscard]] virtual bool cancelled() const { return false; }
};

}  // namespace deadpoint

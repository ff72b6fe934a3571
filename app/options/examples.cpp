#include "options/examples.hpp"

#include <array>
#include <fmt/format.h>
#include <string>
#include <string_view>

namespace {

struct Example {
    std::string_view subcommand;
    std::string_view line;
};

constexpr std::array examples{
    Example{"init", "deadpoint init my-press                                   write a commented case to start from"},
    Example{"init", "deadpoint init my-press --step press.step                a case from a drawing"},
    Example{"check", "deadpoint check my-press/case.toml                        what is in it, and is it all right?"},
    Example{"check", "deadpoint check -q my-press/case.toml                     is it all right?"},
    Example{"mesh", "deadpoint mesh my-press/case.toml -o my-press/mesh        look at the geometry in ParaView"},
    Example{"loads",
            "deadpoint loads my-press/case.toml -o my-press/loads      joint forces and bearing loads over a turn"},
    Example{"heat",
            "deadpoint heat my-press/case.toml -o my-press/heat        joint heat, conductances, film coefficients"},
    Example{"run", "deadpoint run my-press/case.toml -o my-press/results      warm it up and see the gap move"},
    Example{"run", "deadpoint run my-press/case.toml -o fast --size 2 --set \"operation.0.speed=300 rpm\""},
    Example{"run", "deadpoint run my-press/case.toml -o quick --reduced press.rom   in seconds, on a reduced model"},
    Example{"run", "deadpoint run my-press/case.toml -o results --ranks 2     on two cores; default: as many as help"},
    Example{"reduce", "deadpoint reduce my-press/case.toml -o press.rom          build a model for quick runs"},
    Example{"sweep", "deadpoint sweep my-press/study.toml -o study              many runs: speeds, forces, ..."},
    Example{"sensitivity", "deadpoint sensitivity my-press/study.toml --reduced press.rom -o what-matters   which "
                           "unknowns matter?"},
    Example{"calibrate", "deadpoint calibrate my-press/case.toml calibration.toml --reduced press.rom -o calibrated   "
                         "fit it to measurements"},
    Example{"optimise", "deadpoint optimise my-press/study.toml --reduced press.rom -o best   the shortest warm-up, "
                        "the least drift"},
    Example{"compare",
            "deadpoint compare my-press/results measured.toml          how good is it against what was measured?"},
    Example{"probe", "deadpoint probe my-press/results --at \"frame,0 mm,0 mm,50 mm\"   how warm does this place get?"},
    Example{"view", "deadpoint view my-press/results                           see it as a page in the browser"},
    Example{"report", "deadpoint report a b -o a-and-b.html                      two results on one page"},
};

constexpr const char* exit_codes = "Exit codes: 0 done, 2 wrong input, 3 value out of range, 4 no convergence, 5 file "
                                   "trouble, 130 stopped by Ctrl-C.";

/// Examples of one subcommand, or of all, and the exit codes.
std::string footer(std::string_view subcommand)
{
    std::string text = "Examples:\n";
    for (const auto& example : examples) {
        if (subcommand.empty() || example.subcommand == subcommand) {
            text += fmt::format("  {}\n", example.line);
        }
    }
    return text + "\n" + exit_codes;
}

}  // namespace

void add_examples(CLI::App& app)
{
    app.footer(footer(""));
    for (auto* subcommand : app.get_subcommands(nullptr)) {
        subcommand->footer(footer(subcommand->get_name()));
    }
}

#include "commands.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/full/run/reduce.hpp"
#include "deadpoint/twin/model/certificate_file.hpp"
#include "options/build_folder.hpp"
#include "options/case_options.hpp"
#include "ranks/ranks.hpp"

#include <memory>
#include <string>

using namespace deadpoint;

namespace {

struct ReduceOptions : CaseOptions {
    std::string file;
    int full_runs = usual_full_runs;
    bool fields = false;
    bool certify = false;
    bool resume = false;
    bool force = false;
    RankOptions ranks;
};

int reduce_case(const ReduceOptions& options, Ranks& ranks)
{
    const auto read = read_case(options, ranks.console);
    if (options.certify) {
        ranks.stay_alone("a certificate");
    }
    const BuildFolder folder(options.file, stopped_build(options.resume, options.force), read.value, ranks);
    full::Press press(read.value, options.size_scale);
    press.mesh(ranks.console);
    ranks.spread([&] { return press.machine(ranks.console).cells.size(); });
    ranks.agree = false;
    auto wanted = wanted_reduction(press.input(), options.full_runs);
    wanted.checkpoint = folder.checkpoint();
    if (options.fields) {
        wanted.fields_file = twin::fields_file(options.file).string();
    }
    wanted.build.certificate = options.certify;
    return folder.finish(press.reduce(wanted, ranks.console), wanted, "the same command with --resume", ranks);
}

}  // namespace

void add_reduce(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("reduce", "build a reduced model of a few hundred states, for quick runs");
    const auto options = std::make_shared<ReduceOptions>();
    add_case_options(*command, *options);
    command->add_option("-o,--output", options->file, "the file of the reduced model")->required()->type_name("FILE");
    command
        ->add_option("--full-runs", options->full_runs,
                     "full runs to compare with: the case itself, then coefficients drawn from their ranges")
        ->check(CLI::Range(0, 1000));
    command->add_flag(
        "--fields", options->fields,
        "also store the fields of the states, for 3-D fields of runs: 4 bytes for each temperature of the "
        "mesh and each state, 100 MB for the shipped press");
    command->add_flag("--certify", options->certify,
                      "also write what 'run --reduced --certify' needs to bound the error of a run");
    command->add_flag("--resume", options->resume,
                      "continue a stopped build from its checkpoint FILE.checkpoint; without one, start at the "
                      "beginning");
    command->add_flag("--force", options->force,
                      "replace the files of a reduced press, and discard a stopped build of it");
    add_rank_options(*command, options->ranks);
    command->callback([options, &exit_code] {
        exit_code =
            on_ranks(options->ranks, options->console, [&](Ranks& ranks) { return reduce_case(*options, ranks); });
    });
}

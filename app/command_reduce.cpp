#include "commands.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/fem/space/session.hpp"
#include "deadpoint/report/text/reduce_text.hpp"
#include "deadpoint/study/pipeline/press.hpp"
#include "deadpoint/study/reduce/certificate_file.hpp"
#include "deadpoint/study/reduce/reduce.hpp"
#include "options/case_options.hpp"
#include "output.hpp"
#include "ranks.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <thread>

using namespace deadpoint;

namespace {

struct ReduceOptions : CaseOptions {
    std::string file;
    int full_runs = 2;
    bool fields = false;
    bool certify = false;
};

/// The name of the large model's file beside that of the small one: press.rom, press.large.rom.
std::filesystem::path large_file(const std::filesystem::path& file)
{
    return file.parent_path() / (file.stem().string() + ".large" + file.extension().string());
}

void write(const std::filesystem::path& file, study::Reduction& reduction)
{
    const auto large = large_file(file);
    reduction.small.large_file = large.filename().string();
    study::write_reduced(large, reduction.large);
    const auto certificate = study::certificate_file(file);
    if (reduction.residual)
        study::write_certificate(certificate, reduction.large, *reduction.residual);
    else
        std::filesystem::remove(certificate);
    study::write_reduced(file, reduction.small);
}

std::string text_of_fields(const ReduceOptions& options)
{
    if (!options.fields) {
        return {};
    }
    const auto file = study::fields_file(options.file);
    return fmt::format("the fields of its states are in {} ({:.1f} MB)\n", file.filename().string(),
                       1e-6 * static_cast<double>(std::filesystem::file_size(file)));
}

int reduce_case(const ReduceOptions& options, const OnRanks& ranks)
{
    const auto read = read_case(options, ranks.console);
    on_first_rank(ranks.first, [&] {
        if (!std::filesystem::is_directory(std::filesystem::absolute(options.file).parent_path())) {
            throw IoError("cannot write '" + options.file + "': its folder does not exist");
        }
    });
    study::Press press(read.value, options.size_scale);
    press.mesh(ranks.console);
    ranks.agree = false;
    auto wanted = study::reduce_options(press.input());
    wanted.build.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency())) / fem::ranks();
    wanted.full_runs = options.full_runs;
    if (options.fields) {
        wanted.fields_file = study::fields_file(options.file).string();
    }
    wanted.build.certificate = options.certify;
    auto reduction = press.reduce(wanted, ranks.console);
    ranks.console.finish();
    on_first_rank(ranks.first, [&] { write(options.file, reduction); });
    if (ranks.first)
        print_out("{}\nthe reduced model is in {}, its large model beside it in {}\n{}", report::reduce_text(reduction),
                  options.file, large_file(options.file).filename().string(), text_of_fields(options));
    return 0;
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
    command->callback([options, &exit_code] {
        exit_code = on_ranks(options->console, [&](const OnRanks& ranks) { return reduce_case(*options, ranks); });
    });
}

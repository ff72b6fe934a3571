#include "options/build_folder.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/full/run/reduce.hpp"
#include "deadpoint/io/resources.hpp"
#include "deadpoint/reduce/kept/build_checkpoint.hpp"
#include "deadpoint/report/run/reduce_text.hpp"
#include "deadpoint/twin/model/certificate_file.hpp"
#include "interrupt.hpp"
#include "output.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <string>

using namespace deadpoint;
namespace fs = std::filesystem;

namespace {

constexpr const char* first_piece = "build";

/// The name of the large model's file beside that of the small one: press.rom, press.large.rom.
fs::path large_file(const fs::path& file)
{
    return file.parent_path() / (file.stem().string() + ".large" + file.extension().string());
}

void require_folder(const fs::path& file)
{
    if (!fs::is_directory(fs::absolute(file).parent_path())) {
        throw IoError(fmt::format("cannot write '{}': its folder does not exist", file.string()));
    }
}

/// By its first bytes, in any version.
bool is_of_reduced_press(const fs::path& file)
{
    std::string kind;
    std::getline(std::ifstream(file, std::ios::binary), kind);
    return fs::is_regular_file(file) &&
           (kind.starts_with("deadpoint reduced press") || kind.starts_with("deadpoint certificate") ||
            kind.starts_with("deadpoint fields of a reduced press"));
}

/// @throws IoError if a file of the press is there that must stay
void require_replaceable(const fs::path& file, bool wanted)
{
    for (const auto& one : {file, large_file(file), twin::certificate_file(file), twin::fields_file(file)}) {
        if (!fs::exists(fs::symlink_status(one))) {
            continue;
        }
        if (!is_of_reduced_press(one)) {
            throw IoError(fmt::format("'{}' exists, and is no file of a reduced press\n  help: give another name with "
                                      "-o",
                                      one.string()));
        }
        if (!wanted) {
            throw IoError(fmt::format("'{}' exists already\n  help: give another name with -o, or replace it with "
                                      "--force",
                                      one.string()));
        }
    }
}

void make_folder(const fs::path& folder)
{
    std::error_code error;
    fs::create_directory(folder, error);
    if (error) {
        throw IoError(fmt::format("cannot create the folder '{}': {}\n  help: check that you may write there",
                                  folder.string(), error.message()));
    }
}

reduce::BuildCheckpoint pieces_before_mesh(const fs::path& folder, const casefile::Case& input, Ranks& ranks)
{
    return {folder, full::build_text(input), ranks.first, [&](const std::string& text) { ranks.console.warn(text); }};
}

/// Whether a folder holds nothing but what begins a build.
bool is_hardly_begun(const fs::path& folder)
{
    return std::ranges::all_of(fs::directory_iterator(folder), [](const fs::directory_entry& entry) {
        return entry.path().filename().string().starts_with(std::string(first_piece) + ".bin");
    });
}

/// Whether a folder holds pieces of a build and nothing else.
bool is_build(const fs::path& folder)
{
    return fs::is_directory(fs::symlink_status(folder)) &&
           std::ranges::all_of(fs::directory_iterator(folder), [](const fs::directory_entry& entry) {
               return entry.path().filename().string().find(".bin") != std::string::npos;
           });
}

[[noreturn]] void refuse_other(const fs::path& folder)
{
    throw IoError(fmt::format("'{}' is not a checkpoint of a build\n  help: move it away, or give another name with -o",
                              folder.string()));
}

/// Removes a checkpoint under another name, so that a kill on the way leaves no half of one under its own.
void discard(const fs::path& folder)
{
    const fs::path discarded = folder.string() + ".discarded";
    std::error_code ignored;
    if (is_build(discarded)) {
        fs::remove_all(discarded, ignored);
    }
    fs::rename(folder, discarded, ignored);
    fs::remove_all(ignored ? folder : discarded, ignored);
}

// Returns whether there is something to go on with.
bool find_stopped(const fs::path& folder, StoppedBuild stopped)
{
    std::error_code ignored;
    if (stopped == StoppedBuild::discard && fs::exists(fs::symlink_status(folder))) {
        if (!is_build(folder)) {
            refuse_other(folder);
        }
        discard(folder);
    }
    const bool there = fs::exists(folder, ignored) && !(fs::is_directory(folder, ignored) && is_hardly_begun(folder));
    if (there && stopped == StoppedBuild::refuse) {
        throw IoError(fmt::format("'{}' is the checkpoint of a build that was stopped\n  help: continue from it with "
                                  "--resume, or discard it with --force",
                                  folder.string()));
    }
    return there;
}

void require_build(const fs::path& folder, const reduce::BuildCheckpoint& pieces)
{
    if (!pieces.read(first_piece)) {
        refuse_other(folder);
    }
}

void write(const fs::path& file, twin::Reduction& reduction)
{
    const auto large = large_file(file);
    reduction.small.large_file = large.filename().string();
    twin::write_reduced(large, reduction.large);
    const auto certificate = twin::certificate_file(file);
    if (reduction.residual) {
        twin::write_certificate(certificate, reduction.large, *reduction.residual);
    } else {
        fs::remove(certificate);
    }
    twin::write_reduced(file, reduction.small);
}

std::string text_of_fields(const std::string& file)
{
    return file.empty()
               ? std::string()
               : fmt::format("the fields of its states are in {} ({:.1f} MB)\n", fs::path(file).filename().string(),
                             1e-6 * static_cast<double>(fs::file_size(file)));
}

}  // namespace

StoppedBuild stopped_build(bool resume, bool force)
{
    return resume ? StoppedBuild::resume : force ? StoppedBuild::discard : StoppedBuild::refuse;
}

BuildFolder::BuildFolder(const std::string& file, StoppedBuild stopped, const casefile::Case& input, Ranks& ranks)
    : file_(file), checkpoint_(file + ".checkpoint")
{
    std::string there;
    on_first_rank(ranks.first, [&] {
        require_folder(file_);
        require_replaceable(file_, stopped != StoppedBuild::refuse);
        lock_.emplace(file + ".lock", fmt::format("the reduced press '{}' is being built", file));
        there = find_stopped(checkpoint_, stopped) ? "there" : "";
    });
    const auto pieces = pieces_before_mesh(checkpoint_, input, ranks);
    const bool resumes = !fem::from_first_rank(there).empty();
    if (resumes) {
        require_build(checkpoint_, pieces);
    }
    on_first_rank(ranks.first, [&] {
        make_folder(checkpoint_);
        pieces.write(first_piece);
        if (stopped == StoppedBuild::resume) {
            print_out("{}\n", resumes ? fmt::format("continuing from {}", checkpoint())
                                      : fmt::format("there is no {}: starting at the beginning", checkpoint()));
            flush_out();
        }
    });
}

int BuildFolder::finish(std::optional<twin::Reduction> reduction, const full::ReduceOptions& options,
                        const std::string& command, Ranks& ranks) const
{
    ranks.console.finish();
    if (!reduction) {
        if (ranks.first) {
            print_out("the build was stopped; what it has finished is in {}\n{} continues from there\n", checkpoint(),
                      command);
        }
        return interrupted_exit_code;
    }
    on_first_rank(ranks.first, [&] {
        write(file_, *reduction);
        discard(checkpoint_);
    });
    if (ranks.first) {
        print_out("{}\nthe reduced model is in {}, its large model beside it in {}\n{}",
                  report::reduce_text(*reduction), file_.string(), large_file(file_).filename().string(),
                  text_of_fields(options.fields_file));
    }
    return 0;
}

full::ReduceOptions wanted_reduction(const casefile::Case& input, int full_runs)
{
    auto wanted = full::reduce_options(input);
    wanted.build.threads = std::max(1, usable_cores() / fem::ranks());
    wanted.full_runs = full_runs;
    return wanted;
}

#include "deadpoint/api/full/result_writer.hpp"

#include "deadpoint/api/twin/listener.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/press.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/report/folder/folder_claim.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/folder/result_folder.hpp"
#include "deadpoint/report/page/run_folder.hpp"

#include <functional>

namespace deadpoint {
namespace {

/// Work of the first rank alone, whose IoError becomes that of all ranks.
void on_first_rank(const std::function<void()>& work)
{
    std::string error;
    if (fem::rank() == 0) {
        try {
            work();
        } catch (const IoError& reason) {
            error = reason.what();
        }
    }
    error = fem::from_first_rank(error);
    if (!error.empty())
        throw IoError(error);
}

}  // namespace

ResultWriter::ResultWriter(const RunOptions& options, const std::vector<std::filesystem::path>& inputs)
    : wanted_folder_(options.folder)
{
    if (!options.start_from.empty()) {
        report::ResultFiles(options.start_from).check("state.bin");
        start_from_ = (options.start_from / "state.bin").string();
    }
    if (wanted_folder_.empty())
        return;
    using enum report::ResultFolder::IfExists;
    on_first_rank([&] {
        folder_ = std::make_unique<report::ResultFolder>(report::FolderClaim(wanted_folder_),
                                                         options.replace ? replace : refuse, inputs);
    });
    path_ = fem::from_first_rank(folder_ ? folder_->path().string() : std::string{});
}

ResultWriter::~ResultWriter() = default;

press::RunResult ResultWriter::run(full::Press& press, const std::vector<std::string>& reading, Listener& listener)
{
    for (const auto& warning : reading)
        listener.warn(warning);
    press.mesh(listener);
    full::RunOptions wanted;
    wanted.start_from = start_from_;
    wanted.causes = true;
    if (!path_.empty())
        report::write_along(wanted, path_, press.input(), listener.warnings);
    auto result = press.run(wanted, listener);
    result.timings.insert(result.timings.begin(), {"mesh", press.mesh_seconds()});
    if (folder_) {
        const auto& machine = press.machine(listener);
        const auto problem = report::finish_run_folder(*folder_, press.input(), machine, result, listener.warnings);
        if (!problem.empty())
            listener.warn(problem);
        for (const auto& note : folder_->take_notes())
            listener.info(note);
    }
    return result;
}

}  // namespace deadpoint

#include "deadpoint/api/result_writer.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/press.hpp"
#include "deadpoint/report/files/run_files.hpp"
#include "deadpoint/report/folder/folder_claim.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/folder/result_folder.hpp"
#include "deadpoint/study/pipeline/press.hpp"
#include "deadpoint/study/pipeline/run.hpp"

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

study::RunOptions ResultWriter::wanted() const
{
    study::RunOptions options;
    options.start_from = start_from_;
    options.state_file = path_.empty() ? std::string{} : path_ + "/state.bin";
    options.view = !path_.empty();
    return options;
}

void ResultWriter::write(study::Press& press, const study::RunResult& result, const std::vector<std::string>& warnings,
                         Observer& observer)
{
    if (!folder_)
        return;
    report::write_run_files(folder_->path(), press.input(), press.machine(observer), result, warnings);
    report::write_manifest(folder_->path());
    folder_->commit();
}

}  // namespace deadpoint

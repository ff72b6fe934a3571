#pragma once

#include "deadpoint/report/files/run_files.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/folder/result_folder.hpp"
#include "deadpoint/report/page/page.hpp"
#include "run_data.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// The folder of a run, as `deadpoint run` writes it.
namespace deadpoint::python {

/// A folder that is written when the run is over. @throws IoError as report::ResultFolder
class RunFolder {
public:
    RunFolder(const std::filesystem::path& target, bool replace, const CaseData& of)
        : folder_(report::FolderClaim(target), replace ? IfExists::replace : IfExists::refuse, of.read.files)
    {}

    [[nodiscard]] std::string path() const { return folder_.path().string(); }

    /// Writes all files with the page, and gives the folder its name.
    void write(const casefile::Case& input, const Machine& machine, const study::RunResult& result,
               const std::vector<std::string>& warnings)
    {
        report::write_run_files(folder_.path(), input, machine, result, warnings);
        report::write_manifest(folder_.path());
        const std::vector<report::ReportSource> source{{folder_.path(), folder_.target().filename().string()}};
        report::write_report(folder_.path() / "report.html", source);
        folder_.commit();
    }

private:
    using IfExists = report::ResultFolder::IfExists;

    report::ResultFolder folder_;
};

}  // namespace deadpoint::python

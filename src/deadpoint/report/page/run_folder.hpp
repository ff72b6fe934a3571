#pragma once

#include "deadpoint/io/csv_style.hpp"

#include <string>
#include <vector>

namespace deadpoint {
struct Machine;
}
namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::press {
struct RunOutputs;
struct RunResult;
}  // namespace deadpoint::press

/// The folder of a run. The command, the library and Python write it with these functions.
namespace deadpoint::report {

class ResultFolder;

/// In a folder of results: the state from which a run with a longer operation goes on.
inline constexpr const char* kept_checkpoint = "checkpoint.bin";

/// Lets a run write into its folder what it writes on its way (fields, the state at its end, kept_checkpoint), and make
/// what the page shows.
/// @param warnings  so far, for the head of the field files
void write_along(press::RunOutputs& outputs, const std::string& folder, const casefile::Case& input,
                 const std::vector<std::string>& warnings);

/// Writes the files of a finished run, lists them, adds the page and gives the folder its name.
/// @return why the page is missing, since whatever is wrong with it must not cost the results; empty: it is there
/// @throws IoError as write_run_files() and ResultFolder::commit()
std::string finish_run_folder(ResultFolder& folder, const casefile::Case& input, const Machine& machine,
                              const press::RunResult& result, const std::vector<std::string>& warnings,
                              CsvStyle style = CsvStyle::comments);

}  // namespace deadpoint::report

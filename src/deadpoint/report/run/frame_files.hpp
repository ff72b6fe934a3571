#pragma once

#include "deadpoint/report/folder/json_file.hpp"
#include "deadpoint/report/tables/csv.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace deadpoint::press {
struct FrameResult;
}

/// Forces of preloaded rods, closed bonds, and stress, in the files and the text of a run.
namespace deadpoint::report {

/// Force of every rod and across every closed bond.
void add_frame_columns(std::vector<CsvColumn>& columns, const press::FrameResult& frame, const SeriesSampler& sample);

/// stress.csv: the largest stress of every listed part, at the times of the fields.
void write_stress(const std::filesystem::path& path, const press::FrameResult& frame,
                  const std::vector<std::string>& comments);

nlohmann::ordered_json frame_json(const press::FrameResult& frame, const std::vector<double>& times);

/// A table of rods, one of closed bonds, and one of stress at the end; empty where there is none.
std::string frame_text(const press::FrameResult& frame);

}  // namespace deadpoint::report

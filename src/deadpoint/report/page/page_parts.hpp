#pragma once

#include <string_view>

/// The texts of web/ of which the page consists, compiled into the program.
namespace deadpoint::report {

std::string_view page_style();
std::string_view page_libraries();
std::string_view page_licences();
std::string_view page_data_script();
std::string_view page_charts_script();
std::string_view page_shape_script();
std::string_view page_view_script();
std::string_view page_stage_script();
std::string_view page_linkage_script();
std::string_view page_flow_script();
std::string_view page_gaps_script();
std::string_view page_sections_script();
std::string_view page_main_script();
std::string_view page_sweep_script();
std::string_view page_sensitivity_script();
std::string_view page_calibration_script();
std::string_view page_plan_script();
std::string_view page_optimise_script();
std::string_view page_check_script();

}  // namespace deadpoint::report

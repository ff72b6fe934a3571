#pragma once

#include "deadpoint/report/schema/key.hpp"

/// Internal to report/schema: the keys of every JSON file.
namespace deadpoint::report::schema {

Keys summary_keys();
Keys loads_keys();
Keys heat_keys();
Keys view_keys();
Keys motion_keys();
Keys sweep_keys();
Keys compare_keys();
Keys sensitivity_study_keys();
Keys calibration_keys();
Keys plan_keys();
Keys optimise_keys();
Keys manifest_keys();

/// Friction at every operating point, which two files hold.
Keys friction_keys(const std::string& at);
/// Version and case, with which most files begin.
Keys head_keys();

}  // namespace deadpoint::report::schema

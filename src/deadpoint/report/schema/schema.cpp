#include "deadpoint/report/schema/schema.hpp"

#include "deadpoint/report/schema/calibration_columns.hpp"
#include "deadpoint/report/schema/columns.hpp"
#include "deadpoint/report/schema/keys.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <stdexcept>

namespace deadpoint::report::schema {
namespace {

template <std::size_t N>
File table(std::string name, std::string by, std::string meaning, const std::array<Column, N>& columns)
{
    return {std::move(name), std::move(by), std::move(meaning), {columns.begin(), columns.end()}, {}};
}

File document(std::string name, std::string by, std::string meaning, Keys keys)
{
    return {std::move(name), std::move(by), std::move(meaning), {}, std::move(keys)};
}

/// Files that are defined elsewhere: case files, charts, fields, pages.
File other(std::string name, std::string by, std::string meaning)
{
    return {std::move(name), std::move(by), std::move(meaning), {}, {}};
}

std::vector<File> run_files()
{
    return {
        document("deadpoint.json", "every command", "the list of the folder's files, with sizes and checksums",
                 manifest_keys()),
        document("tables.json", "every command with --csv",
                 "comment lines of the tables, which leave them with --csv plain and --csv comma",
                 {{"style", "", "plain or comma"}, {"heads/{file}", "", "comment lines of a table"}}),
        other("case.toml", "run", "the case as the program read it: includes merged, defaults filled in"),
        document("summary.json", "run", "the figures of a run", summary_keys()),
        table("history.csv", "run", "temperatures, heat and the dimension chain over time", history::all),
        table("contributions.csv", "run", "contribution of each part to the change of the gap, over time",
              contributions::all),
        table("causes.csv", "run", "contribution of each heat source to the change of the gap", causes::all),
        table("sensitivities.csv", "run --sensitivities",
              "how the figures at the end depend on each coefficient, the strongest first", sensitivities::all),
        table("gaps.csv", "run", "corners and slopes of the slide, clearances and force over time", gaps::all),
        table("stress.csv", "run", "largest stress of each listed part, at the times of the fields", stress::all),
        table("accuracy.csv", "run --accuracy", "figures of each mesh", accuracy::all),
        other("sizes.toml", "run --accuracy", "cell sizes of the last mesh, for a case file"),
        other("temperatures.svg", "run", "chart of the probes"),
        other("drift.svg", "run", "chart of the dimension chain"),
        other("contributions.svg", "run", "chart of the parts' shares"),
        document("view.json", "run", "surface, temperature and deformation for the page", view_keys()),
        other("report.html", "run, report", "all results on one page"),
        other("fields.pvd", "run", "list of the field files, for ParaView"),
        other("fields_{number}.vtu", "run", "temperature [degC], displacement [mm] and stress [MPa] at one time"),
        other("state.bin", "run", "temperatures at the end, for --from"),
        other("checkpoint.bin", "run", "state of the time steps near the end, for --resume with a longer operation"),
    };
}

std::vector<File> loads_files()
{
    const std::string by = "loads, run";
    return {
        document("loads.json", by, "motion, forces and crankshaft over one turn: figures", loads_keys()),
        table("joints.csv", by, "slide and joints over one turn", joints::all),
        table("bearings.csv", by, "bearings of the crankshaft over one turn", bearings::all),
        table("campbell.csv", by, "natural frequencies of the crankshaft over its speed", campbell::all),
        document("motion.json", by, "the linkage over one turn, for the page", motion_keys()),
        other("linkage.svg", by, "the linkage at five crank angles"),
        other("slide.svg", by, "chart of the slide"),
        other("joints.svg", by, "chart of the joint forces"),
        other("bearings.svg", by, "chart of the bearing loads"),
        other("campbell.svg", by, "chart of the natural frequencies"),
    };
}

std::vector<File> other_files()
{
    return {
        document("heat.json", "heat", "friction heat, conductances and convection coefficients by the laws",
                 heat_keys()),
        table("joint_heat.csv", "heat", "friction heat over temperature", joint_heat::all),
        table("conductances.csv", "heat", "contact conductance of every interface", conductances::all),
        table("films.csv", "heat", "convection and radiation of every surface", films::all),
        other("mesh.vtu", "mesh", "cells with part and body"),
        other("surfaces.vtu", "mesh", "faces with surface, interface and exposed share"),
        table("names.csv", "mesh", "meaning of the numbers in these two files", names::all),
        other("mesh.inp", "mesh --calculix", "the mesh for CalculiX or Abaqus"),
        document("sweep.json", "sweep", "sets, points and figures of a study", sweep_keys()),
        table("sweep.csv", "sweep", "one row for each point of each set", sweep::all),
        table("points.csv", "sweep",
              "one row for each point, written as it ends; of a study on a reduced model, which continues from it",
              points::all),
        other("{name}.svg", "sweep", "charts and maps of each set"),
        document("sensitivity.json", "sensitivity", "parameters, figures and indices of a study of sensitivity",
                 sensitivity_study_keys()),
        table("indices.csv", "sensitivity", "Sobol' indices, or effects of a screening, of all figures", indices::all),
        table("indices_over_time.csv", "sensitivity", "the same at evenly spread times", indices::over_time),
        table("samples.csv", "sensitivity", "all points with their figures, if the study asks for them", samples::all),
        document("optimise.json", "optimise", "variables, starts and figures of a search for an optimum",
                 optimise_keys()),
        other("optimum.toml", "optimise", "the case at the optimum, ready for a run"),
        table("search.csv", "optimise", "every evaluation of the search", search::all),
        table("courses.csv", "optimise", "the gap over time before and at the optimum", courses::all),
        document("compare.json", "compare", "a result against a reference", compare_keys()),
        other("compare.md", "compare", "the same as text"),
        other("compare-temperatures.svg", "compare", "chart of computed over measured temperatures"),
        other("compare-chain.svg", "compare", "chart of computed over measured changes of the dimension chain"),
    };
}

std::vector<File> calibration_files()
{
    const std::string by = "calibrate";
    return {
        other("calibrated.toml", by, "the calibrated values, to include in the case"),
        document("calibration.json", by, "figures of a calibration", calibration_keys()),
        document("plan.json", "calibrate --plan", "what planned measurements can determine", plan_keys()),
        table("parameters.csv", by, "one row for each unknown", calibration::parameters),
        table("combinations.csv", by, "combinations of unknowns, the best determined first", calibration::combinations),
        table("correlation.csv", by, "correlation of the unknowns", calibration::correlations),
        table("residuals.csv", by, "measured values beside the model", calibration::residuals),
        table("prediction_{run}.csv", by, "a run of the calibrated case with bands", calibration::predictions),
        table("posterior.csv", by, "draws of the unknowns, if samples were asked for", calibration::posterior),
        table("candidates.csv", "calibrate --plan", "what further sensors and runs would tell, the best first",
              calibration::candidates),
    };
}

std::vector<File> all_files()
{
    auto all = run_files();
    for (const auto& more : {loads_files(), other_files(), calibration_files()}) {
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

constexpr Dimension chain[] = {{"E_SW", "gap between slide and table"},
                               {"E_BG", "height of the bearing seats above ground"},
                               {"E_WG", "height of the table above ground"},
                               {"E_CS", "distance of the slide's face below the crankshaft"},
                               {"E_BC", "height of the crank off the centre of its seats"}};

}  // namespace

const Column* File::column(std::string_view kind) const
{
    const auto found = std::ranges::find(columns, kind, &Column::kind);
    return found == columns.end() ? nullptr : &*found;
}

const std::vector<File>& files()
{
    static const std::vector<File> all = all_files();
    return all;
}

const File& file(std::string_view name)
{
    auto found = std::ranges::find(files(), name, &File::name);
    if (found == files().end()) {
        found = std::ranges::find_if(files(), [&](const File& of) {
            return !of.columns.empty() && !name_in(of.name, std::string(name)).empty();
        });
    }
    if (found == files().end()) {
        throw std::logic_error(fmt::format("the schema knows no file '{}'", name));
    }
    return *found;
}

std::span<const Dimension> dimensions() { return chain; }

}  // namespace deadpoint::report::schema

#pragma once

#include "deadpoint/fem/fields.hpp"
#include "deadpoint/study/fields/field_options.hpp"
#include "deadpoint/study/fields/field_times.hpp"
#include "deadpoint/study/fields/field_writer.hpp"
#include "deadpoint/study/fields/view_recorder.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace deadpoint::casefile {
struct Case;
}

/// Internal to study/: the fields of a run, for files, for the page's view, and for whoever keeps them.
namespace deadpoint::study {

struct ModelParts;
struct RunResult;

/// Everything that outlives the fields of a run: files, view and kept fields. Collective.
class RunFields {
public:
    /// @param parts  with their model
    RunFields(const casefile::Case& input, ModelParts& parts, FieldTimes times, const FieldOptions& options);

    /// Takes the field at one of the times, in order.
    void take(double time, const fem::Field& field, RunResult& result);
    /// For checkpoints: all that were taken, as the view rounds them, but exactly where they serve for more than it.
    [[nodiscard]] std::vector<fem::HandedField> handed_on() const;
    /// Those at FieldTimes::kept.
    [[nodiscard]] const std::vector<std::pair<double, fem::Field>>& kept() const { return kept_; }
    [[nodiscard]] bool has_view() const { return !view_.empty(); }
    /// Makes RunResult::view after the time steps, with the result's history.
    void make_view(RunResult& result);

private:
    const casefile::Case& input_;
    ModelParts& parts_;
    FieldTimes times_;
    bool checkpoints_;
    double reference_;  ///< temperature without deformation [K]
    FieldWriter writer_;
    ViewRecorder view_;
    std::vector<std::pair<double, fem::Field>> kept_;
    std::map<double, fem::Field> exact_;
};

}  // namespace deadpoint::study

#pragma once

#include "deadpoint/fem/space/fields.hpp"
#include "deadpoint/full/fields/field_writer.hpp"
#include "deadpoint/full/fields/view_recorder.hpp"
#include "deadpoint/press/run/field_options.hpp"
#include "deadpoint/press/run/field_times.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::press {
struct RunResult;
}

/// The fields of a run, for files, for the page's view, and for whoever keeps them.
namespace deadpoint::full {

struct ModelParts;

/// Everything that outlives the fields of a run: files, view and kept fields. Collective.
class RunFields {
public:
    /// @param parts  with their model
    RunFields(const casefile::Case& input, ModelParts& parts, press::FieldTimes times,
              const press::FieldOptions& options);

    /// Takes the field at one of the times, in order.
    void take(double time, const fem::Field& field, press::RunResult& result);
    /// For checkpoints: all that were taken, as the view rounds them, but exactly where they serve for more than it.
    [[nodiscard]] std::vector<fem::HandedField> handed_on() const;
    /// Those at FieldTimes::kept.
    [[nodiscard]] const std::vector<std::pair<double, fem::Field>>& kept() const { return kept_; }
    [[nodiscard]] bool has_view() const { return !view_.empty(); }
    /// Makes RunResult::view after the time steps, with the result's history.
    void make_view(press::RunResult& result);

private:
    const casefile::Case& input_;
    ModelParts& parts_;
    press::FieldTimes times_;
    bool checkpoints_;
    double reference_;  ///< temperature without deformation [K]
    FieldWriter writer_;
    ViewRecorder view_;
    std::vector<std::pair<double, fem::Field>> kept_;
    std::map<double, fem::Field> exact_;
};

}  // namespace deadpoint::full

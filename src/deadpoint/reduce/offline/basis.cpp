#include "deadpoint/reduce/offline/basis.hpp"

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/reduce/kept/build_checkpoint.hpp"
#include "deadpoint/reduce/kept/matrix_pieces.hpp"
#include "deadpoint/reduce/offline/build_options.hpp"
#include "deadpoint/reduce/offline/full_model.hpp"
#include "deadpoint/reduce/offline/gram.hpp"
#include "deadpoint/reduce/parallel/ranks.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace deadpoint::reduce {
namespace {

constexpr int sets_at_base = 4;  // of the problem's own values
constexpr unsigned long long solve_seed = 1;

// Shift of the k-th set: evenly in its logarithm, and every eighth one slow enough for the steady state.
double shift_of(int k)
{
    constexpr double slowest = 1e-5, fastest = 0.5, steady = 1e-7;
    const double place = std::fmod((k + 1) * (std::numbers::phi - 1), 1.0);
    return k % 8 == 7 ? steady : slowest * std::pow(fastest / slowest, place);
}

// A slow field is a state that lasts, and one of E_SW a state of its dual problem, on which the bound of an error
// rests: both count for more than their new part.
double weight_of(double shift, bool is_dual, const BuildOptions& options)
{
    return (is_dual ? options.dual_weight : 1) * std::pow(shift, -options.slow_weight);
}

std::vector<std::size_t> shuffled_loads(const FullModel& full, Draws& draws)
{
    std::vector<std::size_t> loads;
    for (std::size_t load = 0; load < full.load_count(); ++load)
        if (full.has_load(load))
            loads.push_back(load);
    for (std::size_t k = loads.size(); k > 1; --k)
        std::swap(loads[k - 1], loads[static_cast<std::size_t>(draws.next() * static_cast<double>(k))]);
    return loads;
}

std::string piece_of(int set) { return fmt::format("fields-{:03}", set); }

bool add_kept(FullModel& full, const BuildCheckpoint& kept, int set)
{
    std::vector<std::vector<float>> fields;
    if (!kept.read(piece_of(set), fields))
        return false;
    for (const auto& field : fields)
        full.add_field(field);
    return true;
}

// The fields from `first` on.
void keep(const FullModel& full, const BuildCheckpoint& kept, int set, std::size_t first)
{
    if (!kept.keeps())
        return;
    std::vector<std::vector<float>> fields;
    for (std::size_t k = first; k < full.field_count(); ++k)
        fields.push_back(full.field(k));
    kept.write(piece_of(set), fields);
}

}  // namespace

std::optional<std::vector<double>> add_fields(FullModel& full, const HeatProblem& base, const Box& box,
                                              const BuildOptions& options, const BuildCheckpoint& kept,
                                              Observer& observer)
{
    Draws draws(solve_seed);
    const auto loads = shuffled_loads(full, draws);
    const std::size_t gap = full.geometry().layout.count() + options.dual_row;
    std::vector<double> weights(full.field_count(), std::numeric_limits<double>::infinity());
    std::size_t next = 0;
    for (int set = 0; set < options.sets; ++set) {
        auto problem = base;
        const auto values = draws.values(box);
        if (set >= sets_at_base)
            set_values(problem, box, values);
        std::vector<std::size_t> chosen;
        for (int k = 0; k < options.loads_per_set; ++k)
            chosen.push_back(loads[next++ % loads.size()]);
        if (options.has_dual && std::ranges::find(chosen, gap) == chosen.end())
            chosen.push_back(gap);
        if (!add_kept(full, kept, set)) {
            const auto first = full.field_count();
            full.add_solutions(problem, shift_of(set), chosen);
            keep(full, kept, set, first);
        }
        for (const auto load : chosen)
            weights.push_back(weight_of(shift_of(set), options.has_dual && load == gap, options));
        observer.progress((set + 1.0) / options.sets, fmt::format("{} fields", full.field_count()));
        if (any(full.ranks(), observer.cancelled()))
            return std::nullopt;
    }
    return weights;
}

// Twice, since the first inner products do not resolve what fields add to each other.
void orthonormalise(FullModel& full, const FieldChoice& choice, const BuildCheckpoint& kept)
{
    const auto found = [&](const FieldChoice& fields) {
        const Eigen::MatrixXd gram = full.gram();
        return on_first(full.ranks(), [&] { return orthonormal_combinations(gram, fields); });
    };
    const auto all = [&] { return FieldChoice{0, full.field_count(), std::vector<double>(full.field_count(), 1)}; };
    const auto known = read_matrices(kept, "basis");
    const bool is_known = known.size() == 2;
    const auto first = is_known ? known[0] : found(choice);
    full.combine(first);
    const auto second = is_known ? known[1] : found(all());
    full.correct(second);
    if (!is_known)
        write_matrices(kept, "basis", {first, second});
}

}  // namespace deadpoint::reduce

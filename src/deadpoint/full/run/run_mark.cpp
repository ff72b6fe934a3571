#include "deadpoint/full/run/run_mark.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/write.hpp"

#include <algorithm>

namespace deadpoint::full {
namespace {

casefile::Segment of_any_length(casefile::Segment segment)
{
    segment.duration = 1;
    return segment;
}

std::string hash_apart_from_operation(casefile::Case input)
{
    const auto running = std::ranges::find_if(input.operation, [](const auto& segment) { return segment.speed > 0; });
    if (running == input.operation.end())
        input.operation.clear();
    else
        input.operation = {of_any_length(*running)};
    input.output.field_times.clear();
    return casefile::case_hash(input);
}

std::string segment_hash(const casefile::Segment& segment)
{
    casefile::Case bare;
    bare.operation = {of_any_length(segment)};
    return casefile::case_hash(bare);
}

}  // namespace

fem::RunMark run_mark(const casefile::Case& input)
{
    fem::RunMark mark{casefile::case_hash(input), hash_apart_from_operation(input), {}, {}};
    for (const auto& segment : input.operation) {
        mark.segments.push_back(segment_hash(segment));
        mark.durations.push_back(segment.duration);
    }
    return mark;
}

}  // namespace deadpoint::full

#pragma once

#include <tuple>

/// What the dimension chain over time needs to know of the chain, without its mesh.
namespace deadpoint::press {

struct ChainFigures {
    int bearings = 0;                 ///< of the crank; the growths of their plays follow the dimensions
    double travel_by_play = 0;        ///< drift::travel_by_play
    double pressed_along_stroke = 0;  ///< of the direction in which the crank lies against its seats, along the stroke
};
constexpr auto members(const ChainFigures*)
{
    return std::tuple{&ChainFigures::bearings, &ChainFigures::travel_by_play, &ChainFigures::pressed_along_stroke};
}

}  // namespace deadpoint::press

#include "deadpoint/fem/space/cell_values.hpp"

namespace deadpoint::fem {

CellValues::CellValues(const Discretisation& space, const std::vector<Quadrature>& rules) : space_(space), rules_(rules)
{
    for (unsigned e = 0; e < space.elements.size(); ++e) {
        const auto &element = space.elements[e], &first_degree = space.elements[e % 2];
        Table table;
        table.count = element.size();
        for (const auto& unit : rules[e].points) {
            for (unsigned i = 0; i < table.count; ++i) {
                table.values.push_back(element.value(i, unit));
                table.slopes.push_back(element.slope(i, unit));
            }
            for (unsigned v = 0; v < first_degree.size(); ++v)
                table.straight.push_back(first_degree.slope(v, unit));
        }
        tables_.push_back(std::move(table));
    }
}

void CellValues::reinit(std::uint32_t cell)
{
    cell_ = cell;
    const unsigned index = space_.maps.element_index(cell);
    table_ = &tables_[index];
    rule_ = &rules_[index];
    space_.maps.corners(cell, corners_);
    const auto& map = space_.maps.is_round(cell) ? table_->slopes : table_->straight;
    weights_.resize(rule_->size());
    gradients_.resize(table_->slopes.size());
    for (unsigned q = 0; q < rule_->size(); ++q) {
        Matrix3 jacobian{};
        for (std::size_t v = 0; v < corners_.size(); ++v)
            add_outer(jacobian, corners_[v], map[q * corners_.size() + v]);
        weights_[q] = rule_->weights[q] * determinant(jacobian);
        const auto inverse = inverse_transposed(jacobian);
        for (unsigned i = 0; i < table_->count; ++i)
            gradients_[q * table_->count + i] = times(inverse, table_->slopes[q * table_->count + i]);
    }
}

}  // namespace deadpoint::fem

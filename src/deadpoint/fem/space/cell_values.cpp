#include "deadpoint/fem/space/cell_values.hpp"

namespace deadpoint::fem {

CellValues::CellValues(const Discretisation& space, const dealii::hp::QCollection<3>& rules)
    : space_(space), rules_(rules)
{
    for (unsigned e = 0; e < space.elements.size(); ++e) {
        const auto &element = space.elements[e], &first_degree = space.elements[e % 2];
        Table table;
        table.count = element.n_dofs_per_cell();
        for (const auto& unit : rules[e].get_points()) {
            for (unsigned i = 0; i < table.count; ++i) {
                table.values.push_back(element.shape_value(i, unit));
                table.slopes.push_back(element.shape_grad(i, unit));
            }
            for (unsigned v = 0; v < first_degree.n_dofs_per_cell(); ++v)
                table.straight.push_back(first_degree.shape_grad(v, unit));
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
        dealii::Tensor<2, 3> jacobian;
        for (std::size_t v = 0; v < corners_.size(); ++v)
            for (unsigned i = 0; i < 3; ++i)
                jacobian[i] += corners_[v][i] * map[q * corners_.size() + v];
        weights_[q] = rule_->weight(q) * dealii::determinant(jacobian);
        const auto inverse = dealii::transpose(dealii::invert(jacobian));
        for (unsigned i = 0; i < table_->count; ++i)
            gradients_[q * table_->count + i] = inverse * table_->slopes[q * table_->count + i];
    }
}

}  // namespace deadpoint::fem

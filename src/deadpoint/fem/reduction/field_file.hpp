#pragma once

#include "deadpoint/fem/space/fields.hpp"

#include <Eigen/Dense>
#include <cstddef>
#include <functional>
#include <string>

/// The temperature fields of a reduced model's states, as a file (docs/rom-file.md).
namespace deadpoint::fem {

class Discretisation;

/// This rank's share of the fields: T = sum over states of x_k field_k.
class StateFields {
public:
    explicit StateFields(Eigen::MatrixXf fields) : fields_(std::move(fields)) {}
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(fields_.cols()); }
    /// The field of states [K], which are count() numbers.
    [[nodiscard]] Field lift(const Eigen::VectorXd& states) const;

private:
    Eigen::MatrixXf fields_;  ///< a column for each state
};

/// Writes fields in single precision. Collective; the first rank writes.
/// @param owned  this rank's unknowns of a field
/// @throws IoError on all ranks if the file cannot be written
void write_fields(const std::string& file, const Discretisation& space, const std::string& model, std::size_t count,
                  const std::function<Eigen::VectorXd(std::size_t field)>& owned);

/// @param model   as reduce::mark_of() the terms of the runs
/// @param states  their number
/// @throws IoError if the file cannot be read, was cut short or changed; InputError if it belongs to another model or
///         another mesh
StateFields read_fields(const std::string& file, const Discretisation& space, const std::string& model,
                        std::size_t states);

}  // namespace deadpoint::fem

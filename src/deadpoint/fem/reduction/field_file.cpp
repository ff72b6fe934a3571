#include "deadpoint/fem/reduction/field_file.hpp"

#include "deadpoint/core/version.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/fem/reduction/field_reader.hpp"
#include "deadpoint/fem/space/discretisation.hpp"
#include "deadpoint/fem/space/file_order.hpp"
#include "deadpoint/io/binary_file.hpp"
#include "deadpoint/io/write_file.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace deadpoint::fem {
namespace {

/// Passes fields on to the first rank, one after the other, in the order of a file.
class OneByOne {
public:
    OneByOne(const Discretisation& space, std::size_t count,
             const std::function<Eigen::VectorXd(std::size_t field)>& owned)
        : space_(space), count_(count), owned_(owned), order_(order_of_file(space))
    {}
    [[nodiscard]] bool at_end() const { return next_ == count_; }
    std::vector<float> next()
    {
        const Eigen::VectorXd own = owned_(next_++);
        const auto all = gather_all(space_, {own.begin(), own.end()}, 1);
        std::vector<float> field;
        field.reserve(order_.size());
        for (const auto unknown : order_)
            field.push_back(static_cast<float>(all[unknown]));
        return field;
    }

private:
    const Discretisation& space_;
    std::size_t count_, next_ = 0;
    const std::function<Eigen::VectorXd(std::size_t field)>& owned_;
    std::vector<std::size_t> order_;
};

}  // namespace

Field StateFields::lift(const Eigen::VectorXd& states) const
{
    Eigen::VectorXd values = Eigen::VectorXd::Zero(fields_.rows());
    for (Eigen::Index k = 0; k < fields_.cols(); ++k)
        values += states[k] * fields_.col(k).cast<double>();
    return {{values.begin(), values.end()}};
}

void write_fields(const std::string& file, const Discretisation& space, const std::string& model, std::size_t count,
                  const std::function<Eigen::VectorXd(std::size_t field)>& owned)
{
    OneByOne fields(space, count, owned);
    const FieldFileHead head{std::string(version), model, mesh_text(space)};
    std::string error;
    try {
        if (rank() == 0)
            write_file(file, [&](std::ostream& out) {
                BinaryWriter writer(out, fields_kind);
                writer(head, std::uint64_t{count});
                while (!fields.at_end())
                    writer(fields.next());
                writer.finish();
            });
    } catch (const IoError& reason) {
        error = reason.what();
    }
    while (!fields.at_end())  // the other ranks, and the first one after an error
        fields.next();
    error = from_first_rank(error);
    if (!error.empty())
        throw IoError(error);
}

StateFields read_fields(const std::string& file, const Discretisation& space, const std::string& model,
                        std::size_t states)
{
    const auto order = order_of_file(space);
    FieldReader in(file, {{}, model, mesh_text(space)}, states, order.size());
    Eigen::MatrixXf fields(space.last - space.first, static_cast<Eigen::Index>(states));
    for (auto column : fields.colwise()) {
        const auto owned = share_of_file(space, order, in.next());
        column = Eigen::Map<const Eigen::VectorXd>(owned.data(), static_cast<Eigen::Index>(owned.size())).cast<float>();
    }
    return StateFields(std::move(fields));
}

}  // namespace deadpoint::fem

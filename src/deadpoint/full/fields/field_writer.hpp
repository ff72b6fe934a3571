#pragma once

#include <string>
#include <vector>

namespace deadpoint {
struct Machine;
struct RigidMotion;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::fem {
class Model;
struct Adjoint;
struct Displacement;
struct Field;
struct PointData;
}  // namespace deadpoint::fem
namespace deadpoint::press {
struct ChainModel;
struct RunResult;
}  // namespace deadpoint::press

/// Deformation and field files at the field times of a run.
namespace deadpoint::full {

class FrameState;

class FieldWriter {
public:
    /// @param chain     may be null, as may `frame`
    /// @param folder    existing, for field files; empty: no files
    /// @param comments  for their heads
    FieldWriter(const casefile::Case& input, const Machine& machine, fem::Model& model, const press::ChainModel* chain,
                const FrameState* frame, const std::vector<fem::Adjoint>& adjoints, std::string folder,
                std::vector<std::string> comments);

    /// Solves the deformation at one time for the results that need it, and writes field files if
    /// requested. Collective.
    void write(double time, const fem::Field& field, press::RunResult& result);

private:
    /// Closes the joints. @return the rigid motions of the parts
    std::vector<RigidMotion> close(double time, const fem::Field& field, const fem::Displacement& displacement,
                                   press::RunResult& result);
    void write_file(double time, const fem::Field& field, const fem::Displacement* displacement,
                    const std::vector<RigidMotion>& motions, const std::vector<fem::PointData>& data,
                    press::RunResult& result);

    const casefile::Case& input_;
    const Machine& machine_;
    fem::Model& model_;
    const press::ChainModel* chain_;
    const FrameState* frame_;
    const std::vector<fem::Adjoint>& adjoints_;
    std::string folder_;
    std::vector<std::string> comments_;
    double reference_;
    std::vector<int> bodies_;
};

}  // namespace deadpoint::full

#pragma once

#include "deadpoint/fem/conduction/multigrid/float_matrix.hpp"

#include <optional>
#include <vector>

/// Internal to fem/: a multigrid cycle in single precision.
namespace deadpoint::fem {

/// A V-cycle on the hierarchy of a multigrid of PETSc, with copies of its matrices in single precision: two thirds of
/// the memory traffic. It approximates the inverse as well as a cycle in double precision; a solver around it keeps
/// residuals and solution in double.
///
/// Smoothing before and after: two steps of Chebyshev's iteration for D^-1 A on [b / 20, b], D the diagonal and b the
/// bound of the level (Saad, Iterative Methods for Sparse Linear Systems, 2003, algorithm 12.1). The same polynomial
/// before and after makes the cycle symmetric. The multigrid's own solver solves the coarsest level, in double.
class FloatCycle {
public:
    /// @param multigrid  that is set up and outlives this; its smoothers are not used
    explicit FloatCycle(PC multigrid);

    /// Copies the present matrices of all levels.
    /// @param bounds  upper bounds of the eigenvalues of D^-1 A, per level from the coarsest on; none of the coarsest
    void take_values(const std::vector<double>& bounds);
    /// correction = B residual. Collective.
    void apply(Vec residual, Vec correction);
    /// The same for each residual of a block, this rank's rows: all matrices are read once. Collective.
    void apply(const std::vector<DoubleBlock>& residuals, std::vector<DoubleBlock>& corrections);
    /// Writes rows and entries of the levels, and entries of the interpolation from the next coarser one, finest last.
    void view(PetscViewer viewer) const;

private:
    /// Between values of two levels. On several ranks the library may keep it in a format of its own and multiplies in
    /// double.
    class Transfer {
    public:
        /// @param to  vector of the level to which it leads; a matrix that leads the other way is transposed
        Transfer(Mat matrix, Vec to);
        template <class Value>
        void multiply(std::vector<Value>& in, std::vector<Value>& out, bool adds);
        [[nodiscard]] std::size_t ghosts() const { return copy_ ? copy_->ghosts() : 0; }
        [[nodiscard]] std::size_t entries() const;

    private:
        OwnedMat transposed_;  ///< none where the matrix leads the right way
        Mat matrix_;
        std::optional<FloatMatrix> copy_;
        OwnedVec in_, out_;  ///< where there is no copy
    };
    struct Level {
        Mat source;
        FloatMatrix matrix;
        Transfer restriction, interpolation;
        std::vector<float> inverse_diagonal;
        double bound = 1;
    };
    /// Vectors of a level. Value is float, or FloatBlock for a block of vectors.
    template <class Value>
    struct Vectors {
        std::vector<Value> right, solution, work;
    };
    template <class Value>
    using Stack = std::vector<Vectors<Value>>;  ///< of all levels, from the finest to the coarsest

    template <class Value>
    [[nodiscard]] Stack<Value> new_stack() const;
    template <class Value>
    void smooth(const Level& level, Vectors<Value>& vectors, bool from_zero) const;
    template <class Value>
    void cycle(Stack<Value>& stack, std::size_t index);
    template <class Value>
    void solve_coarsest(Vectors<Value>& vectors);

    std::vector<Level> levels_;  ///< from the finest on, without the coarsest
    KSP coarsest_ = nullptr;
    OwnedVec coarsest_in_, coarsest_out_;
    Stack<float> stack_;
    Stack<FloatBlock> block_stack_;  ///< empty until a block comes
};

}  // namespace deadpoint::fem

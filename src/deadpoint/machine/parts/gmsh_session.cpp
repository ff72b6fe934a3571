#include "deadpoint/machine/parts/gmsh_session.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/io/plain_reason.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <gmsh.h>
#include <new>
#include <optional>
#include <stdexcept>

namespace deadpoint::machine {

namespace {

[[noreturn]] void fail(const std::string& part, const char* step, const std::string& message)
{
    throw InputError(
        fmt::format("part '{}': {} failed ({}); look for shapes that touch in a point or nearly coincide, or "
                    "choose another cell size",
                    part, step, message));
}

/// Hides the home folder: Gmsh would write settings of its windows there, and remove a file that it takes for its own.
class NoHome {
public:
    NoHome()
    {
        if (const char* home = std::getenv("HOME")) {
            home_ = home;
        }
        setenv("HOME", "/dev/null", 1);
    }
    ~NoHome()
    {
        if (home_) {
            setenv("HOME", home_->c_str(), 1);
        } else {
            unsetenv("HOME");
        }
    }
    NoHome(const NoHome&) = delete;
    NoHome& operator=(const NoHome&) = delete;
    NoHome(NoHome&&) = delete;
    NoHome& operator=(NoHome&&) = delete;

private:
    std::optional<std::string> home_;
};

}  // namespace

GmshSession::GmshSession()
{
    {
        const NoHome no_home;
        gmsh::initialize(0, nullptr, false);
    }
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::option::setNumber("General.AbortOnError", 0);
    reset_gmsh();
}

GmshSession::~GmshSession()
{
    try {
        gmsh::finalize();
    } catch (...) {  // nothing useful can be done if finalizing fails
    }
}

void reset_gmsh()
{
    gmsh::clear();
    gmsh::model::add("part");
    const auto set = [](const char* name, double value) { gmsh::option::setNumber(name, value); };
    set("Mesh.RecombineAll", 0);
    set("Mesh.RecombinationAlgorithm", 1);
    set("Mesh.SubdivisionAlgorithm", 0);
    set("Mesh.Algorithm", 6);
    set("Mesh.Algorithm3D", 1);
    set("Mesh.MeshSizeMin", 0);
    set("Mesh.MeshSizeMax", 1e22);
    set("Mesh.MeshSizeFromPoints", 0);
    set("Mesh.MeshSizeFromCurvature", 0);
    set("Mesh.MeshSizeExtendFromBoundary", 1);
    set("Mesh.Optimize", 1);
    set("Mesh.OptimizeNetgen", 0);
    set("Mesh.ElementOrder", 1);
    set("Geometry.OCCUnionUnify", 1);
    gmsh::option::setString("Geometry.OCCTargetUnit", "MM");
}

void guard_gmsh(const std::string& part, const char* step, const std::function<void()>& work)
{
    try {
        work();
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::runtime_error& error) {  // with the text of Gmsh
        fail(part, step, error.what());
    } catch (const std::exception& error) {
        fail(part, step, plain_reason(error));
    } catch (const std::string& message) {
        fail(part, step, message);
    } catch (int code) {
        fail(part, step, fmt::format("Gmsh error {}", code));
    }
}

}  // namespace deadpoint::machine

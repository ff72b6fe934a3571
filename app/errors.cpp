#include "errors.hpp"

#include "deadpoint/io/plain_reason.hpp"
#include "output.hpp"

#include <filesystem>
#include <functional>
#include <new>
#include <string>
#include <system_error>

namespace {

constexpr int other_error = 1;  // a defect

/// @param show_text  takes the message of an error that is not the library's
int handle(const std::exception_ptr& thrown, const std::function<void(const deadpoint::Error&)>& show,
           const std::function<void(const std::string&)>& show_text)
{
    try {
        std::rethrow_exception(thrown);
    } catch (const deadpoint::Error& error) {
        show(error);
        return error.exit_code();
    } catch (const std::bad_alloc& error) {
        show_text(fmt::format("{}\n  help: make the mesh coarser, for example with --size 1.5",
                              deadpoint::plain_reason(error)));
        return static_cast<int>(deadpoint::ErrorKind::input);
    } catch (const std::filesystem::filesystem_error& error) {
        show_text(fmt::format("{}\n  help: check the length of the path and its permissions",
                              deadpoint::plain_reason(error)));
        return static_cast<int>(deadpoint::ErrorKind::io);
    } catch (const std::system_error& error) {
        show_text(fmt::format("the system refuses what the program needs: {}\n  help: end other programs, or raise the "
                              "limits of processes and open files (ulimit -u, ulimit -n)",
                              deadpoint::plain_reason(error)));
        return static_cast<int>(deadpoint::ErrorKind::io);
    } catch (const std::exception& error) {
        show_text(fmt::format("{}\n  help: this is a defect of the program; please report it with the case file",
                              deadpoint::plain_reason(error)));
    }
    return other_error;
}

}  // namespace

void print_error(const deadpoint::Error& error)
{
    const std::string text = error.what();
    const bool placed = text.find(": error[") != std::string::npos;
    print_err("{}{}\n", placed ? "" : "error: ", text);
}

int explain(const std::exception_ptr& thrown)
{
    return handle(thrown, print_error, [](const std::string& text) { print_err("error: {}\n", text); });
}

int exit_code_of(const std::exception_ptr& thrown)
{
    return handle(
        thrown, [](const deadpoint::Error&) {}, [](const std::string&) {});
}

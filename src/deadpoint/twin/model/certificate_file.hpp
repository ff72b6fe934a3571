#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

namespace deadpoint::reduce {
struct ResidualTerms;
}

namespace deadpoint::twin {

struct ReducedPress;

/// First line of the file.
inline constexpr std::string_view certificate_kind = "deadpoint certificate 2\n";

/// Name of the file of the certificate beside that of a reduced press: press.rom, press.certificate.rom.
std::filesystem::path certificate_file(const std::filesystem::path& press);

/// Writes what certificates of a reduced press need (docs/rom-file.md). @param large  its large model @throws IoError
void write_certificate(const std::filesystem::path& file, const ReducedPress& large,
                       const reduce::ResidualTerms& residual);
/// @throws IoError if the file cannot be read, is of another format, was cut short or changed; InputError if it belongs
///         to another press
std::shared_ptr<const reduce::ResidualTerms> read_certificate(const std::filesystem::path& file,
                                                              const ReducedPress& large);

}  // namespace deadpoint::twin

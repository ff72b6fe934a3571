#include "commands.hpp"
#include "deadpoint/report/schema/input_schema.hpp"
#include "output.hpp"

#include <memory>
#include <string>

void add_schema(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("schema", "print the JSON schema of case, study and other files, for editors");
    const auto kind = std::make_shared<std::string>("case");
    command->add_option("KIND", *kind, "case, study, calibration or reference; default: case")->type_name("KIND");
    command->callback([kind, &exit_code] {
        print_out("{}", deadpoint::report::schema::input_schema(*kind));
        exit_code = 0;
    });
}

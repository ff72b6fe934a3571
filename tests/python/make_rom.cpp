/// make_rom CASE FILE: a reduced press from few training runs on a coarse mesh, with its large model beside it, for
/// tests that need a model but not a good one.
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/full/run/reduce.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"

#include <filesystem>

using namespace deadpoint;

int main(int argc, char** argv)
{
    if (argc != 3)
        return 2;
    const fem::Session session(argc, argv);
    const std::filesystem::path file = argv[2];
    full::Press press(casefile::read_case(argv[1]).value, 4);
    auto options = full::reduce_options(press.input());
    options.build.sets = 12;
    options.build.training_runs = 16;
    options.build.test_runs = 2;
    options.build.largest = 40;
    options.build.temperature = 10;
    options.build.gap = 1e-5;
    Observer silent;
    auto reduction = press.reduce(options, silent);
    reduction->small.large_file = file.stem().string() + ".large.rom";
    twin::write_reduced(file.parent_path() / reduction->small.large_file, reduction->large);
    twin::write_reduced(file, reduction->small);
}

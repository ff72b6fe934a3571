# Thin: everything here can be typed by hand. `make run` shows the shipped press warming up, `make test` runs the tests.
PRESET ?= release
CASE ?= jl75g-60
# nproc counts the threads of OMP_NUM_THREADS, which make 4.4 passes on here.
JOBS ?= $(shell env -u OMP_NUM_THREADS nproc)
PROGRAM = build/$(PRESET)/app/deadpoint

# Open MPI refuses to start as root otherwise (containers); one thread per process, since the work is split by MPI.
export OMPI_ALLOW_RUN_AS_ROOT = 1
export OMPI_ALLOW_RUN_AS_ROOT_CONFIRM = 1
export OMP_NUM_THREADS = 1

.PHONY: run test quick docs sanitize gates validate program build dependencies test-dependencies format clean

run: program
	build/$(PRESET)/app/deadpoint run cases/$(CASE)/case.toml -o results/$(CASE) --force

test: build
	ctest --preset $(PRESET) --parallel $(JOBS)

# Unit tests, bad cases and include rules: two minutes, once they are built.
quick: test-dependencies
	@cmake --preset $(PRESET) --log-level=WARNING
	cmake --build --preset $(PRESET) --parallel $(JOBS) --target fast_tests
	ctest --preset $(PRESET) --parallel $(JOBS) -L fast

# The documentation as a site without network: build/docs/index.html.
docs:
	@command -v mkdocs >/dev/null || { echo "error: there is no mkdocs; help: apt-get install mkdocs mkdocs-material" >&2; exit 1; }
	mkdocs build --strict --quiet

# All tests with address and undefined-behaviour sanitizers.
sanitize:
	$(MAKE) test PRESET=debug

# The checks beyond the tests of every change; hours.
gates:
	scripts/install-dependencies --checks
	scripts/gates

# Writes docs/validation anew: what the tests hold against exact and published figures, then the paper, then what the results depend on and
# the comparison with CalculiX, which take an hour.
validate: build
	ctest --preset $(PRESET) -R '^verification_(heat|elastic)$$'
	scripts/validate.py build/$(PRESET)/validation --write
	scripts/paper-equations.py
	scripts/paper-heat.py --write --program $(PROGRAM) --tests build/$(PRESET)/tests/paper/test_paper
	scripts/paper-loads.py --write --program $(PROGRAM)
	scripts/paper-results.py --write --program $(PROGRAM)
	rm -rf build/independence
	scripts/independence.py --write --program $(PROGRAM)
	scripts/compare-calculix.py --write --program $(PROGRAM)

# Only what the program needs, without tests.
program: dependencies
	@cmake --preset $(PRESET) --log-level=WARNING
	cmake --build --preset $(PRESET) --parallel $(JOBS) --target deadpoint

build: test-dependencies
	@cmake --preset $(PRESET) --log-level=WARNING
	cmake --build --preset $(PRESET) --parallel $(JOBS)

dependencies:
	@scripts/install-dependencies

test-dependencies:
	@scripts/install-dependencies --tests

format:
	scripts/format

clean:
	rm -rf build

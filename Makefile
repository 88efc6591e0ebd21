# The doors of the project. Everything else is CMake's.
#
#   make            the release: build/arris
#   make demo       install what is needed, reconstruct a real scan, and draw it
#   make test       install what is needed, build and run every test
#   make bench      quality, the paper's table and figures, time and memory: a page, in minutes
#   make bench-full the same of everything, in hours; goes on where it was stopped
#   make peers      install what the benchmark compares arris with
#   make sanitize   the test suite under ASan and UBSan (clang)
#   make tsan       the tests of threads under TSan (clang)
#   make fuzz       every fuzz target for FUZZ_SECONDS seconds (clang)
#   make format     apply clang-format; make format-check only looks
#   make tidy       clang-tidy on the library and the command
BUILD ?= build
JOBS ?= $(shell nproc)
FUZZ_SECONDS ?= 5
# BENCH_QUICK=1: under two minutes, without peers. BENCH_SIZES: points of the speed suite.
# BENCH_OPTIONS: more options of bench/benchmark.py.
BENCH_QUICK ?=
BENCH_SIZES ?=
BENCH_OPTIONS ?=
BENCHMARK = python3 bench/benchmark.py --build $(BUILD) \
  $(if $(BENCH_SIZES),--sizes '$(BENCH_SIZES)') $(BENCH_OPTIONS)
# Tests that run more than one thread, for TSan, by name; tests/threads lists the files that have
# them.
TSAN_TESTS ?= ^threads\..*(Parallel|Thread)

# Suites that measure whole reconstructions, for minutes; the other pipeline tests run the same code.
SANITIZE_SKIP ?= ^quality\.|^pipeline_sharp\.

# Checks of the standard library's own stay on under the sanitizers; CGAL's slow ones do not.
# At -O1 clang compiles no sooner, and the tests take up to half as long again.
# No time of day in precompiled headers, so that ccache knows them again.
SANITIZE_FLAGS = -O2 -DNDEBUG -D_GLIBCXX_ASSERTIONS -Xclang -fno-pch-timestamp
CLANG = -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Sanitize \
  -DCMAKE_CXX_FLAGS_SANITIZE="$(SANITIZE_FLAGS)" -DARRIS_PCH=ON
# ccache makes a second build cheap where it is installed.
CCACHE := $(if $(shell command -v ccache),-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
# What its manual asks for with precompiled headers; nothing here uses __TIME__.
export CCACHE_SLOPPINESS ?= pch_defines,time_macros
CONFIGURE = cmake -S . -G Ninja $(CCACHE)
SOURCES = $(shell find include src cli tests bench viewer examples \
  \( -name '*.cpp' -o -name '*.h' -o -name '*.cu' \) 2>/dev/null | sort)
TIDY_SOURCES ?= $(shell find src cli -name '*.cpp' | sort)

.PHONY: all demo test bench bench-full bench-build peers dependencies sanitize tsan fuzz format format-check tidy

all:
	$(CONFIGURE) -B $(BUILD)
	cmake --build $(BUILD) -j $(JOBS) --target arris arris_cli

demo: dependencies
	$(MAKE) all
	scripts/demo.sh $(BUILD)

dependencies:
	scripts/install-deps.sh

bench: bench-build
	$(BENCHMARK) $(if $(BENCH_QUICK),--quick)

bench-full: bench-build
	$(BENCHMARK) --full

bench-build: dependencies
	$(CONFIGURE) -B $(BUILD) -DARRIS_BUILD_BENCH=ON
	cmake --build $(BUILD) -j $(JOBS) --target arris_cli scaling_bench

peers: bench-build
	scripts/install-peers.sh $(BUILD)

test: dependencies
	$(CONFIGURE) -B $(BUILD) -DARRIS_BUILD_TESTS=ON
	cmake --build $(BUILD) -j $(JOBS)
	ctest --test-dir $(BUILD) -j $(JOBS) --output-on-failure

sanitize: dependencies
	$(CONFIGURE) -B build-asan $(CLANG) -DARRIS_BUILD_TESTS=ON -DARRIS_SANITIZE=address,undefined
	cmake --build build-asan -j $(JOBS)
	ctest --test-dir build-asan -j $(JOBS) --output-on-failure -E '$(SANITIZE_SKIP)'

# setarch -R: the thread sanitizer of clang 14 needs a fixed memory layout on recent kernels.
tsan: dependencies
	$(CONFIGURE) -B build-tsan $(CLANG) -DARRIS_BUILD_TESTS=ON -DARRIS_SANITIZE=thread
	cmake --build build-tsan -j $(JOBS) --target test_threads
	setarch -R ctest --test-dir build-tsan -j $(JOBS) --output-on-failure --no-tests=error \
	  -R '$(TSAN_TESTS)'

fuzz: dependencies
	ARRIS_FUZZ_CMAKE='$(CCACHE)' tests/fuzz/run.sh $(FUZZ_SECONDS) build-fuzz

format:
	clang-format -i $(SOURCES)

format-check:
	@clang-format --dry-run --Werror $(SOURCES)

# Against the compilation database of $(BUILD), whose compiler may know warnings that clang does
# not; system headers are not looked into.
tidy:
	$(CONFIGURE) -B $(BUILD) >/dev/null
	printf '%s\n' $(TIDY_SOURCES) | xargs -P $(JOBS) -n 1 clang-tidy --quiet -p $(BUILD) \
	  --extra-arg=-Wno-unknown-warning-option

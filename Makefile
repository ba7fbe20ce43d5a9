# make demo   install what is missing, build, compute ENVISAT's pass of 2016-09-21 in both bands
# make test   build and run the tests
# make lab    hidden effects, diagnosed blind: an hour and more; make lab LAB="--quick" seconds
# make install [PREFIX=/usr/local] [DESTDIR=...]   program, library, materials, scenarios, headers, man pages, documents
# make deb    Debian packages in out/deb;  make wheel   the Python package with all libraries in it, in out/wheel
# make docs   all pages as a site, build/site/index.html, with a reference that the program prints
# make mutate plant errors one at a time, each must be noticed; make mutate MUTATE="--only optics" some of them
# make demo-study   what rules ENVISAT's light: emittance of its cells, heat inside, MLI; 1000 points
# make bench  benchmarks as ratios;  make check  static checks and sanitizers (what CI runs)
# make fuzz   every fuzz target for ten minutes; FUZZ_SECONDS=60 FUZZ="csv model" shorter, fewer
# make tidy   clang-tidy with path analysis;  make coverage   which lines the tests reach
# make bricks   pull every effect, lobe, filter, sensor and scenario in turn; BRICKS="cirrus ggx" some; a day
# make tsan   many threads on one model under ThreadSanitizer: minutes
# make nightly   all tests under the sanitizers, tidy, fuzz, mutate, one brick of each kind: hours
FUZZ_SECONDS ?= 600
export FUZZ FUZZ_SECONDS
BUILD ?= build
JOBS ?= $(shell nproc)
PREFIX ?= /usr/local

.PHONY: all deps configure program build demo demo-study test install deb wheel lab bench check fuzz tidy coverage tsan nightly mutate bricks docs clean

all: program

deps:
	@tools/install-deps

configure: deps
	@cmake -S . -B $(BUILD) -G Ninja -DCMAKE_BUILD_TYPE=Release $(CMAKE_FLAGS) >$(BUILD).log 2>&1 || { cat $(BUILD).log; exit 1; }
	@rm -f $(BUILD).log

# the program, its man pages and completions; `build` has the tests too
program: configure
	@cmake --build $(BUILD) -j $(JOBS) --target program

build: configure
	@cmake --build $(BUILD) -j $(JOBS)

demo: program
	$(BUILD)/umbra run scenarios/envisat-graz-2016 --out out/envisat-graz-2016 \
		--picture 2016-09-21T20:33:00Z --picture first-light
	@echo "beside it pictures in *.png, and every wavelength of two views in *.exr"

demo-study: program
	$(BUILD)/umbra study scenarios/envisat-graz-2016/study.yaml --out out/envisat-study

test:
	@tools/install-deps --tests
	@$(MAKE) --no-print-directory build
	tools/run-tests $(BUILD) -j $(JOBS)

install: program
	@DESTDIR="$(DESTDIR)" cmake --install $(BUILD) --prefix "$(PREFIX)" >$(BUILD)/install.log || { cat $(BUILD)/install.log; exit 1; }
	@echo "installed: $(DESTDIR)$(PREFIX)/bin/umbra"

deb:
	@tools/install-deps --deb
	@tools/make-deb $(JOBS)

wheel:
	@tools/install-deps --wheel
	@tools/make-wheel $(JOBS)

docs: program
	@tools/install-deps --docs
	@$(firstword $(wildcard /usr/bin/python3) python3) tools/docs/build.py $(BUILD)

lab: build
	$(BUILD)/tests/lab/lab --out out/lab $(LAB)

mutate: deps
	tools/mutate $(MUTATE)

bricks: deps
	tools/pull-any-brick $(BRICKS)

bench: configure
	tools/bench $(BUILD) $(BENCH)

check:
	tools/check

fuzz:
	@tools/install-deps --checks
	@tools/fuzz

tidy:
	@tools/install-deps --checks
	@tools/tidy

coverage:
	@tools/install-deps --checks
	@tools/coverage

tsan:
	@tools/nightly shared

nightly:
	@tools/nightly

clean:
	rm -rf $(BUILD) build-*

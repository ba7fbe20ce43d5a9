# make demo   install what is missing, build, compute ENVISAT's pass of 2016-09-21 in both bands
# make test   build and run the tests
# make lab    hidden effects, diagnosed blind: an hour and more; make lab LAB="--quick" seconds
# make bench  benchmarks as ratios;  make check  static checks and sanitizers (what CI runs)
BUILD ?= build
JOBS ?= $(shell nproc)

.PHONY: all deps build demo test lab bench check clean

all: build

deps:
	@tools/install-deps

build: deps
	@cmake -S . -B $(BUILD) -G Ninja -DCMAKE_BUILD_TYPE=Release $(CMAKE_FLAGS) >$(BUILD).log 2>&1 || { cat $(BUILD).log; exit 1; }
	@rm -f $(BUILD).log
	@cmake --build $(BUILD) -j $(JOBS)

demo: build
	$(BUILD)/umbra run scenarios/envisat-graz-2016 --out out/envisat-graz-2016
	@echo "pictures: out/envisat-graz-2016/*.png"

test: build
	ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS)

lab: build
	$(BUILD)/tests/lab/lab --out out/lab $(LAB)

bench: build
	tools/bench $(BUILD) $(BENCH)

check:
	tools/check

clean:
	rm -rf $(BUILD) build-*

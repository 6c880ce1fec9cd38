# Thin: says what to do, CMake and the scripts do it. `make help` lists the targets.

BUILD := build
JOBS := 2
BLENDER ?= blender
VIRTUAL_DISPLAY := xvfb-run -a -s "-screen 0 1024x700x24"

.PHONY: help build demo zip test gui pictures bench format
.DEFAULT_GOAL := help

help:
	@echo "make demo     knit the sock: machine file, report and picture in $(BUILD)/demo"
	@echo "make test     all tests: C++, Python module, headless Blender, Blender with a simulated mouse"
	@echo "make build    the library and the add-on's Python module"
	@echo "make gui      Blender with the add-on on and the sock in the scene"
	@echo "make zip      the add-on for Blender's preferences: $(BUILD)/meshknit.zip"
	@echo "make pictures the documentation's pictures, from a simulated person's work"
	@echo "make bench    benchmarks: they print tables"
	@echo "make format   clang-format and black"

# Tests and benchmarks have a tree of their own, so that a demo builds no more than it needs.
build:
	@.ci/install_packages demo
	@cmake -S . -B $(BUILD)/release -G Ninja -DMESHKNIT_TESTS=OFF -DMESHKNIT_BENCHMARKS=OFF \
	  -DMESHKNIT_BLENDER=$(BLENDER) --log-level=WARNING
	@cmake --build $(BUILD)/release --parallel $(JOBS)

demo: build
	@$(BLENDER) --background --factory-startup --python addon/meshknit/demo.py -- $(BUILD)/demo

gui: build
	@$(BLENDER) --factory-startup --python addon/meshknit/demo.py -- --gui

zip: build
	@cd addon && find meshknit -name __pycache__ -prune -o -type f -print | sort > ../$(BUILD)/meshknit.files
	@cd addon && cmake -E tar cf ../$(BUILD)/meshknit.zip --format=zip --files-from=../$(BUILD)/meshknit.files
	@echo "$(BUILD)/meshknit.zip: in Blender, Edit > Preferences > Add-ons > Install"

# The tests that walk through what the documentation shows leave its pictures.
pictures: build
	@.ci/install_packages test
	@$(VIRTUAL_DISPLAY) $(BLENDER) --factory-startup --enable-event-simulate -p 0 0 1024 700 \
	  --python blender_tests/run_gui.py -- -q --pictures=addon/docs --basetemp=/tmp/meshknit-pictures \
	  blender_tests/gui/test_marking.py blender_tests/gui/test_whole_path.py

test:
	@.ci/install_packages test
	@cmake -S . -B $(BUILD)/test -G Ninja -DMESHKNIT_BLENDER=$(BLENDER) --log-level=WARNING
	@cmake --build $(BUILD)/test --parallel $(JOBS)
	@ctest --test-dir $(BUILD)/test --output-on-failure --parallel $(JOBS)

bench:
	@.ci/install_packages test
	@cmake -S . -B $(BUILD)/test -G Ninja -DMESHKNIT_BLENDER=$(BLENDER) --log-level=WARNING
	@cmake --build $(BUILD)/test --parallel $(JOBS)
	@failed=0; for program in $(BUILD)/test/native/benchmarks/bench_*; do \
	  test ! -x $$program || test -d $$program || \
	    { echo "== $$(basename $$program)"; $$program || failed=1; }; done; \
	  echo "== bench_live"; $(BLENDER) --background --factory-startup \
	    --python blender_tests/bench_live.py || failed=1; exit $$failed

format:
	@.ci/install_packages format
	@git ls-files 'native/*.h' 'native/*.cpp' | xargs clang-format -i
	@git ls-files '*.py' | xargs black -q -l 100

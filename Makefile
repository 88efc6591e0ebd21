# The doors of the project. Everything else is CMake's.
BUILD ?= build
JOBS ?= $(shell nproc)

.PHONY: all
all:
	cmake -S . -B $(BUILD) -G Ninja
	cmake --build $(BUILD) -j $(JOBS)

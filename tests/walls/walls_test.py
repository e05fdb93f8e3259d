#!/usr/bin/python3
"""Proves that an include which the table of docs/architecture.md does not allow does not compile.

Preprocesses one-line sources with the include directories that CMake gives to each module. For
every ordered pair of modules, and for each library that belongs to one module, the verdict must be
that of the table below, and a refusal must be about the header in question. The table is written
out here once more, so that a slip in CMakeLists.txt cannot agree with itself.
"""

import argparse
import pathlib
import subprocess
import sys

MODULES = {
    "base": set(),
    "geometry": {"base"},
    "sheet": {"base", "geometry"},
    "collision": {"base", "geometry", "sheet"},
    "brake": {"base", "geometry", "sheet"},
    "inspect": {"base", "geometry", "sheet"},
    "connect": {"base", "geometry", "sheet"},
    "transition": {"base", "geometry", "sheet"},
    "slit": {"base", "geometry", "sheet"},
    "nest": {"base", "geometry", "sheet"},
    "io": {"base", "geometry", "sheet"},
    "process": {"base"},
    "schema": {"base", "geometry"},
    "shop": {"base", "geometry", "sheet", "schema", "brake", "inspect", "io"},
    "drawing": {"base", "geometry", "sheet", "schema", "brake", "io"},
    "brep": {"base", "geometry", "sheet"},
    "job": {"base", "geometry", "sheet", "collision", "brake", "inspect", "connect", "transition", "slit", "io",
            "process", "schema", "shop", "drawing", "brep"},
    "batch": {"base", "geometry", "sheet", "collision", "brake", "inspect", "connect", "transition", "slit", "io",
              "process", "schema", "shop", "drawing", "brep", "job"},
    "serve": {"base", "geometry", "sheet", "collision", "brake", "inspect", "connect", "transition", "slit", "io",
              "process", "schema", "shop", "drawing", "brep", "job"},
    "pack": {"base", "geometry", "sheet", "collision", "brake", "inspect", "connect", "transition", "slit", "nest",
             "io", "process", "schema", "shop", "drawing", "brep", "job", "batch"},
}
LIBRARIES = {
    "Eigen/Core": set(MODULES) - {"base", "process"},
    "geos_c.h": {"geometry"},
    "dxflib/dl_dxf.h": {"io"},
    "cairo/cairo.h": {"io"},
    "ceres/tiny_solver.h": {"slit"},
    "nanoflann.hpp": {"slit"},
    "ccd/ccd.h": {"collision"},
    "libnest2d/libnest2d.hpp": {"nest"},
    "polyclipping/clipper.hpp": {"nest"},
    "nlohmann/json.hpp": {"io", "schema", "shop", "drawing", "job", "batch", "serve", "pack"},
    "zlib.h": {"brep", "pack"},
    "gp_Pnt.hxx": {"brep"},
    "coin/Cbc_C_Interface.h": set(),
    "CLI/CLI.hpp": set(),
    "httplib.h": set(),
}


def first_header(source, module):
    """A public header of the module, as it is included; None where the module has none yet."""
    include = source / "include"
    headers = sorted((include / "planish" / module).glob("**/*.hpp"))
    return str(headers[0].relative_to(include)) if headers else None


def refusal(compiler, directories, header):
    """None where the header can be included, else what the compiler says."""
    command = [compiler, "-std=c++20", "-E", "-o", "/dev/null", "-x", "c++", "-"]
    command += [f"-I{directory}" for directory in directories]
    run = subprocess.run(command, input=f"#include <{header}>\n", capture_output=True, text=True)
    return run.stderr if run.returncode else None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--compiler", required=True)
    parser.add_argument("--source", required=True, type=pathlib.Path)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    options = parser.parse_args()

    built = [m for m in MODULES if (options.build / "walls" / f"{m}.includes").exists()]
    allowed = {}  # header -> modules that may include it
    for module in MODULES:
        header = first_header(options.source, module)
        if header:
            allowed[header] = {module} | {m for m, uses in MODULES.items() if module in uses}
    # A library that this build was not configured with proves nothing by not being found.
    libraries = dict(LIBRARIES)
    if "brep" not in built:
        del libraries["gp_Pnt.hxx"]
    allowed.update(libraries)

    wrong = []
    verdicts = {True: 0, False: 0}
    for module in built:
        lines = (options.build / "walls" / f"{module}.includes").read_text().split("\n")
        directories = [line for line in lines if line]
        for header, modules in allowed.items():
            said = refusal(options.compiler, directories, header)
            may = module in modules
            verdicts[may] += 1
            if may and said is not None:
                wrong.append(f"{module} may include <{header}> but cannot:\n{said}")
            elif not may and said is None:
                wrong.append(f"{module} may not include <{header}> but can")
            elif not may and header not in said and "wall: " not in said:
                wrong.append(f"{module} cannot include <{header}>, for another reason:\n{said}")

    print(f"{verdicts[True]} includes that must compile and {verdicts[False]} that must not, "
          f"from {len(built)} modules: {len(wrong)} wrong")
    print("\n".join(wrong))
    if not built or not verdicts[True] or not verdicts[False]:
        sys.exit("nothing was proved")
    sys.exit(1 if wrong else 0)


main()

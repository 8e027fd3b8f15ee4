"""Whole processes in pairs: A B A B …, medians and the ratio of each pair. Standard library only.

    cargo build --release
    python3 benches/pairs.py [--runs 9] [--rodete target/release/rodete]

Pairs: the build of the published case against a numpy + openpyxl script of the same job, and against LibreOffice
converting a workbook of the same tables; the report against typst compiling the same files alone; the build of
100,000 intervals by itself, for its memory; 200,000 five-axis lines and 200,000 arcs with R through `rodete verify`
against LinuxCNC's `rs274 -g`; and 10 million lines by themselves, for the memory.
"""

import argparse
import os
import random
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).parent


def run(command, cwd=None):
    start = time.perf_counter()
    child = subprocess.Popen(command, cwd=cwd, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    wall = time.perf_counter() - start
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode:
        sys.exit(f"{command[0]} ended with {child.returncode}")
    return wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def pair(title, ours, other, runs):
    run(ours), run(other)
    rows = [(run(ours), run(other)) for _ in range(runs)]
    median = lambda pick: statistics.median(pick(row) for row in rows)
    print(
        f"{title}: {1000 * median(lambda r: r[0][0]):.0f} ms against {1000 * median(lambda r: r[1][0]):.0f} ms, "
        f"ratio {median(lambda r: r[1][0] / r[0][0]):.1f} (processor time {median(lambda r: r[1][1] / r[0][1]):.1f}); "
        f"{median(lambda r: r[0][2]):.0f} MB against {median(lambda r: r[1][2]):.0f} MB"
    )


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--runs", type=int, default=9)
    arguments.add_argument("--rodete", default=str(HERE.parent / "target/release/rodete"))
    arguments = arguments.parse_args()
    rodete, runs = str(Path(arguments.rodete).resolve()), arguments.runs
    case = str(HERE.parent / "workbooks/impeller-tfg-2021.xlsx")
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        build = [rodete, "build", case, "-o", str(folder / "out"), "--no-report"]
        run(build)
        results = folder / "out/impeller-tfg-2021-results.xlsx"

        peer = [sys.executable, str(HERE / "peer_numpy_openpyxl.py"), case, str(folder / "peer")]
        pair("build --no-report against numpy + openpyxl", build, peer, runs)

        office = shutil.which("soffice")
        if office:
            convert = [office, f"-env:UserInstallation=file://{folder}/profile", "--headless", "--convert-to",
                       "xlsx:Calc MS Excel 2007 XML", "--outdir", str(folder / "office"), str(results)]
            pair("build --no-report against LibreOffice converting the results", build, convert, runs)
        else:
            print("LibreOffice is missing: not compared")

        # A typst that keeps the files it is given, so that they can be compiled alone.
        keep = folder / "keep.sh"
        keep.write_text(f'#!/bin/sh\n[ -d "{folder}/files" ] || cp -r "$PWD" "{folder}/files"\n'
                        f'printf "%s\\n" "$PWD" "$@" >"{folder}/arguments"\nexec "{rodete}" typst "$@"\n')
        keep.chmod(0o755)
        run([rodete, "build", case, "-o", str(folder / "out"), "--typst", str(keep)])
        root, *given = (folder / "arguments").read_text().splitlines()
        alone = [rodete, "typst", *[one.replace(root, str(folder / "files")) for one in given]]
        os.chdir(folder / "files")
        whole = [rodete, "build", case, "-o", str(folder / "out")]
        pair("typst compile alone against build with report", alone, whole, runs)

        programs(rodete, folder, runs)

        long = folder / "long.xlsx"
        subprocess.run([sys.executable, "-c", LONG, case, str(long)], check=True)
        command = [rodete, "build", str(long), "-o", str(folder / "out"), "--no-report"]
        times = [run(command) for _ in range(3)]
        print(f"build --no-report, n = 100,000: {statistics.median(t[0] for t in times):.1f} s, "
              f"{max(t[2] for t in times):.0f} MB")


def five_axes(path, lines):
    """G1 in X, Y, Z, B and C, three decimals; no move of no length."""
    rolls = random.Random(1)
    with open(path, "w") as out:
        out.write("G21 G90 G94 F500\n")
        for n in range(1, lines):
            x, y, z = (rolls.uniform(-100, 100) for _ in range(3))
            out.write(f"N{n % 90000 + 1} G1 X{x:.3f} Y{y:.3f} Z{z:.3f} B{rolls.uniform(0, 90):.3f} "
                      f"C{rolls.uniform(-360, 360):.3f}\n")
        out.write("M2\n")


def arcs(path, lines):
    """G2 and G3 with R, three decimals."""
    rolls = random.Random(2)
    x = y = 0.0
    with open(path, "w") as out:
        out.write("G21 G90 G94 F500\nG0 X0 Y0\n")
        for n in range(2, lines):
            to = rolls.uniform(-50, 50), rolls.uniform(-50, 50)
            radius = ((to[0] - x) ** 2 + (to[1] - y) ** 2) ** 0.5 / 2 + rolls.uniform(0.001, 20)
            x, y = to
            out.write(f"G{2 + n % 2} X{x:.3f} Y{y:.3f} R{radius:.3f}\n")
        out.write("M2\n")


def programs(rodete, folder, runs):
    judge = shutil.which("rs274")
    (folder / "tools.tbl").write_text("T1 P1 D1 Z0\n")
    os.environ["HOME"] = str(folder)
    for title, make in [("200,000 five-axis lines", five_axes), ("200,000 arcs with R", arcs)]:
        path = folder / "program.ngc"
        make(path, 200_000)
        ours = [rodete, "verify", str(path), "--dialect", "linuxcnc"]
        if judge:
            fresh = f'rm -f "{folder}/var"; : >"{folder}/var"; exec "{judge}" -t "{folder}/tools.tbl" -v "{folder}/var" -g "{path}"'
            pair(f"verify, {title}, against rs274 -g", ours, ["sh", "-c", fresh], runs)
        else:
            print("rs274 is missing: not compared")
    path = folder / "long.ngc"
    five_axes(path, 10_000_000)
    wall, _, memory = run([rodete, "verify", str(path), "--dialect", "linuxcnc"])
    print(f"verify, 10 million lines: {wall:.1f} s, {memory:.1f} MB")


LONG = """
import sys, openpyxl
book = openpyxl.load_workbook(sys.argv[1])
sheet = book.worksheets[0]
for row in sheet.iter_rows(min_col=1, max_col=3):
    if row[0].value == "n":
        row[2].value = 100000
book.save(sys.argv[2])
"""

if __name__ == "__main__":
    main()

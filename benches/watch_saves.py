"""How long it takes from a save to new results: `rodete watch` over the published case, without the report or with it.

Usage: watch_saves.py RODETE [--report] [SAVES]. Saves as Excel does, by a rename; prints the milliseconds from the rename to the
renamed results, and to the line that says so. It needs openpyxl."""

import os
import signal
import subprocess
import sys
import tempfile
import time

import openpyxl

report = "--report" in sys.argv
words = [word for word in sys.argv[1:] if word != "--report"]
rodete, saves = os.path.abspath(words[0]), int(words[1]) if len(words) > 1 else 11
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    subprocess.run([rodete, "new", "impeller", "case.xlsx", "--case", "tfg-2021"], check=True, stdout=subprocess.DEVNULL)
    for at in range(saves):
        book = openpyxl.load_workbook("case.xlsx")
        cell = next(row[2] for row in book["DATA"].iter_rows() if row[0].value == "e")
        cell.value = 1 + at / (2 * saves)
        book.save(f"{at}.tmp")
    asked = [rodete, "watch", "case.xlsx"] + ([] if report else ["--no-report"])
    watch = subprocess.Popen(asked, text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    # What it watches and builds, the first build, and that it waits.
    for _ in range(4):
        watch.stdout.readline()
    times = []
    for at in range(saves):
        time.sleep(2.5 if report else 0.5)
        begun = time.time()
        os.rename(f"{at}.tmp", "case.xlsx")
        watch.stdout.readline()
        told = time.time() - begun
        times.append((1000 * (os.stat("case-out/case-results.xlsx").st_ctime - begun), 1000 * told))
    watch.send_signal(signal.SIGINT)
    watch.wait()
for name, column in zip(("results", "line"), zip(*times)):
    print(f"{name}: median {sorted(column)[saves // 2]:.0f} ms, most {max(column):.0f} ms")

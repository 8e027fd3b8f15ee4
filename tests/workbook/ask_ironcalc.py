"""Asks IronCalc, a spreadsheet engine of its own, what every formula of workbooks comes to.

    python3 ask_ironcalc.py BOOK.xlsx ...

For every formula with a stored result: the same number or the same text. For every formula without one: no error. What
differs is told, a line each; the last line of each book counts the cells. IronCalc itself prints on standard error.
"""

import os
import re
import sys
import zipfile
from xml.etree import ElementTree

import ironcalc

MAIN = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"
RELATION = "{http://schemas.openxmlformats.org/officeDocument/2006/relationships}id"
TOLD = 20
# Greatest difference, for numbers up to 1 and in parts of larger ones. The centre of a flat arc lies far off its three points, and
# the angle of a torch that stands upright is a cosine near 1: there the last digits of the points count many times.
CLOSE = 1e-13
FAR = {"Arcs": 1e-10, "Arcos": 1e-10}


def sheets(package):
    """Name and part of every worksheet, in their order; None for the part of a sheet of another kind."""
    relations = ElementTree.fromstring(package.read("xl/_rels/workbook.xml.rels"))
    targets = {one.get("Id"): one.get("Target") for one in relations}
    book = ElementTree.fromstring(package.read("xl/workbook.xml"))
    for sheet in book.find(f"{MAIN}sheets"):
        target = targets[sheet.get(RELATION)]
        yield sheet.get("name"), ("xl/" + target.removeprefix("/xl/")) if "worksheets/" in target else None


def formulas(package, part):
    """Address, formula, kind and stored result of every formula of a sheet."""
    for _, cell in ElementTree.iterparse(package.open(part)):
        if cell.tag == f"{MAIN}c" and cell.find(f"{MAIN}f") is not None:
            value, formula = cell.find(f"{MAIN}v"), cell.find(f"{MAIN}f").text or ""
            yield cell.get("r"), formula, cell.get("t", "n"), None if value is None else (value.text or "")
        if cell.tag == f"{MAIN}row":
            cell.clear()


def place(address):
    letters, row = re.fullmatch(r"([A-Z]+)(\d+)", address).groups()
    column = 0
    for letter in letters:
        column = 26 * column + ord(letter) - ord("A") + 1
    return int(row), column


def differs(name, kind, stored, found):
    """Why the value found is not the one stored; None where it is."""
    if stored is None or kind == "e":
        wrong = isinstance(found, str) and found.startswith("#")
        return found if wrong else None
    if kind == "n":
        stored = float(stored)
        if not isinstance(found, (int, float)) or isinstance(found, bool):
            return f"{stored!r} is {found!r}"
        apart = abs(found - stored) / max(1.0, abs(stored))
        return f"{stored!r} is {found!r}" if apart > FAR.get(name, CLOSE) else None
    if kind == "b":
        return None if bool(int(stored)) == found else f"{stored} is {found!r}"
    # What shows nothing is stored as a blank.
    return None if str(stored).strip() == str("" if found is None else found).strip() else f"{stored!r} is {found!r}"


def main(paths):
    wrong = 0
    for path in paths:
        model = ironcalc.load_from_xlsx(path, "en", "UTC", "en")
        model.evaluate()
        count, told, beyond = 0, 0, 0
        with zipfile.ZipFile(path) as package:
            # IronCalc compares no two ranges cell by cell: the flags of lists are beyond it, and what asks their sum.
            lists = any(b"SUMPRODUCT(" in package.read(part) for _, part in sheets(package) if part)
            for at, (name, part) in enumerate(sheets(package)):
                for address, formula, kind, stored in formulas(package, part) if part else ():
                    asks = "SUMPRODUCT(" in formula or "stale_inputs" in formula or "ISERROR(SUM(C2" in formula
                    if lists and asks:
                        beyond += 1
                        continue
                    count += 1
                    why = differs(name, kind, stored, model.get_cell_value(at, *place(address)))
                    if why is not None:
                        told += 1
                        if told <= TOLD:
                            print(f"{os.path.basename(path)}: {name}!{address}: {why}")
        print(f"{os.path.basename(path)}: {count} formulas, {told} differ, {beyond} not asked")
        wrong += told
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

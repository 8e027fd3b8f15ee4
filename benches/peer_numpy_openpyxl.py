"""The same job as `rodete build --no-report`, as an engineer would script it with numpy and openpyxl.

    python3 benches/peer_numpy_openpyxl.py workbooks/impeller-tfg-2021.xlsx OUT_FOLDER

Reads the parameters, computes annexes 1-8, the intersection and the splitter, writes every table as a sheet and the
programs in the published layout. It checks nothing: it is here to be timed against.
"""

import sys
from pathlib import Path

import numpy as np
import openpyxl


def parameters(path):
    sheet = openpyxl.load_workbook(path, data_only=True).worksheets[0]
    return {row[0]: row[2] for row in sheet.iter_rows(min_col=1, max_col=3, values_only=True) if row[0]}


def turn_c(a, C):
    c, s = np.cos(C), np.sin(C)
    return np.column_stack([c * a[:, 0] + s * a[:, 1], -s * a[:, 0] + c * a[:, 1], a[:, 2]])


def turn_b(a, B):
    c, s = np.cos(B), np.sin(B)
    return np.column_stack([c * a[:, 0] - s * a[:, 2], a[:, 1], s * a[:, 0] + c * a[:, 2]])


def crossing(own, other):
    best = None
    for i in range(len(own) - 1):
        p = own[i + 1] - own[i]
        q = other[1:] - other[:-1]
        d = other[:-1] - own[i]
        turn = p[0] * q[:, 1] - p[1] * q[:, 0]
        with np.errstate(divide="ignore", invalid="ignore"):
            s = (d[:, 0] * q[:, 1] - d[:, 1] * q[:, 0]) / turn
            t = (d[:, 0] * p[1] - d[:, 1] * p[0]) / turn
        hit = (s >= 0) & (s <= 1) & (t >= 0) & (t <= 1)
        if hit.any():
            best = i + s[hit].min()
            break
    return best


def number(value):
    text = f"{value:.3f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def blocks(positions):
    steps = np.diff(np.round(np.asarray(positions), 3), axis=0)
    return ["G1 " + " ".join(a + number(v) for a, v in zip("XYZBC", row)) for row in steps]


def main(workbook, folder):
    p = parameters(workbook)
    R, r, n, N = float(p["R"]), float(p["r"]), int(p["n"]), int(p["N"])
    L = p["R_B"] + p["H"]
    w, a_p = (p["e"] + p["d_t"]) / 2, p["a_p"]
    h = np.pi / 2 / n
    i = np.arange(n + 1, dtype=float)
    i[-1] -= p["eps_v"]
    v = np.pi + i * h
    k = np.sqrt(R * R - r * r)
    rho = R + r * np.cos(v)
    u = np.mod(np.arctan2(-(r + R * np.cos(v)), k * np.sin(v)), 2 * np.pi)
    P = np.column_stack([rho * np.cos(u), rho * np.sin(u), r * np.sin(v)])
    normal = -np.column_stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)])
    along_u = np.column_stack([-rho * np.sin(u), rho * np.cos(u), 0 * u])
    along_v = np.column_stack([-r * np.sin(v) * np.cos(u), -r * np.sin(v) * np.sin(u), r * np.cos(v)])
    t = (along_u * (k / rho)[:, None] + along_v) / R
    b = np.cross(t, normal)
    C, B = u - 2 * np.pi, 1.5 * np.pi - v
    machine = turn_b(turn_c(P, C) + [0, 0, L], B) - [0, 0, L]
    b2 = np.array([k / R, -r / R, 0])
    depth = np.array([0, 0, a_p])
    obverse, reverse = machine + w * b2 - depth, machine - w * b2 - depth
    beta = np.arctan2(reverse[0, 1] - obverse[0, 1], obverse[0, 0] - reverse[0, 0])
    reach, across = p["d_s"] + p["d_t"] / 2, w * np.cos(beta)
    safe = []
    for at, dx_a, dx_r in [(0, -(reach + across), -(reach - across)), (-1, reach - across, reach + across)]:
        for name, path, dx in [("obverse", obverse, dx_a), ("reverse", reverse, dx_r)]:
            safe.append((at, name, dx, dx / np.tan(beta), path[at] + [dx, dx / np.tan(beta), 0]))
    half = -np.pi / N
    own = (P + w * b - a_p * normal)[:, :2]
    other = (P - w * b - a_p * normal)[:, :2]
    other = other @ np.array([[np.cos(half), np.sin(half)], [-np.sin(half), np.cos(half)]])
    m = int(np.ceil(crossing(own, other)))
    f = np.where(np.arange(n + 1) < m, ((np.arange(n + 1) + 1) / (m + 1)) ** 5, 1.0)[:, None]
    out, back = machine - w * f * b2 - depth, machine + w * f * b2 - depth

    angles = np.column_stack([np.degrees(B), np.degrees(C)])
    pose = lambda points: np.column_stack([points, angles])
    corner = [np.concatenate([s[4], angles[s[0]]]) for s in safe]
    blade = [corner[0], *pose(obverse), corner[2], corner[3], *pose(reverse)[::-1], corner[1], corner[0]]
    splitter = [corner[1], *pose(out), corner[3], corner[2], *pose(back)[::-1], corner[1]]
    turn = f"G1 C{number(360 / N)}"
    start, end = "G91 M3 M11 M13", "G90 M30"
    body = {"blade": blocks(blade), "splitter": blocks(splitter)}
    cross = "G1 X0 Y{} Z0 B0 C0".format(number(corner[1][1] - corner[0][1]))
    home = "G1 X0 Y{} Z0 B0 C0".format(number(corner[0][1] - corner[1][1]))
    half_turn = f"G1 C{number(180 / N)}"
    whole = (body["blade"] + [turn]) * N + [cross, half_turn] + (body["splitter"] + [turn]) * (N - 1)
    whole += [*body["splitter"], half_turn, home]
    programs = {
        "blade": [start, *body["blade"], turn, end],
        "splitter": [start, *body["splitter"], turn, end],
        "impeller": [start, *whole, end],
        "blank": [
            f"G0 G71 G90 G95 G96 X{number(2 * R)} Z{number(p['Z_b'])} M4",
            f"T{p['T_b']} D{p['D_b']}",
            f"X{number(2 * R + p['c_f'])} Z0",
            f"G1 X{number(-p['c_o'])} F{number(p['F_b'])} S{number(p['S_b'])}",
            f"G0 X{number(2 * R + p['c_c'])} Z0",
            f"G85 X{number(2 * R)} Z{number(-r)} Q{number(2 * (R - r))} R0 C{number(p['C'])} I0 K{number(r)}",
            f"G0 X{number(p['X_e'])} Z{number(p['Z_e'])}",
            "M30",
        ],
    }
    programs = {key: [(f"N{10 * (j + 1)}", line) for j, line in enumerate(lines)] for key, lines in programs.items()}

    folder.mkdir(parents=True, exist_ok=True)
    stem = Path(workbook).stem
    for key, lines in programs.items():
        text = "".join(f"{label} {line}\r\n" for label, line in lines)
        (folder / f"{stem}-{key}.nc").write_bytes(text.encode())

    book = openpyxl.Workbook(write_only=True)
    data = book.create_sheet("DATOS")
    for symbol, value in p.items():
        data.append([symbol, value])
    tables = {
        "Anexo 1": (["v", "u"], np.column_stack([v, u])),
        "Anexo 2": (["x", "y", "z"], P),
        "Anexo 3": (["N_x", "N_y", "N_z", "t_x", "t_y", "t_z", "b_x", "b_y", "b_z"], np.hstack([normal, t, b])),
        "Anexo 4": (["C", "B"], np.column_stack([C, B])),
        "Anexo 5": (["x", "y", "z"], machine),
        "Anexo 6": (["x", "y", "z", "B", "C"], np.column_stack([obverse, B, C])),
        "Anexo 7": (["x", "y", "z", "B", "C"], np.column_stack([reverse, B, C])),
        "Intersección": (["x_own", "y_own", "x_neighbour", "y_neighbour"], np.hstack([own, other])),
        "Álabe intermedio": (["f", "x_1", "y_1", "z_1", "x_2", "y_2", "z_2", "B", "C"], np.column_stack([f, out, back, B, C])),
        "Vistas": (["x", "y", "ρ", "z"], np.column_stack([P[:, 0], P[:, 1], rho, P[:, 2]])),
    }
    for name, (symbols, values) in tables.items():
        sheet = book.create_sheet(name)
        sheet.append([name])
        sheet.append([])
        sheet.append(["i", *symbols])
        sheet.append([])
        for j, row in enumerate(values.tolist()):
            sheet.append([j, *row])
    sheet = book.create_sheet("Anexo 8")
    for at, name, dx, dy, point in safe:
        sheet.append(["entry" if at == 0 else "exit", name, dx, dy, *point.tolist()])
    sheet = book.create_sheet("INCR")
    columns = [programs[key] for key in ("blade", "splitter", "impeller", "blank")]
    for j in range(max(map(len, columns))):
        row = []
        for lines in columns:
            row += [*(lines[j] if j < len(lines) else (None, None)), None]
        sheet.append(row[:-1])
    book.save(folder / f"{stem}-results.xlsx")


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))

"""Checks tables that a run has written. Usage: table.py [NAME=FILE]... [CODE]

Runs CODE, or standard input, in which each NAME is the list of the file's rows: of a ledger or another CSV file, of the
pictures of a dump (with the `step`), of the thermo output in a log, or of bare numbers. A row's fields have their column's
name (`row.cor_n`, `row['f_wall[1]']`) or number (`row[0]`); an empty one is nan. A failed `assert` ends with status 1, and
says the line and the values of its names.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import re
import sys
from math import *  # for CODE

pi = math.pi


class Row(tuple):
    """The fields, by name or number."""

    def __new__(cls, fields, names, step=None):
        row = super().__new__(cls, fields)
        row.names, row.step = names, step
        return row

    def __getattr__(self, name):
        return self[self.names[name]]

    def __getitem__(self, key):
        return super().__getitem__(self.names[key] if isinstance(key, str) else key)


def number(text):
    try:
        return float(text) if text else nan
    except ValueError:
        return text


def read(path):
    rows, names, width, step, is_csv = [], {}, 0, None, None
    lines = open(path, errors="replace")
    for line in lines:
        if line.startswith("ITEM: TIMESTEP"):
            step = int(next(lines))
        elif line.startswith("ITEM:"):  # where it is not of atoms, its numbers are passed over
            names = {name: k for k, name in enumerate(line.split()[2:])} if line.startswith("ITEM: ATOMS") else None
            width = len(names or ())
        elif names is None or line.startswith("#") or not line.strip():
            continue
        else:
            is_first, is_csv = is_csv is None, "," in line and " " not in line.strip() if is_csv is None else is_csv
            fields = [number(field) for field in line.strip().split("," if is_csv else None)]
            if fields[0] == "Step" or (is_csv and is_first and isinstance(fields[0], str)):
                names, width = {name: k for k, name in enumerate(fields)}, len(fields)
            elif is_csv or not any(isinstance(field, str) for field in fields):
                if not width or len(fields) == width:
                    rows.append(Row(fields, names, step))
    return rows


def mean(values):
    values = list(values)
    return fsum(values) / len(values)


def sd(values):
    values = list(values)
    m = mean(values)
    return sqrt(fsum((v - m) ** 2 for v in values) / len(values))


def error(values):
    """The standard error of their mean."""
    values = list(values)
    return sd(values) / sqrt(len(values) - 1)


def near(a, b, tolerance=1e-9, least=0):
    """To a share of b, or of `least` where that is more."""
    return abs(a - b) <= tolerance * max(abs(b), least)


def at(rows, step):
    return [row for row in rows if row.step == step]


def check(code, tables):
    try:
        exec(compile(code, "code", "exec"), tables)
    except Exception as wrong:  # all of them fail the test
        line = wrong.__traceback__.tb_next
        while line.tb_next and line.tb_next.tb_frame.f_code.co_filename == "code":
            line = line.tb_next
        text = code.splitlines()[line.tb_lineno - 1].strip()
        print(f"{type(wrong).__name__} {wrong}: {text}")
        for name in dict.fromkeys(re.findall(r"\w+", text)):
            value = {**tables, **line.tb_frame.f_locals}.get(name)
            if isinstance(value, (int, float, str, Row)):
                print(f"  {name} = {value}")
        return 1
    return 0


if __name__ == "__main__":
    words, tables = sys.argv[1:], dict(globals())
    while words and re.match(r"\w+=(?!=)", words[0]):
        name, path = words.pop(0).split("=", 1)
        tables[name] = read(path)
    sys.exit(check(words[0] if words else sys.stdin.read(), tables))

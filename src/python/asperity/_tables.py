"""Ledgers and the command's tables as arrays.

SPDX-License-Identifier: GPL-3.0-or-later
"""

from __future__ import annotations

import os
import re
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import NDArray

_COUNTS = ("tag", "impact", "mesh", "triangle", "hits", "outcome")


def _type_of(name: str, value: str) -> str:
    try:
        float(value)
    except ValueError:
        return "U32"
    return "i8" if name in _COUNTS else "f8"


def read(path: str | os.PathLike[str]) -> NDArray[np.void]:
    """A ledger, or another table of numbers and single words that the command made,
    as an array with named columns. What is empty in a CSV is nan."""
    with open(path, encoding="utf-8") as file:
        title, line = [], file.readline()
        while line.startswith("#"):
            title, line = [*title, line.strip("# \n")], file.readline()
        rows = (re.sub("(?<=,)(?=,|$)|^(?=,)", "nan", row.strip()) for row in file if row[0] != "#")
        first, names = next(rows, None), line.strip().split(",")
        values = ["0"] * len(names) if first is None else first.split(",")
        types: list[Any] = [(name, _type_of(name, value)) for name, value in zip(names, values)]
        types[0] = (("; ".join(title) or str(path), names[0]), types[0][1])
        if first is None:
            return np.zeros(0, types)
        return np.loadtxt(chain([first], rows), dtype=types, delimiter=",", ndmin=1)


def heading(table: NDArray[np.void]) -> str:
    """The heading of a table that `read` returned: what made it, with the words of its wall."""
    return "".join(table.dtype.fields[table.dtype.names[0]][2:])

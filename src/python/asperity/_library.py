"""Where the shared library is: $ASPERITY_LIBRARY, or beside this file (where pip put it), or in
the prefix that this folder is installed in, or in build/ of the source tree.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import os
from pathlib import Path

NAME = "libasperity.so.1"


def find() -> str:
    """The path of the shared library; OSError where there is none."""
    here = Path(__file__).resolve().parent
    top = here.parents[2]
    places = [here / NAME, top / NAME, *sorted(top.glob(f"build/lib*/{NAME}"))]
    if "ASPERITY_LIBRARY" in os.environ:
        places = [Path(os.environ["ASPERITY_LIBRARY"])]
    for place in places:
        if place.is_file():
            return str(place)
    looked = ", ".join(str(place) for place in places)
    raise OSError(f"{NAME} is not there: build asperity (cmake/prepare), or set ASPERITY_LIBRARY "
                  f"to the file; looked at {looked}")

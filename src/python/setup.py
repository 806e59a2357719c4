"""Puts the built shared library beside the module, and leaves nothing behind in this folder.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import runpy
import shutil
import tempfile
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

LIBRARY = runpy.run_path(str(Path(__file__).parent / "asperity" / "_library.py"))


class WithLibrary(build_py):
    def run(self):
        super().run()
        shutil.copy(LIBRARY["find"](), Path(self.build_lib) / "asperity" / LIBRARY["NAME"])


class OfThisMachine(Distribution):
    """Not pure Python, though no extension is compiled."""

    def has_ext_modules(self):
        return True


class AnyPython(Distribution().get_command_class("bdist_wheel")):
    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


work = tempfile.mkdtemp()
setup(cmdclass={"build_py": WithLibrary, "bdist_wheel": AnyPython}, distclass=OfThisMachine,
      options={"build": {"build_base": work}, "egg_info": {"egg_base": work}})
shutil.rmtree(work)

"""Rough walls for particle simulation, on NumPy arrays: the library asperity by ctypes.

    wall = asperity.Wall("surface rq 5um lambda_c 40um materials quartz hastelloy-x")
    v1 = asperity.velocities(100, np.radians(np.linspace(5, 85, 1000)))
    hits = wall.impacts(v1, d_p=10e-6)
    cor = asperity.coefficients(v1, hits)
    np.nanmean(cor["cor_n"]), hits["outcome"].mean()

Walls are described by the words of a script and of the command (`asperity help wall`). Numbers are
in SI units, angles in radians, from the wall plane; words may have other units (5um, 30deg). Each
column of a result is explained in asperity.h, under the struct of its name. Threads may share a
wall, and run at the same time.

SPDX-License-Identifier: GPL-3.0-or-later
"""

from __future__ import annotations

import ctypes
import functools
import warnings
import weakref
from ctypes import POINTER, byref, c_bool, c_char, c_char_p, c_double, c_int, c_size_t, c_void_p
from typing import Any, Iterator, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _library
from ._tables import heading, read

__version__ = "1.0.0"
__all__ = ["BODY", "Error", "Wall", "coefficients", "heading", "read", "velocities"]


DENSITY = 2650.0  # kg/m3 of quartz, for walls without materials, as in the command


class Error(ValueError):
    """What the library refused, in its own words."""


class _Failure(ctypes.Structure):
    """asp_error"""

    _fields_ = [("code", c_int), ("text", c_char * 480), ("reserved", c_int * 4)]


def _struct(columns: str) -> np.dtype:
    """The type of a struct in C, as "name type, name type", its reserve without a name."""
    whole = np.dtype([tuple(column.split()) for column in columns.split(", ")], align=True)
    return whole[[name for name in whole.names if name != "reserved"]]


BODY = _struct("inverse_mass f8, inverse_inertia 6f8, lever 3f8, reserved 2f8")  # asp_body
_PARTICLE = _struct("d_p f8, density f8, pair uintp, omega 3f8, lay uintp, temperature f8, "
                    "u_tau f8, gas i4, body uintp, reserved 4f8")
_CHECK_INPUT = _struct("words uintp, wall uintp, d_least f8, largest uintp, material 2uintp, "
                       "reserved 4f8")
_KEY = _struct("seed u4, wall u4, tag u8, impact u4, reserved u4")
_IMPACT = _struct("v2 3f8, omega 3f8, delta_alpha f8, tilt_out f8, hits i4, capped ?, outcome i4, "
                  "eroded f8, reserved 4f8")
_COEFFICIENTS = _struct("v1 f8, alpha1 f8, v2 f8, alpha2 f8, cor_v f8, cor_alpha f8, cor_n f8, "
                        "cor_v_space f8, cor_alpha_space f8, cor_t f8, reserved 2f8")

_STRUCTS = {"body": BODY, "coefficients": _COEFFICIENTS, "impact": _IMPACT, "key": _KEY,
            "particle": _PARTICLE, "check_input": _CHECK_INPUT, "error": _Failure}

_P, _S, _N, _D, _E = c_void_p, c_char_p, c_size_t, c_double, POINTER(_Failure)
_SIGNATURES: dict[str, tuple[Any, ...]] = {  # result, arguments
    "version": (_S,), "struct_size": (_N, _S), "key_wall": (ctypes.c_uint32, _S),
    "description_parse": (_P, _S, _P, _E), "description_free": (None, _P),
    "description_text": (_N, _P, _P, _N), "description_get": (_D, _P, _S),
    "description_word": (_S, _P, _S), "wall_seed": (ctypes.c_uint32, _P),
    "description_material": (_P, _P, c_int), "material_get": (_D, _P, _S),
    "warning": (c_bool, _P, c_int, _P, _N), "description_needs_sizes": (c_bool, _P),
    "description_set_heights": (c_int, _P, _P, _E), "heights_free": (None, _P),
    "heights_create": (_P, _P, _N, _N, _D, _D, c_bool, _E),
    "wall_create": (_P, _P, _D, _D, _E), "wall_free": (None, _P), "wall_pair": (_P, _P),
    "wall_surface": (_P, _P), "surface_check": (c_int, _P, _D, _E),
    "surface_r_q": (_D, _P), "surface_lambda_c": (_D, _P), "surface_lambda_along": (_D, _P),
    "surface_phi_r": (_D, _P), "surface_slope_rms": (_D, _P), "wall_slope": (_D, _P, _D),
    "wall_impacts": (c_int, _P, _N, _P, _P, _P, _P, _P, _E),
    "wall_weights": (c_int, _P, _N, _P, _P, _P, _P, _N, _P, _P, _P, _E),
    "impacts_coefficients": (None, _N, _P, _P, _P, _P)}


def _load() -> ctypes.CDLL:
    library = ctypes.CDLL(_library.find())
    library.asp_version.restype = _S
    if library.asp_version().decode() != __version__:
        raise ImportError(f"{library._name} is asperity {library.asp_version().decode()}, and the "
                          f"module {__version__}: build or install both anew")
    for name, (result, *arguments) in _SIGNATURES.items():
        function = getattr(library, "asp_" + name)
        function.restype, function.argtypes = result, arguments
    for name, layout in _STRUCTS.items():
        size = layout.itemsize if isinstance(layout, np.dtype) else ctypes.sizeof(layout)
        if library.asp_struct_size(name.encode()) != size:
            raise ImportError(f"{library._name} has another asp_{name} than the module: build or "
                              "install both anew")
    return library


_asp = _load()


def _call(name: str, *arguments: Any) -> Any:
    """Calls a function that takes an asp_error; its object, or an Error."""
    failure = _Failure()
    function = getattr(_asp, "asp_" + name)
    result = function(*arguments, byref(failure))
    if result if function.restype is c_int else not result:
        raise Error(failure.text.decode())
    return result


def _vectors(name: str, values: ArrayLike, n: int | None = None) -> NDArray[np.float64]:
    """Vectors as the library reads them: (n, 3), one after the other."""
    vectors = np.atleast_2d(np.asarray(values, dtype=np.float64))
    n = len(vectors) if n is None else n
    if vectors.shape not in ((1, 3), (n, 3)):
        raise Error(f"{name} has the shape {np.shape(values)}; it must be (3,) or ({n}, 3)")
    return np.ascontiguousarray(np.broadcast_to(vectors, (n, 3)))


def _each(name: str, values: ArrayLike, n: int) -> NDArray[Any]:
    """One value for all, or one for each of n."""
    if np.shape(values) not in ((), (1,), (n,)):
        raise Error(f"{name} has the shape {np.shape(values)}; it must be one value or ({n},)")
    return np.broadcast_to(values, n)


def _must(good: NDArray[np.bool_], name: str, values: NDArray[Any], what: str) -> None:
    """Refuses the first value that is not good."""
    bad = np.flatnonzero(~good)
    if bad.size:
        raise Error(f"{name} of impact {bad[0]} is {values[bad[0]]:g}; it must be {what}")


def _whole(name: str, values: ArrayLike, most: int) -> NDArray[np.uint64]:
    given = np.atleast_1d(values)
    _must((given >= 0) & (given <= most) & (given == np.floor(given)), name, given,
          f"a whole number from 0 to {most}")
    return given.astype(np.uint64)


class Wall:
    """A wall that is ready for impacts. A copy or a pickle is made anew from its arguments.

    Parameters
    ----------
    words : str
        The description, as in a script: "surface rq 5um lambda_c 40um rebound walton 0.9 0.3 0".
    d_p : array_like
        Diameters that it will meet (m), of which the least and the greatest count. Measured walls
        need them.
    heights : array_like, optional
        In place of the file of `surface profile NAME` heights along a line, of `surface map NAME`
        heights in rows (m).
    step : array_like
        Spacing of the heights (m); of a map also (step_x, step_y).
    periodic : bool
        The heights begin anew behind their end.
    name : str
        Walls of different names draw different numbers with the same seed.

    Examples
    --------
    >>> wall = Wall("surface rq 5um lambda_c 40um rebound walton 0.9 0.3 0")
    >>> wall
    Wall('surface rq 5e-06 lambda_c 4e-05 spread visible isotropic collisions multiple rebound \
walton 0.9 0.3 0 deposit freeze seed 1')
    >>> hits = wall.impacts(velocities(100, np.radians([10, 45])), d_p=10e-6)
    >>> hits["outcome"]
    array([0, 0], dtype=int32)
    """

    def __init__(self, words: str, d_p: ArrayLike = 0, *, heights: ArrayLike | None = None,
                 step: ArrayLike = 0, periodic: bool = False, name: str = "python") -> None:
        self._words = self._own("description", _call("description_parse", words.encode(), None))
        heights = None if heights is None else np.array(heights)
        if heights is not None:
            self._set_heights(heights, np.atleast_1d(step).astype(float), periodic)
        self._least, self._most = float(np.min(d_p)), float(np.max(d_p))
        if not 0 <= self._least <= self._most < np.inf:
            raise Error(f"d_p is {d_p}; it must be >= 0 m")
        self._wall = self._own("wall", _call("wall_create", self._words, self._least, self._most))
        self._key = _asp.asp_key_wall(name.encode())
        self._surface = _asp.asp_wall_surface(self._wall)
        material = _asp.asp_description_material(self._words, 0)
        self._density = _asp.asp_material_get(material, b"density") if material else DENSITY
        self._made_by = functools.partial(
            type(self), heights=heights, step=step, periodic=periodic, name=name
        ), (words, (self._least, self._most))
        self._said: set[str] = set()
        self._warn(self._least, self._most)

    def __reduce__(self) -> tuple[Any, ...]:
        return self._made_by

    def _own(self, kind: str, handle: int) -> int:
        """Frees an object of the library with the wall."""
        weakref.finalize(self, getattr(_asp, f"asp_{kind}_free"), handle)
        return handle

    def _set_heights(self, heights: NDArray[Any], step: NDArray[Any], periodic: bool) -> None:
        z = np.atleast_2d(np.ascontiguousarray(heights, dtype=np.float64))
        made = _call("heights_create", z.ctypes.data, z.shape[1], z.shape[0], step[0], step[-1],
                     periodic)
        _call("description_set_heights", self._words, self._own("heights", made))

    def _warn(self, least: float, most: float) -> None:
        """Refuses diameters beyond the wall's range; warns of each doubt about them once."""
        if self._surface and most > 0:
            _call("surface_check", self._surface, most)
        self._asked = least, most
        for doubt in self._doubts(least, most):
            if doubt not in self._said:
                self._said.add(doubt)
                warnings.warn(doubt, stacklevel=3)

    def _doubts(self, least: float, most: float) -> Iterator[str]:
        """What looks like a mistake in the wall's words, its file, and its constants."""
        largest, check_input = np.zeros((), _PARTICLE), np.zeros((), _CHECK_INPUT)
        largest["d_p"], largest["density"] = most, self._density
        largest["pair"] = _asp.asp_wall_pair(self._wall) or 0
        check_input["words"], check_input["wall"] = self._words, self._wall
        check_input["d_least"], check_input["largest"] = least, largest.ctypes.data
        check_input["material"] = [_asp.asp_description_material(self._words, i) or 0
                                for i in range(2)]
        text, index = ctypes.create_string_buffer(500), 0
        while _asp.asp_warning(check_input.ctypes.data, index, text, len(text)):
            index += 1
            if text.value:
                yield text.value.decode()

    def __repr__(self) -> str:
        return f"Wall({self.text!r})"

    @property
    def text(self) -> str:
        """The canonical words: another wall of them is the same wall."""
        text = ctypes.create_string_buffer(_asp.asp_description_text(self._words, None, 0) + 1)
        _asp.asp_description_text(self._words, text, len(text))
        return text.value.decode()

    def get(self, name: str) -> float | str:
        """A number or a word of the description, as get("friction"), get("spread")."""
        number = _asp.asp_description_get(self._words, name.encode())
        word = _asp.asp_description_word(self._words, name.encode())
        if word is None and np.isnan(number):
            raise Error(f"the wall has no '{name}': {self.text}")
        return number if word is None else word.decode()

    def surface(self) -> dict[str, float]:
        """r_q, lambda_c, lambda_along, phi_r and slope_rms; empty if the wall is smooth. A wall by
        sigma has no r_q, and a lambda_c only if that is given: nan."""
        names = ("r_q", "lambda_c", "lambda_along", "phi_r", "slope_rms") if self._surface else ()
        return {name: getattr(_asp, "asp_surface_" + name)(self._surface) for name in names}

    def slope(self, d_p: ArrayLike) -> NDArray[np.float64]:
        """The rms slope of the tilt for particles of these diameters; 0 if the wall is smooth."""
        return np.vectorize(lambda d: _asp.asp_wall_slope(self._wall, d), otypes=[float])(d_p)

    def impacts(self, v1: ArrayLike, d_p: ArrayLike, normals: ArrayLike = (0, 0, 1), *,
                density: ArrayLike | None = None, omega: ArrayLike = (0, 0, 0),
                lay: ArrayLike | None = None, temperature: ArrayLike = 0,
                body: NDArray[np.void] | None = None, tag: ArrayLike | None = None,
                impact: ArrayLike = 1, seed: int | None = None,
                others: Sequence[Wall] = ()) -> Any:
        """One impact for each velocity.

        Parameters
        ----------
        v1 : array_like, (n, 3)
            Velocities before the impact, relative to the wall (m/s). All else is one value, or one
            for each impact, as in asp_particle and asp_key.
        d_p : array_like
            Diameters (m).
        normals : array_like
            Outward unit normals of the mean wall.
        density : array_like, optional
            That of the first material if not given (kg/m3).
        omega : array_like
            Angular velocities (rad/s).
        lay : array_like, optional
            Direction of the lay; that of the words if not given, an angle from x toward y.
        temperature : array_like
            Of the particle (K); 0: that of the words.
        body : array of BODY, optional
            Bodies in place of spheres.
        tag, impact : array_like
            Number of the particle (1 to n) and of its impact, from 1.
        seed : int, optional
            That of the words if not given. The same tag, impact and seed draw the same numbers.
        others : sequence of Wall
            Walls of other roughness, all else alike. All must be rough, with a spread model that has
            a density, such as visible.

        Returns
        -------
        array of asp_impact, by columns
            v2, omega, delta_alpha, tilt_out, hits, capped, outcome (0 rebound, 1 deposit), eroded.
        (n, len(others)) array, only with `others`
            Likelihood ratios of each impact's draws on the other walls: weighted means over impacts
            are those on the other wall. The weight of a path is the product over its impacts.
        """
        v1 = _vectors("v1", v1)
        n = len(v1)
        normals, spin = _vectors("normals", normals, n), _vectors("omega", omega, n)
        lay = None if lay is None else _vectors("lay", lay, n)
        if lay is not None:
            _must(np.isfinite(lay).all(axis=1), "lay", lay.sum(axis=1), "finite")
        particles, keys, made = np.zeros(n, _PARTICLE), np.zeros(n, _KEY), np.zeros(n, _IMPACT)
        particles["d_p"], particles["omega"] = _each("d_p", d_p, n), spin
        particles["density"] = _each("density", self._density if density is None else density, n)
        particles["temperature"] = _each("temperature", temperature, n)
        if lay is not None:
            particles["lay"] = lay.ctypes.data + np.arange(n) * lay.strides[0]
        lever = np.zeros(3)
        if body is not None:
            bodies = np.zeros(n, BODY)
            bodies[...] = _each("body", np.asarray(body, BODY), n)
            particles["body"] = bodies.ctypes.data + np.arange(n) * BODY.itemsize
            lever, mass = bodies["lever"], bodies["inverse_mass"]
            _must((mass > 0) & (mass < np.inf), "inverse_mass of the body", mass, "> 0 per kg")
        keys["seed"] = (_asp.asp_wall_seed(self._wall) if seed is None
                        else _whole("seed", seed, (1 << 32) - 1))
        keys["wall"] = self._key
        tag = np.arange(1, n + 1) if tag is None else _whole("tag", tag, (1 << 64) - 1)
        keys["tag"] = _each("tag", tag, n)
        keys["impact"] = _each("impact", _whole("impact", impact, (1 << 32) - 1), n)
        self._check(v1 + np.cross(spin, lever), normals, particles)
        sizes = np.append(particles["d_p"], [d for d in self._asked if d > 0])
        if n > 0 and (sizes.min(), sizes.max()) != self._asked:
            self._warn(sizes.min(), sizes.max())
        arrays = [a.ctypes.data for a in (particles, v1, normals, keys)]
        if not others:
            _call("wall_impacts", self._wall, n, *arrays, made.ctypes.data)
            return made
        walls, weights = np.array([w._wall for w in others], np.uintp), np.zeros((n, len(others)))
        _call("wall_weights", self._wall, n, *arrays, len(others), walls.ctypes.data,
              made.ctypes.data, weights.ctypes.data)
        return made, weights

    def _check(self, v1: NDArray[Any], normals: NDArray[Any], particles: NDArray[Any]) -> None:
        d_p, density = particles["d_p"], particles["density"]
        length = np.linalg.norm(normals, axis=1)
        if _asp.asp_description_needs_sizes(self._words):
            _must((d_p >= self._least) & (d_p <= self._most), "d_p", d_p,
                  f"{self._least:g} to {self._most:g} m, for which the wall was made")
        _must((d_p > 0) & (d_p < np.inf), "d_p", d_p, "> 0 m")
        _must((density > 0) & (density < np.inf), "density", density, "> 0 kg/m3")
        heat = particles["temperature"]
        _must((heat >= 0) & (heat < np.inf), "temperature", heat, ">= 0")
        _must(np.abs(length - 1) < 1e-6, "the length of the normal", length, "1")
        toward = np.einsum("ij,ij->i", v1, normals)
        _must(np.isfinite(v1).all(axis=1) & (toward < 0), "v1 . n", toward, "< 0, toward the wall")


def velocities(speed: ArrayLike, alpha1: ArrayLike) -> NDArray[np.float64]:
    """Velocities along x onto the wall z = 0.

    Parameters
    ----------
    speed : array_like
        In m/s.
    alpha1 : array_like
        Impact angles from the wall plane (rad), above 0 and up to pi/2.

    Returns
    -------
    (n, 3) array of velocities (m/s)

    Examples
    --------
    >>> velocities(2, np.radians([30])).round(3)
    array([[ 1.732,  0.   , -1.   ]])
    """
    v, alpha = np.broadcast_arrays(np.atleast_1d(speed).astype(float), alpha1)
    _must((v > 0) & (v < np.inf), "speed", v, "> 0 m/s")
    _must((alpha > 0) & (alpha <= np.pi / 2 * (1 + 1e-9)), "alpha1", alpha, "> 0 and <= pi/2 rad")
    return np.stack([v * np.cos(alpha), 0 * v, -v * np.sin(alpha)], axis=-1)


def coefficients(v1: ArrayLike, impacts: NDArray[np.void],
                 normals: ArrayLike = (0, 0, 1)) -> NDArray[np.void]:
    """The coefficients of restitution of impacts about the mean wall.

    Parameters
    ----------
    v1, normals : array_like
        Those of the impacts.
    impacts : array of asp_impact
        The result of Wall.impacts.

    Returns
    -------
    array of asp_coefficients, by columns
        v1, alpha1, v2, alpha2, cor_v, cor_alpha, cor_n, cor_v_space, cor_alpha_space, cor_t.
        Coefficients are nan for deposits, cor_t also at normal impact, cor_n and
        cor_alpha also where v1 has no normal part.

    Examples
    --------
    >>> v1 = velocities(10, np.radians([45]))
    >>> hits = Wall("rebound walton 0.9 0 0 deposit off").impacts(v1, d_p=1e-3)
    >>> coefficients(v1, hits)["cor_n"].round(3)
    array([0.9])
    """
    made, n = np.zeros(len(impacts), _COEFFICIENTS), len(impacts)
    before, up = _vectors("v1", v1, n), _vectors("normals", normals, n)
    after = np.ascontiguousarray(impacts, dtype=_IMPACT)
    _asp.asp_impacts_coefficients(n, before.ctypes.data, up.ctypes.data, after.ctypes.data,
                                  made.ctypes.data)
    return made

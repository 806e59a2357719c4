"""Files as instruments and programs write them: each is written from the same heights, read by `asperity surface`, and
compared with NumPy's numbers of what was written (points, steps, R_q or S_q about the least-squares line or plane), or
refused with the words that help. Usage: forms.py ASPERITY.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import struct
import subprocess
import sys
import tempfile
import zipfile

import numpy as np

asperity, failed, ran = sys.argv[1], [], 0
folder = tempfile.TemporaryDirectory()
os.chdir(folder.name)
random = np.random.default_rng(5)
n, m, rows_of_line = 64, 40, 500
waves = list(zip(random.uniform(-0.5, 0.5, (40, 2)), random.uniform(0, 6.28, 40)))
x = np.arange(rows_of_line)
line = np.round(sum(np.cos(3 * a[0] * x * 0.3 + p) for a, p in waves) * 0.2 + 0.004 * x, 3)  # um, 0.5 um apart
yy, xx = np.mgrid[:m, :n]
plane = np.round(sum(np.cos(a[0] * xx + a[1] * yy + p) for a, p in waves) * 0.2 + 0.01 * xx, 3)  # um, 1.5 and 2 um apart


def rms(z):
    """About the least-squares line or plane; nan is left out."""
    j, i = np.indices(z.shape) if z.ndim == 2 else (np.zeros(z.size), np.arange(z.size))
    terms = np.stack([np.ones(z.size), i.ravel(), j.ravel()], 1)[:, : 1 + z.ndim]
    good = np.isfinite(z.ravel())
    fit = np.linalg.lstsq(terms[good], z.ravel()[good], rcond=None)[0]
    return np.sqrt(np.mean((z.ravel()[good] - terms[good] @ fit) ** 2))


def run(name, kind, content, arguments):
    with open(name, "wb") as file:
        file.write(content if isinstance(content, bytes) else content.encode())
    done = subprocess.run([asperity, "surface", "surface", kind, name, "--dp", "25um", *arguments], capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr


def check(name, kind, content, arguments=(), z=None, step=None, warns="", near=1e-5):
    """The form is read as the heights z (um), `step` um apart, with that warning alone."""
    global ran
    ran += 1
    z = (line if kind == "profile" else plane) if z is None else z
    step = step or ((0.5,) if kind == "profile" else (1.5, 2.0))
    code, out, err = run(name, kind, content, arguments)
    doubt = [text for text in err.splitlines() if "covers" not in text and "correlation lengths long" not in text]
    if kind == "profile":
        got = re.search(r"spacing (\S+) um, (\d+) points; R_q (\S+) um", out)
        same = got and int(got[2]) == z.size and np.isclose(float(got[1]), step[0]) and abs(float(got[3]) / rms(z) - 1) < near
    else:
        size, got = re.search(r"# (\d+) x (\d+) points, (\S+) x (\S+) um", out), re.search(r"S_q (\S+) um", out)
        same = got and (int(size[2]), int(size[1])) == z.shape and np.allclose([float(size[3]), float(size[4])], step) \
            and abs(float(got[1]) / rms(z) - 1) < near
    if code or not same or (warns not in err if warns else doubt):
        failed.append(f"{name}: exit {code}, {got and got[0]}, expected {z.shape} {step} {rms(z):.6g} '{warns}': {err[:300]}")


def refused(name, kind, content, words, arguments=()):
    global ran
    ran += 1
    code, _, err = run(name, kind, content, arguments)
    if code != 2 or words not in err:
        failed.append(f"{name}: exit {code}, '{words}' is not in {err[:300]}")


def comma(text):
    return text.replace(".", ",")


def table(head, form, z=line, step=0.5, end=""):
    return head + "".join(form.format(i=i, x=i * step, z=v) for i, v in enumerate(z)) + end


def matrix(head, between="\t", form="%.3f", z=plane):
    return head + "\n".join(between.join(form % v for v in row) for row in z) + "\n"


# ---- profiles ----
plain, heights = "{x:.1f},{z:.3f}\n", "{z:.3f}\n"
check("names", "profile", table("x_um,z_um\n", plain))
check("microns", "profile", table("X_(microns),y1_(microns)\n", plain))
check("spanish", "profile", table("x (um),altura (µm)\n", plain))
check("x_and_y", "profile", table("x in µm,y in µm\n", plain))
check("french", "profile", comma(table("distance (µm);hauteur (µm)\n", "{x:.1f};{z:.3f}\n")))
check("units_below", "profile", comma(table("N\tX\tZ\n\tmm\tµm\n", "{i}\t{x:.1f}\t{z:.3f}\n")), z=line, step=(500,), arguments=["--dp", "25mm"])
check("blanks", "profile", table("# x [um] z [um]\n", "  {x:.1f}   {z:.3f}\n"))
check("decimal_commas_and_blanks", "profile", comma(table("", "{x:.1f} {z:.3f}\n")), ["--unit", "um"])
check("two_units", "profile", table("", "{x:.1f} {z:.3f}\n"), ["--unit", "um,63nm"], z=line * 0.063)
check("latin_1", "profile", table("x (µm)\tz (µm)\n", "{x:.1f}\t{z:.3f}\n").encode("latin-1"))
check("utf_16", "profile", ("\ufeff" + table("x (µm)\tz (µm)\r\n", "{x:.1f}\t{z:.3f}\r\n")).encode("utf-16-le"))
check("old_mac", "profile", table("x_um z_um\r", "{x:.1f} {z:.3f}\r"))
check("sep_line", "profile", comma(table("sep=;\nx_um;z_um\n", "{x:.1f};{z:.3f}\n")))
check("first_row_by_tabs", "profile", "\t\t\t" + table("", "     {x:.1f}   {z:.3f}\n").lstrip(), ["--unit", "um"])
thousands = "".join(f'"{4 * i:,.3f}",{v:.3f}\n' for i, v in enumerate(line))
check("thousands", "profile", "X (um),Z (um)\n" + thousands, step=(4,))
german = "Surftest;Ver. 3.005\nDatum;27.11.2026\nProfil;P\nMessstrecke;4,0 mm\nRq;3,01 µm\nDatenanzahl;%d\nTeilung;0,5 µm\n"
check("mitutoyo_two", "profile", german % 500 + comma(table("X [mm];Z [µm]\n", "{x:.4f};{z:.3f}\n", step=0.0005)))
check("mitutoyo_one", "profile", german % 500 + comma(table("Daten [µm]\n", heights)))
check("count_is_wrong", "profile", german % 501 + comma(table("Daten [µm]\n", heights)), warns="the header states 501 rows, there are 500")
check("talysurf", "profile", comma(table("Talysurf Intra 50\nLength:\t4.0 mm\nSpacing:\t0.5 µm\n\tX\tZ\n\tµm\tµm\n", "{i}\t{x:.1f}\t{z:.3f}\n")))
tags = "<?xml version=\"1.0\"?>\n<DATA>\n<UNITS>um</UNITS>\n<NUMPOINTS>500</NUMPOINTS>\n<SPACING>0.5</SPACING>\n<DATA_POINT_VALUES>"
check("softgauge", "profile", table(tags, heights, end="</DATA_POINT_VALUES>\n</DATA>\n"))
second = "</DATA_POINT_VALUES>\n<WAVINESS>0.1\n0.2\n0.4\n0.1\n</WAVINESS>\n"
check("softgauge_two", "profile", table(tags, heights, end=second), warns="4 lines with numbers from line 507 on are left out")
check("step_alone", "profile", table("", heights), ["--unit", "um", "--step", "0.5um"])
check("count_above", "profile", table("500\n", heights), ["--unit", "um", "--step", "0.5um"])
check("words_above", "profile", table("Length\n4.0\nPoints\n500\nHeights\n", heights), ["--unit", "um", "--step", "0.5um"])
check("results_behind", "profile", table("x_um,z_um\n", plain, end="Ra,1.2\nRq,1.5\nend\n"), warns="2 lines with numbers from line 502 on are left out")
holes = line.copy()
holes[[77, 78, 301]] = np.nan
valid = "".join(f"{i / 2:.1f},{v:.3f},{int(np.isfinite(h))}\n" for i, (v, h) in enumerate(zip(line, holes)))
check("valid_column", "profile", "x_um,z_um,valid\n" + valid, ["--gaps", "fill"], near=0.01)
refused("valid_column_gaps", "profile", "x_um,z_um,valid\n" + valid, "79: the first of 3 bad or missing points")
traces = table("x_um,z_um\n", plain, z=-line[:400]) + table("\n", plain) + table("Trace 3\n", plain, z=line[:300])
for number, trace in (1, -line[:400]), (2, line), (3, line[:300]):
    check("traces", "profile", traces, ["--row", str(number)], z=trace, warns=f"of its 3 traces number {number} is read")
refused("no_trace", "profile", traces, "row 4 is asked for; the text has 3 traces", ["--row", "4"])
check("units_in_cells", "profile", table("x;z\n", "{x:.1f} um;{z:.3f} µm\n"))
check("units_in_cells_alone", "profile", table("", "{x:.1f} um;{z:.3f} µm\n"))
refused("other_units_in_cells", "profile", table("x;z\n", "{x:.1f} um;{z:.3f} um\n", end="250 um;1 nm\n"), "'250 um;1 nm' is not a number")
check("depths", "profile", table("x_um,depth_um\n", plain))
flags = "".join(f"{v:.3f},{int(i % 9 > 0)}\n" for i, v in enumerate(line))
refused("flags", "profile", flags, "column 2 has only 0 and 1", ["--unit", "um"])
refused("no_unit", "profile", table("", plain), "no unit of length is stated of column 1")
refused("no_step", "profile", table("z_um\n", heights), "heights alone of a profile need the step")
refused("torn", "profile", table("x_um,z_um\n", plain, end="12,3.4.5\n"), "502: '12,3.4.5' is not a number")
refused("matrix_as_profile", "profile", matrix("# Width: 96 µm\n# Height: 80 µm\n# Value units: um\n"), "is a map (surface map)")

# ---- maps ----
check("gwyddion", "map", matrix("# Channel: Z\n# Width: 96 µm\n# Height: 80 µm\n# Value units: um\n"))
check("gwyddion_si", "map", matrix("# Width: 96 µm\n# Height: 80 µm\n# Value units: m\n", form="%.9e", z=plane * 1e-6))
check("gwyddion_german", "map", comma(matrix("# Breite: 96 µm\n# Höhe: 80 µm\n# Werteinheiten: µm\n")))
check("gwyddion_french", "map", comma(matrix("# Largeur: 96 µm\n# Hauteur: 80 µm\n# Unités: µm\n")))
spip = "# File Format = ASCII\r\n# x-pixels = 64\r\n# y-pixels = 40\r\n# x-length = 96000\r\n# y-length = 80000\r\n# z-unit = um\r\n# Start of Data:\r\n"
check("spip", "map", matrix(spip))
check("spip_short", "map", matrix(spip.replace("= 40", "= 41")), warns="the header states 41 rows, there are 40")
check("nanoscope_text", "map", matrix("\\Exported image units: um\n", " "), ["--step", "1.5um,2um"])
phase = "h=40 w=64\npixel size=1.5e-006 m\ndata unit=rad\nheight conversion factor (-> m)=6.3e-008\n"
check("phase", "map", matrix(phase, " "), z=plane * 0.063, step=(1.5, 1.5))
check("esri", "map", matrix("ncols 64\nnrows 40\nxllcorner 0\nyllcorner 0\ncellsize 1.5\n", " "), ["--unit", "um"], step=(1.5, 1.5))
check("commas", "map", matrix("", ", "), ["--unit", "um", "--step", "1.5um,2um"])
axes = "0," + ",".join("%.1f" % (1.5 * i) for i in range(n)) + "\n"
check("axes", "map", axes + "".join("%.1f," % (2 * j) + ",".join("%.3f" % v for v in row) + "\n" for j, row in enumerate(plane)), ["--unit", "um"])
column_out, row_out = "the first column, of even steps, is left out", "the first row, of even steps, is left out"
numbered = lambda first, by=1: "".join("%g," % (first + by * j) + ",".join("%.3f" % v for v in row) + "\n" for j, row in enumerate(plane))
olympus = "OLS5000,\nX resolution[um],1.5\nY resolution[um],2.0\nDataLine," + ",".join("POS = %d" % (i + 1) for i in range(n)) + "\n"
check("olympus", "map", olympus + numbered(1), ["--unit", "um"], warns=column_out)
check("index_column", "map", numbered(0), ["--unit", "um", "--step", "1.5um,2um"], warns=column_out)
check("axis_column", "map", numbered(0, 2), ["--unit", "um", "--step", "1.5um"], step=(1.5, 1.5), warns=column_out)
check("index_row", "map", ",".join(str(i + 1) for i in range(n)) + "\n" + matrix("", ","), ["--unit", "um", "--step", "1.5um,2um"], warns=row_out)
wyko = "Wyko ASCII Data File Format 0\t%d\t1\nX Size\t64\nY Size\t40\nBlock Name\tType\tLength\tValue\nWavelength\t7\t4\t632.8\nAspect\t7\t4\t1\n" \
    "Pixel_size\t7\t4\t0.0015\nMult\t6\t2\t1\nRAW_DATA\t3\t48000\n"
check("wyko_waves", "map", matrix(wyko % 0), z=plane * 0.6328, step=(1.5, 1.5))
check("wyko_nm", "map", matrix(wyko % 1), z=plane * 1e-3, step=(1.5, 1.5), near=1e-4)
for unit in ("Unit", "単位", "单位"):
    keyence = '"VK-X1000","Height"\n"XY Calibration","1500","nm/pixel"\n"%s","um"\n\n"Height"\n' % unit
    check("keyence", "map", matrix(keyence, ","), step=(1.5, 1.5))
check("surfer", "map", matrix("DSAA\n64 40\n0 94.5\n0 78\n-3 3\n", " "), ["--unit", "um"])
colors = "".join("%.1f %.1f %.3f %d %d %d\n" % (1.5 * i, 2.0 * j, plane[j, i], (i * 3) % 256, j, 128) for j in range(m) for i in range(n))
check("colors", "map", colors, ["--unit", "um"])
points = [(1.5 * i, 2.0 * j, plane[j, i]) for j in range(m) for i in range(n)]
check("points", "map", "x_um,y_um,z_um\n" + "".join("%.1f,%.1f,%.3f\n" % p for p in points))
check("points_nameless", "map", "".join("%.1f\t%.1f\t%.3f\n" % p for p in points), ["--unit", "um"])


def sur(z, bits, kind, missing):
    """Digital Surf: steps in um, heights in nm."""
    counts = np.round(z * 1000).astype(int)
    least, most = counts.min(), counts.max()
    if missing:
        counts[3, 5] = least - 2
    word = lambda text: text.encode("latin-1").ljust(16)
    head = b"DIGITAL SURF" + struct.pack("<4h", 0, 1, 1, kind) + b" " * 60 + struct.pack("<5h", 0, 1, 0, missing, 1) + bytes(8)
    head += struct.pack("<h5i", bits, least, most, z.shape[1], z.shape[0], z.size) + struct.pack("<3f", 1.5, 2, 1)
    head += word("X") + word("Y") + word("Z") + word("µm") * 2 + word("nm") + word("µm") * 3
    head = (head.ljust(334, b"\0") + struct.pack("<2H", 5, 3)).ljust(512, b"\0")
    return head + b"noteXprv" + counts.astype("<i%d" % (bits // 8)).tobytes()


def x3p(z, kind="D", increment=None, inside=False, valid=None, edit=lambda xml: xml, mac=False, at=None):
    """Of heights in m, or in increments of so many m; at: positions in m."""
    data = {"D": "<f8", "F": "<f4", "L": "<i4", "I": "<i2"}[kind]
    values = z if increment is None else np.round(z / increment)
    link = "".join("<Datum>%s%r</Datum>" % ("" if at is None else "%r;0;" % at[i], float(v)) for i, v in enumerate(values.flat))
    link = "<DataList>" + link + "</DataList>" if inside else "<DataLink><PointDataLink>bindata/data.bin</PointDataLink>" + (
        "" if valid is None else "<ValidPointsLink>bindata/valid.bin</ValidPointsLink>") + "</DataLink>"
    axis = "<C%s><AxisType>%s</AxisType><DataType>%s</DataType><Increment>%r</Increment><Offset>0</Offset></C%s>"
    xml = "<?xml version='1.0'?>\n<p:ISO5436_2 xmlns:p='http://www.opengps.eu/2008/ISO5436_2'><Record1><Axes>"
    xml += axis % ("X", "I", "D", 1.5e-6, "X") + axis % ("Y", "I", "D", 2e-6, "Y") + axis % ("Z", "A" if increment is None else "I", kind, increment or 1.0, "Z")
    xml += "</Axes></Record1><Record3><MatrixDimension><SizeX>%d</SizeX><SizeY>%d</SizeY><SizeZ>1</SizeZ></MatrixDimension>" % z.shape[::-1]
    with zipfile.ZipFile("made", "w", zipfile.ZIP_DEFLATED) as file:
        if mac:
            file.writestr("__MACOSX/._main.xml", b"\0\5\x16\7")
            file.writestr("__MACOSX/bindata/._data.bin", b"\0\5\x16\7")
        file.writestr("main.xml", edit(xml) + link + "</Record3></p:ISO5436_2>")
        file.writestr("bindata/data.bin", values.astype(data).tobytes())
        if valid is not None:
            file.writestr("bindata/valid.bin", np.packbits(valid.ravel(), bitorder="little").tobytes())
    with open("made", "rb") as file:
        return file.read()


check("sur_32", "map", sur(plane, 32, 2, 0))
check("sur_16", "map", sur(plane, 16, 2, 0))
refused("sur_missing", "map", sur(plane, 32, 2, 1), "1 of 2560 points are bad or missing")
check("sur_missing_filled", "map", sur(plane, 32, 2, 1), ["--gaps", "fill"], near=1e-3)
check("sur_profile", "profile", sur(line[None], 32, 1, 0), step=(1.5,))
check("sur_row", "profile", sur(plane, 32, 2, 0), ["--row", "3"], z=plane[2], step=(1.5,))
several = bytearray(sur(plane, 32, 2, 0))
several[14] = 3
check("sur_objects", "map", bytes(several), warns="of its 3 objects the first is read")
refused("sur_series", "map", sur(plane, 32, 5, 0), "neither a profile nor a surface")
_, _, first = run("x3p", "map", x3p(plane * 1e-6), [])
if "this build reads no X3P" not in first:
    check("x3p_double", "map", x3p(plane * 1e-6))
    check("x3p_float", "map", x3p(plane * 1e-6, "F"))
    check("x3p_whole", "map", x3p(plane * 1e-6, "L", 1e-9))
    check("x3p_short", "map", x3p(plane * 1e-6, "I", 1e-9))
    check("x3p_inside", "map", x3p(plane * 1e-6, inside=True))
    check("x3p_profile", "profile", x3p(line[None] * 1e-6), step=(1.5,))
    check("x3p_no_offset", "map", x3p(plane * 1e-6, edit=lambda xml: xml.replace("<Offset>0</Offset>", "<Offset/>")))
    check("x3p_no_increment", "map", x3p(plane * 1e-6, edit=lambda xml: xml.replace("<Increment>1.0</Increment>", "<Increment/>")))
    check("x3p_mac", "map", x3p(plane * 1e-6, mac=True))
    two = np.concatenate([plane, plane[::-1]])
    halved = lambda xml: xml.replace("<SizeY>80</SizeY><SizeZ>1", "<SizeY>40</SizeY><SizeZ>2")
    check("x3p_layers", "map", x3p(two * 1e-6, edit=halved), warns="of its 2 layers the first is read")
    absolute = lambda xml: xml.replace("<CX><AxisType>I", "<CX><AxisType>A").replace("<Increment>1.5e-06</Increment>", "", 1)
    check("x3p_positions", "profile", x3p(line[None] * 1e-6, inside=True, at=[0.5e-6 * i for i in range(500)], edit=absolute))
    refused("x3p_positions_in_binary", "profile", x3p(line[None] * 1e-6, edit=absolute), "a list of positions (AxisType A)")
    mask = np.ones(plane.shape, bool)
    mask[3, 5] = False
    refused("x3p_mask", "map", x3p(plane * 1e-6, valid=mask), "1 of 2560 points are bad or missing")
    refused("not_x3p", "map", b"PK\3\4" + bytes(40), "a zip that cannot be opened")

# ---- formats of instruments, by the first bytes of public files ----
for begins, words in ((b"\x88\x1b\x03\x6f", "of MetroPro; the free program Gwyddion"), (b"AliconaImaging\0\r\n", "of Alicona AL3D"),
                      (b"FRTM_GLIDERV1.00:", "of FRT"), (b"\\*File list\r\n", "Nanoscope"), (b"Binary TrueMap Data File v2.0\r\n", "TrueMap"),
                      (b"WSxM file copyright Nanotec\r\n", "WSxM"), (b"\1\0Directory\0", "Wyko"), (b"\x93NUMPY\1\0", "numpy.savetxt"),
                      (b"\x1f\x8b\x08", "gunzip"), (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "save a spreadsheet as CSV"),
                      (b"Fri Mar 10 16:35:59 2023", "Sensofar"), (b"VK4_", "Keyence"), (b"Zygo XYZ Data File - Format 1\n0 0 0\n", ": text of Zygo's XYZ; the free"), (b"DSCOMPRESSED", "compressed")):
    refused("binary", "map", begins.ljust(512, b"\0"), words)

# ---- tables of coefficients as papers print them: hard spheres of e 0.9, mu 0.2 ----
angles = np.arange(10.0, 90, 10)
tangents = 1 / np.tan(np.radians(angles))
along = np.maximum(1 - 0.2 * 1.9 / tangents, 5 / 7)
law = list(zip(angles, np.full(8, 0.9), along))


def fitted(name, content, warns="", numbers="fit=0.7 fit=0.3 0", truth=(0.9, 0.2), near=2e-3):
    """The table gives these numbers of the law, with that warning alone."""
    global ran
    ran += 1
    with open(name, "wb") as file:
        file.write(content if isinstance(content, bytes) else content.encode())
    done = subprocess.run([asperity, "calibrate", name, "rebound", "walton", *numbers.split(), "--speed", "3", "--dp", "2mm"],
                          capture_output=True, text=True, errors="replace")
    got = [float(value) for value in re.findall(r"^(?:e|mu),([^,]+)", done.stdout, re.M)]
    doubt = [text for text in done.stderr.splitlines() if "no two rows" not in text]
    if len(got) != len(truth) or not np.allclose(got, truth, rtol=near) or (warns not in done.stderr if warns else doubt):
        failed.append(f"{name}: {got}, expected {truth} '{warns}': {done.stderr[:300]}")


def rows(form, data=law):
    return "".join(form.format(a=a, n=n, t=t, r=np.radians(a)) for a, n, t in data)


refuses_fit = lambda name, content, words: fitted(name, content, words, truth=())
in_cells = "the second numbers in the cells of means are taken as standard deviations"
fitted("law", "alpha1_deg,e_n,e_t\n" + rows("{a},{n:.4f},{t:.4f}\n"))
fitted("sd_behind", "Table 3: glass\nImpact angle (deg);e_n;sd;e_t;sd;N\n" + rows("{a:.0f};{n:.4f};0.01;{t:.4f};0.01;80\n"))
fitted("standard_error", "Impact angle (deg)\te_n\tSEM\te_t\tSEM\n" + rows("{a:.0f}\t{n:.4f}\t0.01\t{t:.4f}\t0.01\n"))
german_names = "Auftreffwinkel (°);Mittelwert e_n;Standardabw. e_n;Mittelwert e_t;Standardabw. e_t;Anzahl\n"
fitted("german_table", comma(german_names + rows("{a:.0f};{n:.4f};0.01;{t:.4f};0.01;80\n")).encode("latin-1"))
for sign in ("±", "+/-", "+-"):
    fitted("plus_minus", "alpha (deg);e_n;e_t;N\n" + rows(f"{{a:.0f}};{{n:.4f}} {sign} 0.01;{{t:.4f}} {sign} 0.01;80\n"), in_cells)
fitted("plus_minus_commas", comma("alpha (deg);e_n;e_t;N\n" + rows("{a:.0f};{n:.4f}±0.01;{t:.4f}±0.01;80\n")), in_cells)
fitted("plus_minus_blanks", "alpha (deg)  e_n  e_t  N\n" + rows("{a:.0f} {n:.4f} ± 0.01 {t:.4f} ± 0.01 80\n"), in_cells)
fitted("brackets", "alpha (deg),e_n,e_t,N\n" + rows("{a:.0f},{n:.4f} (0.01),{t:.4f} (0.01),80\n"), in_cells)
fitted("last_digits", "alpha (deg),e_n,e_t,N\n" + rows("{a:.0f},{n:.4f}(100),{t:.4f}(100),80\n"), in_cells)
fitted("speed_and_e", "V_i (m/s),e\n" + "".join(f"{v},0.9\n" for v in (1, 2, 5, 10)), "along the normal", "fit=0.7 0.2 0", (0.9,))
slip = [tangent * (1 - 3.5 * (1 - t)) for tangent, t in zip(tangents, along)]
for head in ("Psi1,Psi2,e", "Ψ_1,Ψ_2,e_n"):
    fitted("psi", head + "\n" + "".join(f"{a:.4f},{b:.4f},0.9\n" for a, b in zip(tangents, slip)))
fitted("words_in_names", "Impact angle (deg)    normal    e_n      e_t\n".replace("normal    ", "") + rows("      {a:.0f}     {n:.4f}    {t:.4f}\n"))
fitted("groups", "alpha (deg);e_n;e_t\nGlass;;\n" + rows("{a};{n:.4f};{t:.4f}\n", law[:4]) + "Steel balls;;\n" + rows("{a};{n:.4f};{t:.4f}\n", law[4:]))
fitted("short_groups", "alpha (deg);e_n;e_t\nGlass;;\n" + rows("{a};{n:.4f};{t:.4f}\n", law[:1]) + "Steel balls;;\n" + rows("{a};{n:.4f};{t:.4f}\n", law[1:]))
fitted("units_in_cells", "alpha;V_i;e_n;e_t\n" + rows("{a} deg;3 m/s;{n:.4f};{t:.4f}\n"))
refuses_fit("units_of_no_angle", "alpha;e_n;e_t\n" + rows("{a} um;{n:.4f};{t:.4f}\n"), "the unit of column 'alpha' is not read")
fitted("not_measured", "alpha (deg),e_n,e_t\n" + rows("{a},{n:.4f},{t:.4f}\n").replace("0.9000,0.7143", "n.a.,0.7143", 1))
fitted("radians", "alpha1_rad,e_n,e_t\n" + rows("{r:.5f},{n:.4f},{t:.4f}\n"))
refuses_fit("bare_radians", "alpha1,e_n,e_t\n" + rows("{r:.5f},{n:.4f},{t:.4f}\n"), "name the column alpha1_rad or alpha1_deg")
refuses_fit("alike", "alpha1_deg,e_n,e_t\n" + rows("{a},0.9,0.8\n{a},0.9,0.8\n"), "do not scatter")

print(f"{ran} forms, {len(failed)} wrong")
print("\n".join(failed))
sys.exit(bool(failed))

# LAMMPS's versions are dates. asperity_date_number("4 Jul 2026" OUT) sets OUT to 20260704, as the
# function lammps_version() has them; asperity_lammps_version(DIR OUT) to that of a source tree.
# SPDX-License-Identifier: GPL-3.0-or-later
function(asperity_date_number date out)
  if(NOT date MATCHES "^([0-9]+) ([A-Z][a-z][a-z])[a-z]* ([0-9]+)$")
    message(FATAL_ERROR "'${date}' is no version of LAMMPS; it must be a date such as 4 Jul 2026")
  endif()
  set(day ${CMAKE_MATCH_1})
  set(year ${CMAKE_MATCH_3})
  string(FIND "JanFebMarAprMayJunJulAugSepOctNovDec" ${CMAKE_MATCH_2} month)
  math(EXPR number "${year} * 10000 + (${month} / 3 + 1) * 100 + ${day}")
  set(${out} ${number} PARENT_SCOPE)
endfunction()

function(asperity_lammps_version tree out)
  if(NOT EXISTS ${tree}/src/version.h OR NOT EXISTS ${tree}/src/lammpsplugin.h)
    message(FATAL_ERROR "ASPERITY_LAMMPS_SOURCE is '${tree}'; it must be the folder of a LAMMPS source "
      "tree of March 2021 or later (with src/version.h and src/lammpsplugin.h)")
  endif()
  file(STRINGS ${tree}/src/version.h line REGEX "define LAMMPS_VERSION ")
  string(REGEX REPLACE ".*\"([^\"]*)\".*" "\\1" date "${line}")
  asperity_date_number("${date}" number)
  set(${out} ${number} PARENT_SCOPE)
endfunction()

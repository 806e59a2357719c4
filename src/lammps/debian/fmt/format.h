/* Stands in for the copy of the fmt library that LAMMPS brings along, and that Debian's
 * liblammps-dev 20220106 leaves out, and later ones have: only the names that LAMMPS's headers use,
 * in the namespace of LAMMPS's copy. Nothing here is called: what needs a format goes through a
 * std::string.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef FMT_FORMAT_H_
#define FMT_FORMAT_H_

namespace fmt {
inline namespace v7_lmp {

template <typename Char> class basic_string_view;
typedef basic_string_view<char> string_view;
class format_args;
template <typename... Args, typename Format>
format_args make_args_checked(const Format &format, const Args &...args);

} // namespace v7_lmp
} // namespace fmt

#endif

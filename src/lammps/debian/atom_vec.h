/* Stands in for LAMMPS's atom_vec.h, which Debian's liblammps-dev leaves out: only what the fix
 * calls. Since 2022 it is virtual, but in no class of these packages another than here. Used only
 * where LAMMPS's own header is not there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LMP_ATOM_VEC_H
#define LMP_ATOM_VEC_H

namespace LAMMPS_NS {

class AtomVec {
public:
  void copy(int from, int to, int delflag);
};

} // namespace LAMMPS_NS

#endif

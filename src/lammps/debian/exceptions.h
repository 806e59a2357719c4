/* Stands in for LAMMPS's exceptions.h, which Debian's liblammps-dev 20220106 leaves out, and later
 * ones have: that LAMMPS ends the program and throws neither of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LMP_EXCEPTIONS_H
#define LMP_EXCEPTIONS_H

#include <mpi.h>

namespace LAMMPS_NS {

class LAMMPSException {};

class LAMMPSAbortException : public LAMMPSException {
public:
  MPI_Comm get_universe() const {
    return MPI_COMM_WORLD;
  }
};

} // namespace LAMMPS_NS

#endif

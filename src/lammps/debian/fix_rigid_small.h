/* Stands in for LAMMPS's fix_rigid_small.h, which Debian's liblammps-dev leaves out: the members of
 * its class, in the library's order, up to the last one that a wall needs. Used only where LAMMPS's
 * own header is not there; bodies_lammps.cpp compares values at the start of a run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LMP_FIX_RIGID_SMALL_H
#define LMP_FIX_RIGID_SMALL_H

#include "fix.h"

namespace LAMMPS_NS {

class FixRigidSmall : public Fix {
protected:
#if ASPERITY_LAMMPS_VERSION == 20210929
  int me, nprocs;

  struct Body {
    double mass, xcm[3], vcm[3], fcm[3], torque[3];
    double quat[4], inertia[3], ex_space[3], ey_space[3], ez_space[3];
    double angmom[3], omega[3], conjqm[4];
    imageint image;
    int remapflag[4], ilocal;
  };
#else /* 20240207 and 20250204 */
  struct Body {
    int natoms, ilocal;
    double mass, xcm[3], xgc[3], vcm[3], fcm[3], torque[3];
    double quat[4], inertia[3], ex_space[3], ey_space[3], ez_space[3];
    double xgc_body[3], angmom[3], omega[3], conjqm[4];
    int remapflag[4];
    imageint image, dummy;
  };
#endif

  double dtv, dtf, dtq, *step_respa;
  int triclinic;
  char *inpfile;
  int setupflag, earlyflag, commflag, customflag, nbody, nlinear;
  tagint maxmol;
  double maxextent;
  Body *body; /* of this rank, then of ghosts */
  int nlocal_body, nghost_body, nmax_body, bodysize;
  int *bodyown;       /* the body that a particle owns, or -1 */
  tagint *bodytag;    /* of the particle that owns a particle's body, or 0 */
  int *atom2body;     /* a particle's body, or -1 */
  imageint *xcmimage; /* of a particle, from its body's */
  double **displace;  /* of a particle, along its body's axes */
};

} // namespace LAMMPS_NS

#endif

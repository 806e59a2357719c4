/* What LAMMPS's src/STUBS/mpi.h, with which it is built without MPI, declares of what a wall could
 * use: these names and types, and no others. See lammps_tree.sh.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPI_STUBS
#define MPI_STUBS
#include <stdlib.h>

#define MPI_Comm int
#define MPI_Datatype int
#define MPI_Op int
#define MPI_Request int
typedef struct {
  int MPI_SOURCE;
} MPI_Status;

enum { MPI_COMM_WORLD, MPI_SUCCESS = 0, MPI_COMM_NULL = -1, MPI_UNDEFINED = -1 };
enum {
  MPI_INT = 1,
  MPI_FLOAT,
  MPI_DOUBLE,
  MPI_CHAR,
  MPI_BYTE,
  MPI_LONG,
  MPI_LONG_LONG,
  MPI_DOUBLE_INT
};
enum { MPI_SUM = 1, MPI_MAX, MPI_MIN, MPI_MAXLOC, MPI_MINLOC, MPI_LOR };
#define MPI_STATUS_IGNORE NULL
#define MPI_IN_PLACE NULL

extern "C" {
int MPI_Comm_rank(MPI_Comm, int *);
int MPI_Comm_size(MPI_Comm, int *);
int MPI_Comm_split(MPI_Comm, int, int, MPI_Comm *);
int MPI_Comm_free(MPI_Comm *);
int MPI_Barrier(MPI_Comm);
int MPI_Send(void *, int, MPI_Datatype, int, int, MPI_Comm);
int MPI_Recv(void *, int, MPI_Datatype, int, int, MPI_Comm, MPI_Status *);
int MPI_Bcast(void *, int, MPI_Datatype, int, MPI_Comm);
int MPI_Allreduce(void *, void *, int, MPI_Datatype, MPI_Op, MPI_Comm);
int MPI_Reduce(void *, void *, int, MPI_Datatype, MPI_Op, int, MPI_Comm);
int MPI_Allgather(void *, int, MPI_Datatype, void *, int, MPI_Datatype, MPI_Comm);
int MPI_Gather(void *, int, MPI_Datatype, void *, int, MPI_Datatype, int, MPI_Comm);
}
#endif

/* What OpenFOAM's lines name differently: OPENFOAM is the number of the interface of the ESI line,
 * 1912 or later, and of the Foundation's the version, 13.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "OStringStream.H"
#include "polyMesh.H"

namespace asperity {

#if OPENFOAM < 1000
static const char *const ENTRIES_OF_BASE[] = {"U"};
template <class P> Foam::vector position(const P &p, const Foam::polyMesh &mesh) {
  return p.position(mesh);
}
template <class P> bool is_active(const P &p) {
  return p.moving();
}
template <class P> void set_active(P &p, bool is_active) {
  p.moving() = is_active;
}
#else
static const char *const ENTRIES_OF_BASE[] = {"U", "writeToFile", "writePrecision", "useUserTime",
                                              "updateHeader"};
template <class P> Foam::vector position(const P &p, const Foam::polyMesh &) {
  return p.position();
}
template <class P> bool is_active(const P &p) {
  return p.active();
}
template <class P> void set_active(P &p, bool is_active) {
  p.active(is_active);
}
#endif

/* A model that reports at the end of a time step, on all ranks: to the log, and to a line of the
 * file of fates, which the Foundation's OpenFOAM does not have. */
template <class Model> class Reporting : public Model {
public:
  using Model::Model;
#if OPENFOAM >= 2212
  virtual void info() {
    Model::info();
    Foam::OStringStream unlogged;
    report(this->log ? static_cast<Foam::Ostream &>(Foam::Info.stream()) : unlogged, this->file());
  }
#else
  virtual void info(Foam::Ostream &log) {
    Model::info(log);
#if OPENFOAM >= 1000
    report(log, this->file());
#else
    Foam::OStringStream unwritten;
    report(log, unwritten);
#endif
  }
#endif

protected:
  virtual void report(Foam::Ostream &log, Foam::Ostream &fates) = 0;
  virtual void write_header(Foam::Ostream &fates) const = 0;
#if OPENFOAM >= 1000
  virtual void writeFileHeader(Foam::Ostream &fates) {
    Model::writeFileHeader(fates);
    write_header(fates);
  }
#endif
};

} // namespace asperity

/* A map as a file of VTK; see map_file.h. The format is that of "VTK File Formats" (Kitware).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "map_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "dem/error.h"
#include "dem/text.h"
#include "dem/wall.h"

using namespace asperity;

namespace {

bool ends_with(const std::string &path, const std::string &end) {
  return path.size() > end.size() && path.compare(path.size() - end.size(), end.size(), end) == 0;
}

/* The rows of numbers. */
class Rows {
public:
  Rows(FILE *file, const ContactTree *triangles, const Frame &frame,
       const std::vector<double> &sums, double worn_density)
      : file_(file), tree_(triangles), frame_(frame), sums_(sums), density_(worn_density),
        n_(static_cast<int>(aspi_tree_count(triangles))) {
    place_.resize(n_);
    for (int i = 0; i < n_; i++)
      place_[aspi_tree_id(tree_, i)] = i;
  }
  int count() const {
    return n_;
  }
  void points() const {
    for (int i = 0; i < n_; i++)
      for (int k = 0; k < 3; k++) {
        double x[3];
        frame_.to_world(aspi_tree_triangle(tree_, place_[i])->node[k], x);
        fprintf(file_, "%.9g %.9g %.9g\n", x[0], x[1], x[2]);
      }
  }
  void corners() const {
    for (int i = 0; i < n_; i++)
      fprintf(file_, "%d %d %d\n", 3 * i, 3 * i + 1, 3 * i + 2);
  }
  void whole(int first, int step) const {
    for (int i = 0; i < n_; i++)
      fprintf(file_, "%d\n", first + step * i);
  }
  /* The sums, and behind them the depth of erosion. */
  int arrays() const {
    return Books::N_SUMS + (density_ > 0);
  }
  const char *name(int k) const {
    return k < Books::N_SUMS ? Books::SUM_NAMES[k] : "erosion_depth";
  }
  void array(int k) const {
    for (int i = 0; i < n_; i++) {
      const double *sums = &sums_[static_cast<size_t>(i) * Books::N_SUMS];
      const ContactTriangle *triangle = aspi_tree_triangle(tree_, place_[i]);
      fprintf(file_, "%.9g\n",
              k < Books::N_SUMS
                  ? sums[k]
                  : sums[Books::SUM_ERODED] / (density_ * aspi_triangle_area(triangle)));
    }
  }

private:
  FILE *file_;
  const ContactTree *tree_;
  const Frame &frame_;
  const std::vector<double> &sums_;
  double density_;
  int n_;
  std::vector<int> place_; /* in the tree, of each number */
};

void write_map(FILE *file, double time, const Rows &rows) {
  const char array[] = "<DataArray type=\"%s\" Name=\"%s\" format=\"ascii\">\n",
             end[] = "</DataArray>\n";
  fprintf(file,
          "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\">\n<PolyData>\n"
          "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
          "format=\"ascii\">\n%.17g\n%s</FieldData>\n",
          time, end);
  fprintf(file,
          "<Piece NumberOfPoints=\"%d\" NumberOfPolys=\"%d\">\n<Points>\n"
          "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n",
          3 * rows.count(), rows.count());
  rows.points();
  fprintf(file, "%s</Points>\n<Polys>\n", end);
  fprintf(file, array, "Int32", "connectivity");
  rows.corners();
  fprintf(file, "%s", end);
  fprintf(file, array, "Int32", "offsets");
  rows.whole(3, 3);
  fprintf(file, "%s</Polys>\n<CellData>\n", end);
  fprintf(file, array, "Int32", "id");
  rows.whole(0, 1);
  fprintf(file, "%s", end);
  for (int k = 0; k < rows.arrays(); k++) {
    fprintf(file, array, "Float64", rows.name(k));
    rows.array(k);
    fprintf(file, "%s", end);
  }
  fprintf(file, "</CellData>\n</Piece>\n</PolyData>\n</VTKFile>\n");
}

} // namespace

void MapFile::parse(Words &words) {
  every_ = static_cast<int64_t>(words.whole("map", 1, 2147483647.0));
  path_ = words.word("the file of 'map'");
  if (!ends_with(path_, ".vtp"))
    throw Error("the file of 'map' is '" + path_ + "'; its name must end with .vtp");
}

void MapFile::write(MPI_Comm world, int64_t step, double time, const ContactTree *triangles,
                    const Frame &frame, const std::vector<double> &sums,
                    double worn_density) const {
  int rank, wrong = 0;
  std::string path = path_;
  const size_t star = path.find('*');
  if (star != std::string::npos)
    path.replace(star, 1, std::to_string(static_cast<long long>(step)));
  MPI_Comm_rank(world, &rank);
  if (rank == 0) {
    errno = 0;
    FILE *file = fopen(path.c_str(), "w");
    if (file) {
      write_map(file, time, Rows(file, triangles, frame, sums, worn_density));
      const bool failed = ferror(file) != 0;
      if (fclose(file) != 0 || failed)
        wrong = errno ? errno : EIO;
    } else
      wrong = errno;
  }
  MPI_Bcast(&wrong, 1, MPI_INT, 0, world);
  if (wrong)
    throw Error("the map file '" + path + "' cannot be written: " + strerror(wrong));
}

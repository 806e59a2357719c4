/* A map as a file of VTK; see map_file.h. The format is that of "VTK File Formats" (Kitware).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "map_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <functional>

#include "dem/error.h"
#include "dem/text.h"
#include "dem/wall.h"

using namespace asperity;

namespace {

/* worn_density, 0: no erosion, and no array of its depth. */
void write_map(FILE *file, double time, const ContactTree *tree, const Frame &frame,
               const std::vector<double> &sums, double worn_density) {
  const int n = static_cast<int>(aspi_tree_count(tree));
  std::vector<const ContactTriangle *> triangles(static_cast<size_t>(n));
  for (int place = 0; place < n; place++)
    triangles[static_cast<size_t>(aspi_tree_id(tree, place))] = aspi_tree_triangle(tree, place);
  const auto array = [&](const char *type, const char *name, const std::function<void(int)> &put) {
    fprintf(file, "<DataArray type=\"%s\" Name=\"%s\" format=\"ascii\">\n", type, name);
    for (int i = 0; i < n; i++)
      put(i);
    fputs("</DataArray>\n", file);
  };
  fprintf(file,
          "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\">\n<PolyData>\n"
          "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
          "format=\"ascii\">\n%.17g\n</DataArray>\n</FieldData>\n"
          "<Piece NumberOfPoints=\"%d\" NumberOfPolys=\"%d\">\n<Points>\n"
          "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n",
          time, 3 * n, n);
  for (const ContactTriangle *triangle : triangles)
    for (const double *node : triangle->node) {
      double x[3];
      frame.to_world(node, x);
      fprintf(file, "%.9g %.9g %.9g\n", x[0], x[1], x[2]);
    }
  fputs("</DataArray>\n</Points>\n<Polys>\n", file);
  array("Int32", "connectivity",
        [&](int i) { fprintf(file, "%d %d %d\n", 3 * i, 3 * i + 1, 3 * i + 2); });
  array("Int32", "offsets", [&](int i) { fprintf(file, "%d\n", 3 * (i + 1)); });
  fputs("</Polys>\n<CellData>\n", file);
  array("Int32", "id", [&](int i) { fprintf(file, "%d\n", i); });
  const double *of = sums.data();
  for (int k = 0; k < Books::N_SUMS; k++)
    array("Float64", Books::SUM_NAMES[k],
          [&](int i) { fprintf(file, "%.9g\n", of[Books::N_SUMS * i + k]); });
  if (worn_density > 0)
    array("Float64", "erosion_depth", [&](int i) {
      const double area = aspi_triangle_area(triangles[static_cast<size_t>(i)]);
      fprintf(file, "%.9g\n", of[Books::N_SUMS * i + Books::SUM_ERODED] / (worn_density * area));
    });
  fprintf(file, "</CellData>\n</Piece>\n</PolyData>\n</VTKFile>\n");
}

} // namespace

void MapFile::parse(Words &words) {
  every_ = static_cast<int64_t>(words.whole("map", 1, 2147483647.0));
  path_ = words.word("the file of 'map'");
  if (path_.size() < 5 || path_.compare(path_.size() - 4, 4, ".vtp") != 0)
    throw Error("the file of 'map' is '" + path_ + "'; its name must end with .vtp");
}

void MapFile::write(MPI_Comm world, int64_t step, double time, const ContactTree *triangles,
                    const Frame &frame, const std::vector<double> &sums,
                    double worn_density) const {
  int rank;
  std::string path = path_, wrong;
  const size_t star = path.find('*');
  if (star != std::string::npos)
    path.replace(star, 1, std::to_string(static_cast<long long>(step)));
  MPI_Comm_rank(world, &rank);
  if (rank == 0) {
    errno = 0;
    FILE *file = fopen(path.c_str(), "w");
    if (file)
      write_map(file, time, triangles, frame, sums, worn_density);
    const bool failed = !file || ferror(file) != 0;
    if ((file && fclose(file) != 0) || failed)
      wrong = strerror(errno ? errno : EIO);
  }
  wrong = share(wrong, world);
  if (!wrong.empty())
    throw Error("the map file '" + path + "' cannot be written: " + wrong);
}

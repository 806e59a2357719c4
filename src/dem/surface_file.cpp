/* A measured profile or map for all ranks; see surface_file.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surface_file.h"

#include <vector>

#include "dem/error.h"

using namespace asperity;

static void broadcast(MPI_Comm world, std::string &text) {
  int length = static_cast<int>(text.size());
  MPI_Bcast(&length, 1, MPI_INT, 0, world);
  text.resize(length);
  if (length > 0)
    MPI_Bcast(&text[0], length, MPI_CHAR, 0, world);
}

/* Reads what the first rank is to hand on, and what the reader found; an error is all ranks'. */
template <class Object, class Owner>
static void read_first(MPI_Comm world, const std::string &path, double metre,
                       Object *(*read)(asp_reader *, const char *, asp_error *), Owner &owner,
                       Reading &reading) {
  std::string wrong;
  asp_error error;
  int rank;
  MPI_Comm_rank(world, &rank);
  if (rank == 0) {
    std::unique_ptr<asp_reader, void (*)(asp_reader *)> reader(asp_reader_create(&error),
                                                               asp_reader_free);
    if (reader && !asp_reader_set(reader.get(), "metre", metre, &error))
      owner.reset(read(reader.get(), path.c_str(), &error));
    if (owner) {
      reading.report = asp_reader_text(reader.get());
      reading.doubts = asp_reader_check(reader.get(), &error) ? error.text : "";
      reading.doubts += asp_reader_advice(reading.doubts.c_str());
    } else
      wrong = std::string(error.text) + asp_reader_advice(error.text);
  }
  broadcast(world, wrong);
  if (!wrong.empty())
    throw Error(wrong);
  broadcast(world, reading.report);
  broadcast(world, reading.doubts);
}

Profile asperity::read_profile(MPI_Comm world, const std::string &path, double metre,
                               Reading &reading) {
  Profile profile(NULL, asp_profile_free);
  asp_error error;
  read_first(world, path, metre, asp_reader_read, profile, reading);

  double spacing = profile ? asp_profile_spacing(profile.get()) : 0;
  long long points = profile ? static_cast<long long>(asp_profile_points(profile.get())) : 0;
  MPI_Bcast(&spacing, 1, MPI_DOUBLE, 0, world);
  MPI_Bcast(&points, 1, MPI_LONG_LONG, 0, world);
  std::vector<double> heights(points);
  if (profile)
    heights.assign(asp_profile_heights(profile.get()), asp_profile_heights(profile.get()) + points);
  MPI_Bcast(heights.data(), static_cast<int>(points), MPI_DOUBLE, 0, world);
  if (!profile)
    profile.reset(asp_profile_from_heights(heights.data(), heights.size(), spacing, false, &error));
  if (!profile)
    throw_error(error);
  return profile;
}

Map asperity::read_map(MPI_Comm world, const std::string &path, double metre, Reading &reading) {
  Map map(NULL, asp_map_free);
  asp_error error;
  read_first(world, path, metre, asp_reader_read_map, map, reading);

  double step[2] = {map ? asp_map_step_x(map.get()) : 0, map ? asp_map_step_y(map.get()) : 0};
  long long side[2] = {map ? static_cast<long long>(asp_map_columns(map.get())) : 0,
                       map ? static_cast<long long>(asp_map_rows(map.get())) : 0};
  MPI_Bcast(step, 2, MPI_DOUBLE, 0, world);
  MPI_Bcast(side, 2, MPI_LONG_LONG, 0, world);
  std::vector<float> heights(side[0] * side[1]);
  if (map)
    heights.assign(asp_map_heights(map.get()), asp_map_heights(map.get()) + heights.size());
  for (long long row = 0; row < side[1]; row++)
    MPI_Bcast(&heights[row * side[0]], static_cast<int>(side[0]), MPI_FLOAT, 0, world);
  if (!map)
    map.reset(
        asp_map_from_heights(heights.data(), side[0], side[1], step[0], step[1], false, &error));
  if (!map)
    throw_error(error);
  return map;
}

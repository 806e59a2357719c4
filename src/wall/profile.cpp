/* A measured profile for all ranks; see profile.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "wall/profile.h"

#include <vector>

#include "wall/error.h"

using namespace asperity;

static void broadcast(MPI_Comm world, std::string &text) {
  int length = static_cast<int>(text.size());
  MPI_Bcast(&length, 1, MPI_INT, 0, world);
  text.resize(length);
  if (length > 0)
    MPI_Bcast(&text[0], length, MPI_CHAR, 0, world);
}

Profile asperity::read_profile(MPI_Comm world, const std::string &path, double metre,
                               std::string &report) {
  Profile profile(NULL, asp_profile_free);
  std::string wrong;
  asp_error error;
  int rank;
  MPI_Comm_rank(world, &rank);
  if (rank == 0) {
    std::unique_ptr<asp_reader, void (*)(asp_reader *)> reader(asp_reader_create(&error),
                                                               asp_reader_free);
    if (reader && !asp_reader_set(reader.get(), "metre", metre, &error))
      profile.reset(asp_reader_read(reader.get(), path.c_str(), &error));
    if (profile)
      report = asp_reader_text(reader.get());
    else
      wrong = error.text;
  }
  broadcast(world, wrong);
  if (!wrong.empty())
    throw Error(wrong);
  broadcast(world, report);

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
    throw Error(error.text);
  return profile;
}

/* The flights of a judge over one of its profiles or surfaces.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_ANALYSIS_JUDGE_FLIGHTS_H
#define ASP_ANALYSIS_JUDGE_FLIGHTS_H

#include "analysis/judge.h"

/* Adds the rebounds of group `number` at all angles, and its first hits to judge->first; called by
 * several threads. */
asp_code aspi_judge_fly_profile(aspi_judge *judge, const aspi_judge_case *subject,
                                const aspi_judge_walls *walls, const double *degrees, size_t number,
                                asp_error *error);

/* The same in three dimensions. */
asp_code aspi_judge_fly_surface(aspi_judge *judge, const aspi_judge_case *subject,
                                const double *degrees, size_t number, asp_error *error);

/* The half of a measured profile or map, cut across its longer side, that judges in fold 0 or 1;
 * NULL on error. */
asp_profile *aspi_judge_profile_half(const asp_profile *profile, size_t half, asp_error *error);
asp_map *aspi_judge_map_half(const asp_map *map, size_t half, asp_error *error);

/* The least angle (degrees) at which pieces of a profile can judge. */
asp_code aspi_judge_profile_angle_least(const aspi_judge_case *subject, double *degrees,
                                        asp_error *error);
double aspi_judge_map_angle_least(const aspi_judge_case *subject);

#endif

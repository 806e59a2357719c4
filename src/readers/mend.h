/* Repairs of raw heights, before they become a profile or a map; see mend.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_READERS_MEND_H
#define ASP_READERS_MEND_H

#include "readers/read.h"

/* Takes out the form, marks spikes, fills gaps or refuses them, filters, and writes what it did
 * into the report. */
asp_code aspi_mend(aspi_raw *raw, const char *path, const aspi_profile_options *options,
                   aspi_profile_report *report, asp_error *error);

#endif

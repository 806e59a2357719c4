/* Data that `asperity spread` hands to its picture.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_SPREAD_H
#define ASP_CLI_SPREAD_H

#include "cli/description.h"
#include "spread/models.h"

/* A histogram of n samples in degrees and, where the law is `shaped`, its density over it; the
 * title has the wall's numbers where it is `sized`, more than a sigma. */
void cli_spread_plot(const cli_option *option, const asp_spread_model *model, bool shaped,
                     const asp_wall *wall, bool sized, const aspi_view *view, const double *sample,
                     size_t n);

#endif

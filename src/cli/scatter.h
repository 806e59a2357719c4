/* Files of impacts, as `asperity cor`, a ledger or `dump local` of one writes them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_SCATTER_H
#define ASP_CLI_SCATTER_H

#include "analysis/impacts.h"

/* Exits on a file that is not one of these, and warns where angles look like radians. */
aspi_scatter_impacts cli_scatter_read_impacts(const char *path);
void cli_scatter_free_impacts(aspi_scatter_impacts *impacts);

#endif

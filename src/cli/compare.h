/* What `asperity compare` hands to its picture.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_COMPARE_H
#define ASP_CLI_COMPARE_H

#include "analysis/compare.h"
#include "cli/measured.h"
#include "cli/scatter.h"

void cli_compare_plot(const cli_option *option, const aspi_comparison *comparison);

#endif

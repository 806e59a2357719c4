/* asperity trade --three-d.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_TRADE_3D_H
#define ASP_CLI_TRADE_3D_H

#include "cli/judge_3d.h"
#include "cli/trade.h"

/* Measures every model on the wall, in three dimensions, at `angles` (degrees): rows of CSV to
 * `out`, and what the picture needs of them, angle by angle, into `rows`. */
void cli_trade_3d(FILE *out, const judge_case *subject, const cli_list *angles, size_t rays,
                  bool multiple, uint32_t seed, trade_row *rows);

#endif
